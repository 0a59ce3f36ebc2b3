#include "renderer/transport/lattice.h"

#include <algorithm>

namespace pileus::transport {

Lattice latticeOver(const Box3& box, int most) {
  Lattice out;
  const dvec3 size = box.size();
  const double longest = std::max({size.x, size.y, size.z});
  if (box.empty() || !(longest > 0) || most < 1) return out;
  constexpr double kRoom = 1e-6;
  out.cell = longest * (1 + kRoom) / most;
  out.cells = glm::clamp(ivec3(glm::ceil(size / out.cell)), ivec3(1), ivec3(most));
  out.min = box.center() - 0.5 * out.cell * dvec3(out.cells);
  return out;
}

void markOpenFaces(Cells& all) {
  const ivec3 n = all.lattice.cells;
  const std::size_t strides[3] = {1, std::size_t(n.x), std::size_t(n.x) * std::size_t(n.y)};
  std::size_t i = 0;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x, ++i) {
        if (all.cells[i].extinction.w <= 0) continue;
        const ivec3 p(x, y, z);
        unsigned faces = 0;
        for (int a = 0; a < 3; ++a) {
          const bool low = p[a] > 0 && all.cells[i - strides[a]].extinction.w > 0,
                     high = p[a] + 1 < n[a] && all.cells[i + strides[a]].extinction.w > 0;
          faces |= unsigned(!low) << (2 * a) | unsigned(!high) << (2 * a + 1);
        }
        all.cells[i].glow.w = float(faces);
      }
}

void limitBackward(Cells& all) {
  constexpr float kMost = -0.5f;
  for (Cell& cell : all.cells) {
    if (cell.extinction.w > 0) continue;
    for (int c = 0; c < 3; ++c) {
      const float s = cell.scattering[c];
      if (cell.forward[c] >= kMost * s) continue;
      cell.scattering[c] = (s - cell.forward[c]) / (1 - kMost);
      cell.forward[c] = kMost * cell.scattering[c];
      cell.extinction[c] += cell.scattering[c] - s;
    }
  }
}

void thinDense(Cells& all) {
  const float most = float(kCellDepth / all.lattice.cell);
  for (Cell& c : all.cells) {
    const float deepest = std::max({c.extinction.x, c.extinction.y, c.extinction.z});
    if (c.extinction.w > 0 || deepest <= most) continue;
    const float by = most / deepest;
    c.extinction *= by, c.scattering *= by, c.forward *= by, c.glow *= by;
  }
}

}  // namespace pileus::transport
