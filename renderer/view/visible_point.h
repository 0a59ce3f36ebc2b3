#pragma once
// What a pixel shows, as a point.
#include <optional>

#include "renderer/view/render_scene.h"

namespace pileus::view {

/// At `uv` of the picture ([0,1]^2, y down): the point in the media with half of what the camera ray scatters
/// in front of it, or where the ray ends on a solid of which more is seen than of the media. Nothing where
/// there is neither. On the CPU, level 0.
std::optional<dvec3> visiblePoint(const RenderScene& scene, dvec2 uv);
/// Where a world point is seen, in the same coordinates; nothing behind the camera.
std::optional<dvec2> pictureUv(const RenderOptions& options, const dvec3& point);

}  // namespace pileus::view
