#pragma once
// The ray scope: a click in the picture chooses a light ray, and the panel shows what the light's map makes
// of it: transmittance, the metric, extinction over the metric, the coefficients, and what is wrong in words.
#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "renderer/truth/ray_probe.h"

namespace pileus::editor {

struct Editor;

struct RayScope {
  bool picking = false;        ///< a plain click in the picture picks
  std::optional<dvec3> point;  ///< what was picked, world
  std::size_t light = 0;       ///< among the lights with a shadow

  // What is shown, and what it was made for.
  std::optional<truth::RayProbe> probe;
  std::vector<truth::RayFlag> flags;
  std::string error;
  std::shared_ptr<const void> scene;
  std::optional<dvec3> probedPoint;
  std::size_t probedLight = 0;

  std::vector<char> muted;  ///< by coefficient
  // Made anew where `muted` changes.
  std::vector<double> mutedT;  ///< empty: nothing is muted
  truth::ExtinctionOverU overU;
};

/// What is seen at `uv` of the picture ([0,1]^2, y down): half of what the ray scatters to the eye comes from
/// in front of it; a solid where most of that shines through. Opens the panel.
void pickRay(Editor& editor, dvec2 uv);
/// The mark of the picked point over the picture.
void drawPickedRay(Editor& editor);
void drawRayScope(Editor& editor, ImVec2 min, ImVec2 max);

void togglePicking(Editor& editor);
void toggleScope(Editor& editor);

}  // namespace pileus::editor
