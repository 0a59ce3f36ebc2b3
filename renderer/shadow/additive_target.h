#pragma once
// Frame buffer, viewport and blending for additive drawing into layers of a map; puts back what it found. GL
// thread.
#include <epoxy/gl.h>

#include "renderer/base/math.h"

namespace pileus::shadow {

class AdditiveTarget {
 public:
  AdditiveTarget();
  ~AdditiveTarget();
  AdditiveTarget(const AdditiveTarget&) = delete;
  AdditiveTarget& operator=(const AdditiveTarget&) = delete;

  /// `layers` (at most 8) consecutive layers from `first`; viewport and scissor a square of `edge` texels at
  /// `origin`.
  void attach(GLuint texture, int first, int layers, ivec2 origin, int edge, bool clear);
  GLuint framebuffer() const { return framebuffer_; }

 private:
  GLuint framebuffer_ = 0, vertices_ = 0;
  GLint viewport_[4], scissor_[4], bound_ = 0, boundVertices_ = 0;
  GLint equations_[2], factors_[4];
  bool enabled_[5];
};

}  // namespace pileus::shadow
