#pragma once
// A pinhole camera and the framing of bounds.
#include "renderer/base/math.h"

namespace pileus::scene {

struct Camera {
  dvec3 eye{0, 0, 5};
  dvec3 target{0};
  dvec3 up{0, 1, 0};
  double fov = 40;  ///< vertical, degrees

  bool operator==(const Camera&) const = default;
};

/// Columns right, up, back (world from camera); falls back to another up vector where `up` is parallel to the
/// view.
glm::dmat3 basis(const Camera& camera);

/// The direction (normalised) through image coordinates in [0,1]^2, y down.
dvec3 rayDirection(const Camera& camera, double aspect, dvec2 uv);

/// A three-quarter view from a little above that holds the whole box; unit box where it is empty.
Camera frameBounds(const Box3& bounds, double aspect, double fov = 40);
/// The same distance rule, keeping the direction and fov of `camera`.
Camera frameBounds(const Box3& bounds, double aspect, const Camera& camera);

}  // namespace pileus::scene
