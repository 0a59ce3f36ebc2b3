#pragma once
// The line of a wipe: dragged with the pointer, drawn with a grip.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Theme;
struct Ui;
struct Viewport;
struct WipeLine;  // editor/picture/snapshots.h

/// Follows the pointer while the grip is held; `hovered`: it may be taken.
void moveWipeLine(const Theme& theme, const Viewport& viewport, WipeLine& line, vec2 lo, vec2 hi,
                  bool hovered);
void drawWipeLine(Ui& ui, const WipeLine& line, vec2 lo, vec2 hi, const char* trace);

}  // namespace pileus::editor
