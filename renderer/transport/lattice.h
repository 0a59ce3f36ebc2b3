#pragma once
// What the transport of scattered light is solved on: cubic cells around the media, and what each holds.
#include <vector>

#include "renderer/base/math.h"

namespace pileus::transport {

/// Cubic cells, world axis-aligned; x fastest, then y.
struct Lattice {
  dvec3 min{0};
  double cell = 1;  ///< edge [m]
  ivec3 cells{0};

  std::size_t count() const { return std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z); }
  bool operator==(const Lattice&) const = default;
};

/// `most` cells along the longest edge of the box, the others as many as it takes to hold it, all around it a
/// hair of room; no cells for an empty box.
Lattice latticeOver(const Box3& box, int most);

/// Means over a cell, channel by channel; with the scaled phase function of scene::scaledPhase(). A record of
/// the GPU's: shaders/view/scatter_gather.comp.glsl writes it.
struct Cell {
  /// xyz: sum over the lights of first.w times the direction in which it travels, weighted by the scaled mean
  /// cosine; w: what of their light is scattered for the first time [W/m^3].
  vec4 first[3];
  vec4 extinction{0};  ///< scaled sigma_t [1/m]; w: 1 where the cell is in a solid
  vec4 scattering{0};  ///< scaled sigma_s [1/m]; of a solid its albedo
  vec4 forward{0};     ///< scaled sigma_s times the scaled mean cosine; of a solid what it sends back of the
                       ///< lights, per open face [W/m^2]
  vec4 glow{0};        ///< emitted radiance per metre [W/(m^3 sr)]
};
static_assert(sizeof(Cell) == 7 * sizeof(vec4));

struct Cells {
  Lattice lattice;
  std::vector<Cell> cells;
};

/// Of light that has been scattered at least once: in texel [channel][z][y][x] w is the integral of its
/// radiance over all directions, xyz that of radiance times the direction in which it travels [W/m^2].
using Moments = std::vector<vec4>;

}  // namespace pileus::transport
