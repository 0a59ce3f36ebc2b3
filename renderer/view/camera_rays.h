#pragma once
// What passes that march camera rays share: where a volume may be seen, and the rays' uniforms.
#include <span>
#include <vector>

#include "renderer/gl/shader_library.h"
#include "renderer/residency/tile_lists.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

/// Pixels each instance may touch; the whole picture where a corner is beside or behind the eye.
std::vector<residency::PixelBounds> pixelBounds(std::span<const volume::Instance> instances,
                                                const RenderOptions& options);
/// Uniforms size, eye, right, up, back, pixelAngle, stepScale. GL thread.
void setCameraRays(gl::Program& program, const RenderOptions& options);

}  // namespace pileus::view
