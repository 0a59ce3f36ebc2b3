#pragma once
// What a shadow map holds, as small pictures: one false-coloured tile for each coefficient or interval end.
// GL thread.
#include "renderer/gl/texture.h"
#include "renderer/shadow/gpu.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::view {

/// Draws the map's tiles side by side into `into` (RGBA8, `tile` pixels high, made anew where its size
/// differs) and returns how many there are: 0 for a map without texels. Signed values go from blue through
/// grey to orange, each tile by its own largest; ends of intervals, from near to far, go from dark to light,
/// and where an interval is empty there is nothing. A deep map has two tiles: how many vertices each ray has,
/// and how much light comes through in all. A point light shows one of its six faces.
Result<int> drawMapThumbnail(const shadow::Gpu& gpu, const shadow::ShadowMap& map, int tile,
                             gl::Texture& into);
Result<int> drawMapThumbnail(const shadow::Gpu& gpu, const shadow::PseudometricMap& map, int tile,
                             gl::Texture& into);

}  // namespace pileus::view
