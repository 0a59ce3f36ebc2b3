#pragma once
// Camera moves of the viewport, as pure functions of a camera and a drag.
#include "renderer/scene/camera.h"

namespace pileus::editor {

/// Turns the eye around the target; `drag` in radians (x: about the up axis, y: elevation, stopped short of
/// the poles).
scene::Camera orbited(const scene::Camera& camera, dvec2 drag);
/// Moves eye and target so that the target plane follows the pointer; `drag` in picture heights, y down.
scene::Camera panned(const scene::Camera& camera, dvec2 drag);
/// Brings the eye closer (factor < 1) or farther; the target stays.
scene::Camera dollied(const scene::Camera& camera, double factor);

}  // namespace pileus::editor
