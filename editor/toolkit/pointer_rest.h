#pragma once
// How long the pointer has rested over a panel: help appears then.
#include <imgui.h>

namespace pileus::editor {

struct PointerRest {
  ImVec2 at{-1, -1};
  double since = 0;
  bool short_ = false, long_ = false;  ///< long enough for labels; for what can be dragged
  bool inside = false;                 ///< the pointer is over the panel
};

/// Once a frame, with the panel's corners.
void updateRest(PointerRest& rest, ImVec2 min, ImVec2 max);
/// Seconds until help is due under a resting pointer; 0 = none is.
double helpDueIn(const PointerRest& rest);

}  // namespace pileus::editor
