#pragma once
// Light that has been scattered at least once, on the GPU: the solution on a lattice, as
// lib/scatter_field.glsl reads it. GL thread.
#include "renderer/gl/shader_library.h"
#include "renderer/gl/texture.h"
#include "renderer/transport/solve.h"

namespace pileus::view {

class ScatterField {
 public:
  /// `lightScale`: scaledLight() of the media it was made for. Error (Gpu) where the driver has no texture of
  /// that size.
  static Result<ScatterField> create(transport::Solution solution, const vec3& lightScale);
  /// To its unit, and its place into the program, whose positions count from `origin`.
  void bind(gl::Program& program, const dvec3& origin) const;
  /// Without the moments, which are on the GPU.
  const transport::Solution& solution() const { return solution_; }
  std::size_t bytes() const { return moments_.bytes(); }

 private:
  transport::Solution solution_;
  vec3 lightScale_{1};
  gl::Texture moments_;
};

}  // namespace pileus::view
