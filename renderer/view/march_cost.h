#pragma once
// What a camera march through a scene may cost.
#include <span>

#include "renderer/residency/march_budget.h"
#include "renderer/residency/tile_lists.h"
#include "renderer/view/light_set.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

/// `volumes` are drawn, `bounds` their pixels, `longest` the volumes of the fullest tile.
residency::MarchCost marchCost(const RenderOptions& options, std::span<const volume::Instance> volumes,
                               std::span<const residency::PixelBounds> bounds, int longest,
                               const LightSet& lights);

/// Of a place in the media of a scene that all lights are asked for (view/scatter_gather.h).
residency::MarchCost gatherCost(const LightSet& lights);

}  // namespace pileus::view
