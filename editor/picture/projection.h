#pragma once
// A camera over a rectangle of the screen: where points of the world are seen, and which ray a pixel is.
#include <optional>
#include <utility>

#include "renderer/scene/camera.h"

namespace pileus::editor {

struct Ray {
  dvec3 origin{0}, direction{0, 0, -1};  ///< unit direction
};

class Projection {
 public:
  /// `min`, `max`: pixels of the picture.
  Projection(const scene::Camera& camera, vec2 min, vec2 max);

  vec2 min() const { return min_; }
  vec2 max() const { return max_; }
  const dvec3& eye() const { return eye_; }
  const dvec3& right() const { return axes_[0]; }
  const dvec3& up() const { return axes_[1]; }
  dvec3 forward() const { return -axes_[2]; }
  /// Along the view, from the eye; not above 0: behind it.
  double depth(const dvec3& point) const { return glm::dot(point - eye_, forward()); }
  /// Nothing where the point is behind the near plane.
  std::optional<vec2> screen(const dvec3& point) const;
  /// The part of a segment before the near plane.
  std::optional<std::pair<vec2, vec2>> segment(const dvec3& a, const dvec3& b) const;
  Ray ray(vec2 pixel) const;
  /// Metres that a pixel is at the depth of this point; 0 behind the camera.
  double metresPerPixel(const dvec3& point) const;
  bool contains(vec2 pixel) const;

 private:
  vec2 project(const dvec3& local) const;
  dvec3 local(const dvec3& point) const { return glm::transpose(axes_) * (point - eye_); }

  dvec3 eye_;
  glm::dmat3 axes_;  ///< right, up, back
  vec2 min_, max_;
  double half_ = 1;  ///< tan of half the vertical angle
  double near_ = 1e-3;
};

}  // namespace pileus::editor
