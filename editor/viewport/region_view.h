#pragma once
// The region in the picture: drawing it with a drag, its frame, and the rest dimmed.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Shown;
struct Ui;

/// Over the picture's rectangle; `hovered`: the pointer may begin a drag there.
void drawRegionView(Ui& ui, Shown& shown, vec2 lo, vec2 hi, bool hovered);
/// Leaves a drag or the waiting for one; true if there was any.
bool cancelRegion(Shown& shown);

}  // namespace pileus::editor
