#pragma once
// Vectors (glm), boxes, affine placements and ray-shape intersections. Metres, Y up, right-handed.
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <limits>
#include <optional>

namespace pileus {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr double kPi = 3.14159265358979323846;

/// An axis-aligned box; default-constructed it is empty.
struct Box3 {
  dvec3 min{std::numeric_limits<double>::infinity()};
  dvec3 max{-std::numeric_limits<double>::infinity()};

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  dvec3 center() const { return 0.5 * (min + max); }
  dvec3 size() const { return empty() ? dvec3(0.0) : max - min; }
  void extend(const dvec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void extend(const Box3& b) {
    if (b.empty()) return;
    extend(b.min);
    extend(b.max);
  }
  /// Corner i of 8: bit 0 chooses x, bit 1 y, bit 2 z.
  dvec3 corner(int i) const { return {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z}; }
};

/// Bounds of a box after an affine map.
inline Box3 transformed(const Box3& box, const dmat4& m) {
  Box3 out;
  if (box.empty()) return out;
  for (int i = 0; i < 8; ++i) out.extend(dvec3(m * dvec4(box.corner(i), 1.0)));
  return out;
}

/// T Rz Ry Rx S about the origin; degrees.
inline dmat4 composeTransform(const dvec3& translate, const dvec3& rotateDegrees, const dvec3& scale) {
  dmat4 m = glm::translate(dmat4(1.0), translate);
  m = glm::rotate(m, glm::radians(rotateDegrees.z), dvec3(0, 0, 1));
  m = glm::rotate(m, glm::radians(rotateDegrees.y), dvec3(0, 1, 0));
  m = glm::rotate(m, glm::radians(rotateDegrees.x), dvec3(1, 0, 0));
  return glm::scale(m, scale);
}

/// The part [x, y] of the line o + t d inside the box (slab test), or nothing. Twin of intersectBox in
/// lib/intersect.glsl.
inline std::optional<dvec2> intersectBox(const dvec3& o, const dvec3& d, const dvec3& lo, const dvec3& hi) {
  double t0 = -std::numeric_limits<double>::infinity(), t1 = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a) {
    if (d[a] == 0.0) {
      if (o[a] < lo[a] || o[a] > hi[a]) return std::nullopt;
      continue;
    }
    double ta = (lo[a] - o[a]) / d[a], tb = (hi[a] - o[a]) / d[a];
    if (ta > tb) std::swap(ta, tb);
    t0 = std::max(t0, ta);
    t1 = std::min(t1, tb);
  }
  if (!(t0 < t1)) return std::nullopt;
  return dvec2(t0, t1);
}

/// The part of the line o + t d inside the unit ball |p| <= 1, or nothing. Twin of intersectBall in
/// lib/intersect.glsl.
inline std::optional<dvec2> intersectBall(const dvec3& o, const dvec3& d) {
  const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1.0;
  const double q = b * b - a * c;
  if (!(q > 0.0)) return std::nullopt;
  const double s = std::sqrt(q);
  return dvec2((-b - s) / a, (-b + s) / a);
}

}  // namespace pileus
