#pragma once
// What the timeline panel remembers of how it is looked at.
#include "editor/time/timeline.h"
#include "editor/toolkit/pointer_rest.h"

namespace pileus::editor {

struct Timeline {
  enum class Drag { None, Keys, Box };

  FrameScale scale;
  bool fitted = false;  ///< the scale has been chosen for this document
  float scroll = 0;     ///< of the rows, pixels
  PointerRest rest;

  Drag drag = Drag::None;
  bool moved = false;  ///< the drag has left the place where it began
  double fromX = 0, fromY = 0;
  std::optional<nodes::Settings> settingsBefore;  ///< when a drag of a setting began
};

}  // namespace pileus::editor
