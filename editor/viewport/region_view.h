#pragma once
// The region in the picture: drawing it with a drag, its frame, and the rest dimmed.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Editor;

/// Over the picture's rectangle; `hovered`: the pointer may begin a drag there.
void drawRegionView(Editor& editor, vec2 lo, vec2 hi, bool hovered);
/// Leaves a drag or the waiting for one; true if there was any.
bool cancelRegion(Editor& editor);

}  // namespace pileus::editor
