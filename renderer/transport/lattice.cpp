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

}  // namespace pileus::transport
