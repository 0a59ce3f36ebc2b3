#pragma once
// Opaque solids: what volumes throw shadows on and what throws shadows into volumes. Exact shapes, never
// tessellated. Plain values.
#include <optional>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::scene {

enum class SolidShape {
  Plane,  ///< local space: the square y = 0, |x| and |z| <= 0.5; both sides are solid
  Box,    ///< local space: the cube [-0.5, 0.5]^3
};

struct Solid {
  SolidShape shape = SolidShape::Box;
  dmat4 worldFromLocal{1.0};  ///< affine
  vec3 albedo{0.5f};          ///< Lambert; linear in the working space

  bool operator==(const Solid&) const = default;
};

using SolidList = std::vector<Solid>;

struct SolidHit {
  double t = 0;           ///< along the ray, in lengths of d
  dvec3 normal{0, 1, 0};  ///< unit, world, against the ray
};

/// The first hit of o + t d with t > tMin. Twin of hitSolid in lib/solid.glsl.
std::optional<SolidHit> intersect(const Solid& solid, const dvec3& o, const dvec3& d, double tMin = 0);
/// Is the open segment a..b blocked by any of them?
bool blocked(const SolidList& solids, const dvec3& a, const dvec3& b);
Box3 worldBounds(const SolidList& solids);

}  // namespace pileus::scene
