#pragma once
// The point of the picture whose light ray is looked at.
#include <optional>

#include "renderer/base/math.h"

namespace pileus::editor {

class Messages;
struct Settings;
struct Shown;

struct RayPick {
  bool picking = false;        ///< a plain click in the picture picks
  std::optional<dvec3> point;  ///< what was picked, world
};

/// What is seen at `uv` of the picture ([0,1]^2, y down): half of what the ray scatters to the eye comes from
/// in front of it; a solid where most of that shines through. Opens the ray scope.
void pickRay(Messages& messages, Shown& shown, Settings& settings, dvec2 uv);
void togglePicking(Messages& messages, Shown& shown, Settings& settings);

}  // namespace pileus::editor
