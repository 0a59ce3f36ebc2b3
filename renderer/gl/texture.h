#pragma once
// A GL texture with immutable storage, never without: one that the device cannot hold is an Error. Move-only;
// created and destroyed on the GL thread.
#include <epoxy/gl.h>

#include <string_view>

#include "renderer/base/math.h"
#include "renderer/base/result.h"

namespace pileus::gl {

class Texture {
 public:
  Texture() = default;
  /// target: GL_TEXTURE_1D, _2D, _2D_ARRAY or _3D; unused sizes are 1. Contents undefined. Error (Gpu) begins
  /// with the label: the driver's limit beside what was asked for, or that memory is out.
  static Result<Texture> create(GLenum target, GLenum internalFormat, ivec3 size, std::string_view label,
                                int mips = 1);
  ~Texture() { reset(); }
  Texture(Texture&& o) noexcept { swap(o); }
  Texture& operator=(Texture&& o) noexcept {
    if (this != &o) {
      reset();
      swap(o);
    }
    return *this;
  }

  /// The first mip of another texture by a compatible format, read by its own filter (nearest); keeps the
  /// texels alive with its owner gone. bytes() is 0.
  static Texture view(const Texture& of, GLenum internalFormat, std::string_view label);

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }
  ivec3 size() const { return size_; }
  GLenum format() const { return format_; }
  std::size_t bytes() const { return bytes_; }
  void filter(GLenum minMag) const;  ///< GL_NEAREST or GL_LINEAR
  void wrap(GLenum mode) const;      ///< all axes
  void clear(const vec4& value = vec4(0)) const;

 private:
  void reset();
  void swap(Texture& o) noexcept;
  GLuint id_ = 0;
  GLenum target_ = 0, format_ = 0;
  ivec3 size_{0};
  std::size_t bytes_ = 0;
};

/// Texels of the first mip, row by row, `channels` floats each, into `out`; read in strips of rows that take
/// at most `stripBytes`: the GL counts the bytes of a read in 32 bits. Waits for the GPU.
void readTexels(const Texture& texture, GLenum format, int channels, float* out,
                std::size_t stripBytes = std::size_t(1) << 28);

/// Bytes of one texel of the formats we use.
std::size_t texelBytes(GLenum internalFormat);

}  // namespace pileus::gl
