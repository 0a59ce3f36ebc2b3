#pragma once
// How passes begin that make a picture of a scene. GL thread.
#include "renderer/gl/region_cursor.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

/// A picture of that scene; where `seed` is of the same layer it begins with that, stretched, else it is
/// black.
Result<std::shared_ptr<Picture>> startPicture(std::shared_ptr<const RenderScene> scene, const Picture* seed);
/// Over the region that is asked for.
gl::RegionCursor startRegions(const RenderOptions& options, const gl::DeviceInfo& device);

}  // namespace pileus::view
