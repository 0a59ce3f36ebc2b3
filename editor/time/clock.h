#pragma once
// The current frame, what plays it, and the keys being edited. Never part of undo.
#include <cstdint>

#include "editor/time/timeline.h"

namespace pileus::editor {

struct Clock {
  int frame = 1;  ///< where keys are set and values shown
  PlayClock play;
  std::uint64_t answered = 0;  ///< of the preview, when last counted
  bool counting = false;       ///< since playing began
  KeyEditing keys;
};

}  // namespace pileus::editor
