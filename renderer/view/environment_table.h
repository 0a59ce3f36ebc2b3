#pragma once
// Light from everywhere on the GPU: as path tracers choose from it, and as cameras see it. GL thread.
#include "renderer/gl/buffer.h"
#include "renderer/gl/shader_library.h"
#include "renderer/gl/texture.h"
#include "renderer/scene/environment.h"

namespace pileus::view {

/// Directions by radiance, which is constant in each texel. Twin of lib/environment.glsl.
class EnvironmentTable {
 public:
  Result<void> make(const scene::Environment& environment);
  /// To its binding point, with the uniforms of lib/environment.glsl.
  void bind(gl::Program& program) const;
  bool empty() const { return size_.x == 0; }
  /// Of its luminance over directions: 0 where it is the same from everywhere, so that any direction serves,
  /// towards 1 the smaller the part of them is that its light comes from.
  double contrast() const { return contrast_; }

 private:
  gl::Buffer texels_{"environment"};
  ivec2 size_{0};
  double turn_ = 0, power_ = 0, contrast_ = 0;
};

/// Twin of lib/backdrop.glsl: the map as it is, filtered.
class Backdrop {
 public:
  Result<void> make(const scene::Environment& environment);
  void bind(gl::Program& program) const;
  bool empty() const { return !map_; }

 private:
  gl::Texture map_;
  double turn_ = 0;
  vec3 scale_{1};
};

}  // namespace pileus::view
