#pragma once
// Light from everywhere as a small picture of all directions, to be shown through the display transform.
#include <span>

#include "renderer/gl/texture.h"
#include "renderer/scene/environment.h"
#include "renderer/scene/light.h"

namespace pileus::view {

/// Radiance by direction, azimuth 0 in the middle whichever way the environment is turned; at least as large
/// as `size`, which is twice as wide as high. Suns are discs a few texels wide that bring their irradiance.
/// Any thread.
scene::EnvironmentMap environmentPreview(const scene::Environment& environment,
                                         std::span<const scene::Light> suns, ivec2 size);
/// The same as RGBA32F, row 0 on top. GL thread.
Result<gl::Texture> environmentThumbnail(const scene::Environment& environment,
                                         std::span<const scene::Light> suns, ivec2 size);

}  // namespace pileus::view
