#include "renderer/scene/solid.h"

#include <cmath>

namespace pileus::scene {

std::optional<SolidHit> intersect(const Solid& solid, const dvec3& o, const dvec3& d, double tMin) {
  const dmat4 localFromWorld = glm::inverse(solid.worldFromLocal);
  const dvec3 lo(localFromWorld * dvec4(o, 1.0)), ld(localFromWorld * dvec4(d, 0.0));
  double t = 0;
  int axis = 1;
  if (solid.shape == SolidShape::Plane) {
    if (ld.y == 0) return std::nullopt;
    t = -lo.y / ld.y;
    const dvec3 p = lo + t * ld;
    if (!(t > tMin) || std::abs(p.x) > 0.5 || std::abs(p.z) > 0.5) return std::nullopt;
  } else {
    const auto hit = intersectBox(lo, ld, dvec3(-0.5), dvec3(0.5));
    if (!hit) return std::nullopt;
    t = hit->x > tMin ? hit->x : hit->y;
    if (!(t > tMin)) return std::nullopt;
    const dvec3 p = glm::abs(lo + t * ld);
    axis = p.x > p.y && p.x > p.z ? 0 : p.y > p.z ? 1 : 2;
  }
  // Normals go with the inverse transpose: its columns are the rows of localFromWorld.
  dvec3 n = glm::normalize(dvec3(localFromWorld[0][axis], localFromWorld[1][axis], localFromWorld[2][axis]));
  if (glm::dot(n, d) > 0) n = -n;
  return SolidHit{t, n};
}

bool blocked(const SolidList& solids, const dvec3& a, const dvec3& b) {
  for (const Solid& s : solids)
    if (const auto hit = intersect(s, a, b - a, 0); hit && hit->t < 1) return true;
  return false;
}

Box3 worldBounds(const SolidList& solids) {
  Box3 box;
  for (const Solid& s : solids)
    for (int c = 0; c < 8; ++c) {
      const dvec3 corner(c & 1 ? 0.5 : -0.5,
                         s.shape == SolidShape::Plane ? 0.0
                         : c & 2                      ? 0.5
                                                      : -0.5,
                         c & 4 ? 0.5 : -0.5);
      box.extend(dvec3(s.worldFromLocal * dvec4(corner, 1.0)));
    }
  return box;
}

}  // namespace pileus::scene
