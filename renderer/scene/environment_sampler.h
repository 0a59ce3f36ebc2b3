#pragma once
// Directions of an environment by importance, for a path tracer: one table of floats that C++ and GLSL read
// alike. Immutable; any thread.
#include <vector>

#include "renderer/scene/environment.h"

namespace pileus::scene {

struct EnvironmentSample {
  dvec3 direction{0, 1, 0};  ///< in the frame of the map
  double pdf = 0;            ///< [1/sr]
};

/// width x height cells of the sphere, those of a map of that size. `table` holds one after the other
///   height + 1            probability of all rows above row y
///   height (width + 1)    of row y: probability of all columns left of column x
///   height width          density of the cell (x, y) over directions [1/sr]
/// Probabilities begin with 0 and end with 1. What is read back of them, as floats, is what is sampled and
/// what pdf() says, so that the two agree to the bit. A black map is sampled evenly.
struct EnvironmentSampler {
  ivec2 size{0};
  std::vector<float> table;

  std::size_t columns() const { return std::size_t(size.y) + 1; }  ///< where the second part begins
  std::size_t densities() const { return columns() + std::size_t(size.y) * (std::size_t(size.x) + 1); }

  /// Even within a cell. a chooses the row, b the column; in [0, 1).
  EnvironmentSample sample(double a, double b) const;
  double pdf(const dvec3& direction) const;  ///< [1/sr]
};

/// Cells are those of the map reduced to `largest`.
EnvironmentSampler environmentSampler(const EnvironmentMap& map, ivec2 largest = {512, 256});

}  // namespace pileus::scene
