#pragma once
// A GL buffer that grows by doubling. Move-only; GL thread.
#include <epoxy/gl.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "renderer/base/result.h"

namespace pileus::gl {

class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(std::string_view label) : label_(label) {}
  ~Buffer() { reset(); }
  Buffer(Buffer&& o) noexcept
      : label_(std::move(o.label_)),
        id_(std::exchange(o.id_, 0)),
        capacity_(std::exchange(o.capacity_, 0)),
        texels_(std::exchange(o.texels_, 0)) {}
  Buffer& operator=(Buffer&& o) noexcept {
    if (this != &o) {
      reset();
      label_ = std::move(o.label_);
      id_ = std::exchange(o.id_, 0);
      capacity_ = std::exchange(o.capacity_, 0);
      texels_ = std::exchange(o.texels_, 0);
    }
    return *this;
  }

  /// Replaces the content; storage is reused while it is large enough. An empty span still leaves a bindable
  /// buffer. Error (Gpu) where memory is out: the buffer is empty then.
  Result<void> assign(const void* data, std::size_t bytes);
  template <class T>
  Result<void> assign(std::span<const T> data) {
    return assign(data.data(), data.size_bytes());
  }
  /// At least `bytes` of storage, content undefined. Errors as assign().
  Result<void> reserve(std::size_t bytes);
  void bindStorage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id_); }
  void bindUniform(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, id_); }
  /// As a buffer texture of that format (always the same one for a buffer).
  void bindTexels(GLuint unit, GLenum format) const;
  GLuint id() const { return id_; }
  std::size_t capacity() const { return capacity_; }

 private:
  void reset();
  std::string label_;
  GLuint id_ = 0;
  std::size_t capacity_ = 0;
  mutable GLuint texels_ = 0;  ///< made when first bound
};

}  // namespace pileus::gl
