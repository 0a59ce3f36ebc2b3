#pragma once
// The ray scope: a click in the picture chooses a light ray, and the panel shows what the light's map makes
// of it: transmittance, the metric, extinction over the metric, the coefficients, and what is wrong in words.
#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "renderer/truth/ray_probe.h"

namespace pileus::editor {

struct Settings;
struct Shown;
struct Ui;

struct RayScope {
  std::size_t light = 0;  ///< among the lights with a shadow

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

void drawRayScope(Ui& ui, Shown& shown, Settings& settings, RayScope& scope, ImVec2 min, ImVec2 max);

void toggleScope(Shown& shown, Settings& settings);

}  // namespace pileus::editor
