#pragma once
// The line of a wipe: dragged with the pointer, drawn with a grip.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Editor;

struct WipeLine {
  double at = 0.5;  ///< of the picture's width
  bool held = false;
};

/// Follows the pointer while the grip is held; `hovered`: it may be taken.
void moveWipeLine(Editor& editor, WipeLine& line, vec2 lo, vec2 hi, bool hovered);
void drawWipeLine(Editor& editor, const WipeLine& line, vec2 lo, vec2 hi, const char* trace);

}  // namespace pileus::editor
