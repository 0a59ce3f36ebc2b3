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
  /// cosine; w: what of their light is scattered for the first time [W/m^3]. Of a solid: sentOf().
  vec4 first[3];
  vec4 extinction{0};  ///< scaled sigma_t [1/m]; w: 1 where the cell is in a solid
  vec4 scattering{0};  ///< scaled sigma_s [1/m]; of a solid its albedo
  vec4 forward{0};     ///< scaled sigma_s times the scaled mean cosine; of a solid: sentOf()
  vec4 glow{0};        ///< emitted radiance per metre [W/(m^3 sr)]; of a solid: sentOf(), and in w its open
                       ///< faces as bits
};
static_assert(sizeof(Cell) == 7 * sizeof(vec4));

/// Faces of a cell: 2 a of axis a towards smaller places, 2 a + 1 towards larger ones.
inline constexpr int kFaces = 6;
/// What a face of a solid cell sends back of the lights [W/m^2].
inline float& sentOf(Cell& cell, int face, int channel) {
  return face < 4 ? cell.first[channel][face] : face == 4 ? cell.forward[channel] : cell.glow[channel];
}
inline float sentOf(const Cell& cell, int face, int channel) {
  return sentOf(const_cast<Cell&>(cell), face, channel);
}
/// Is there no solid cell behind it?
inline bool isOpen(const Cell& cell, int face) { return (unsigned(cell.glow.w) >> face & 1) != 0; }

struct Cells {
  Lattice lattice;
  std::vector<Cell> cells;
};

/// Marks the open faces of solid cells (extinction.w).
void markOpenFaces(Cells& cells);

/// Media that scatter further back than linear phase functions can say (mean cosine below -1/2) get a similar
/// one: as much absorption and transport extinction, the cosine -1/2.
void limitBackward(Cells& cells);

/// Optical depth over a cell of what is as dense as lattices can tell.
inline constexpr double kCellDepth = 2;
/// Media of more than that per cell become so deep, with the same albedo, mean
/// cosine and, where they emit, the same radiance: what is dense sends back the same however dense it is, and
/// its skin, in which that is decided, is then as wide as cells can tell.
void thinDense(Cells& cells);

/// Of light that has been scattered at least once: in texel [channel][z][y][x] w is the integral of its
/// radiance over all directions, xyz that of radiance times the direction in which it travels [W/m^2].
using Moments = std::vector<vec4>;

}  // namespace pileus::transport
