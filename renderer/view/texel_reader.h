#pragma once
// Texels of a picture on the CPU without waiting for the GPU: asked for now, there a frame or two later. GL
// thread.
#include <epoxy/gl.h>

#include <optional>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/texture.h"

namespace pileus::view {

class TexelReader {
 public:
  TexelReader() = default;
  ~TexelReader() { forget(); }
  TexelReader(const TexelReader&) = delete;
  TexelReader& operator=(const TexelReader&) = delete;

  /// A part of an RGBA32F texture; replaces what was asked before.
  void request(const gl::Texture& texture, ivec2 lo, ivec2 size);
  bool busy() const { return fence_ != nullptr; }
  /// Row by row, once they are there; nothing while they are on their way or nothing was asked for.
  std::optional<std::vector<vec4>> take();
  void forget();

 private:
  gl::Buffer buffer_{"texels on their way"};
  GLsync fence_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace pileus::view
