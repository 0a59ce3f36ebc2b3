#include "editor/picture/projection.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {

Projection::Projection(const scene::Camera& camera, vec2 min, vec2 max)
    : eye_(camera.eye), axes_(scene::basis(camera)), min_(min), max_(glm::max(max, min + 1.0f)) {
  half_ = std::tan(0.5 * glm::radians(std::clamp(camera.fov, 0.1, 170.0)));
  near_ = std::max(1e-4 * glm::length(camera.eye - camera.target), 1e-9);
}

vec2 Projection::project(const dvec3& p) const {
  const dvec2 size(max_ - min_);
  const double scale = 0.5 * size.y / half_ / -p.z;
  return vec2(dvec2(min_) + 0.5 * size + scale * dvec2(p.x, -p.y));
}

std::optional<vec2> Projection::screen(const dvec3& point) const {
  const dvec3 p = local(point);
  if (!(-p.z > near_)) return std::nullopt;
  return project(p);
}

std::optional<std::pair<vec2, vec2>> Projection::segment(const dvec3& from, const dvec3& to) const {
  dvec3 a = local(from), b = local(to);
  const bool aIn = -a.z > near_, bIn = -b.z > near_;
  if (!aIn && !bIn) return std::nullopt;
  if (aIn != bIn) {
    // Where it crosses the near plane takes the place of the end behind it.
    const dvec3 crossing = glm::mix(a, b, (-near_ - a.z) / (b.z - a.z));
    (aIn ? b : a) = dvec3(crossing.x, crossing.y, -near_);
  }
  return std::pair(project(a), project(b));
}

Ray Projection::ray(vec2 pixel) const {
  const dvec2 size(max_ - min_);
  const dvec2 at = (dvec2(pixel - min_) - 0.5 * size) * (2 * half_ / size.y);
  return {eye_, glm::normalize(axes_ * dvec3(at.x, -at.y, -1))};
}

double Projection::metresPerPixel(const dvec3& point) const {
  const double d = depth(point);
  return d > near_ ? 2 * d * half_ / static_cast<double>(max_.y - min_.y) : 0;
}

bool Projection::contains(vec2 pixel) const {
  return glm::all(glm::greaterThanEqual(pixel, min_)) && glm::all(glm::lessThan(pixel, max_));
}

}  // namespace pileus::editor
