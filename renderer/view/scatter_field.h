#pragma once
// Light that has been scattered at least once, on the GPU: the solutions on lattices, as
// lib/scatter_field.glsl reads it. GL thread.
#include <vector>

#include "renderer/gl/shader_library.h"
#include "renderer/gl/texture.h"
#include "renderer/transport/solve.h"

namespace pileus::view {

class ScatterField {
 public:
  /// Error (Gpu) where the driver has no texture of that size.
  static Result<ScatterField> create(std::vector<transport::Solution> solutions);
  /// To its unit, and its place into the program, whose positions count from `origin`.
  void bind(gl::Program& program, const dvec3& origin) const;
  /// The first one around all, the others within it; without the moments, which are on the GPU. May be none.
  const std::vector<transport::Solution>& solutions() const { return solutions_; }
  std::size_t bytes() const { return moments_.bytes(); }

 private:
  std::vector<transport::Solution> solutions_;
  gl::Texture moments_;
};

}  // namespace pileus::view
