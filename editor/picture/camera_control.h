#pragma once
// Camera moves of the viewport, as pure functions of a camera and a drag.
#include "renderer/scene/camera.h"

namespace pileus::editor {

/// Turns the eye around the target; `drag` in radians (x: about the up axis, y: elevation, stopped short of
/// the poles).
scene::Camera orbited(const scene::Camera& camera, dvec2 drag);
/// The same about any point: eye and target turn together, so that the point stays where it is in the
/// picture, and the horizon stays level.
scene::Camera orbitedAbout(const scene::Camera& camera, const dvec3& pivot, dvec2 drag);
/// Moves eye and target so that the target plane follows the pointer; `drag` in picture heights, y down.
scene::Camera panned(const scene::Camera& camera, dvec2 drag);
/// Brings the eye closer (factor < 1) or farther; the target stays.
scene::Camera dollied(const scene::Camera& camera, double factor);
/// Brings eye and target closer to a point, or farther: what is seen there stays in its place.
scene::Camera dolliedTo(const scene::Camera& camera, const dvec3& point, double factor);
/// Looks at the same target from another direction, from the same distance; `towardsEye` unit. Straight up
/// and down stop just short of the pole, so that `up` still says which way is up.
scene::Camera seenFrom(const scene::Camera& camera, const dvec3& towardsEye);

}  // namespace pileus::editor
