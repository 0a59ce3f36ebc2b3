#pragma once
// The light that new scenes begin with: a sky, its sun, and a shadow for each of them. Pure: no window, no
// GPU.
#include <span>
#include <string>

#include "nodes/graph/graph.h"

namespace pileus::editor {

class SceneBuilder;

/// Texels of shadow maps for light from everywhere: what each of its directions stands for is wide.
inline constexpr int kWideLightTexels = 128;

/// A Sky that lights `render`: its sun through maps as large as they begin with, its sky through maps of its
/// own of kWideLightTexels. `azimuth` of the sun, degrees; `at`: column and row of the Sky, which takes three
/// columns.
void addDaylight(SceneBuilder& build, std::span<const std::string> media, double azimuth, const dvec2& at,
                 const std::string& render);
/// What a new document holds: a render under a sky that is ready for volumes, and a view of it.
Result<nodes::Graph> newScene();

}  // namespace pileus::editor
