#pragma once
// Notices in the lower right corner of the window: newest at the bottom, out of the way, gone by themselves.
#include <imgui.h>

namespace pileus::editor {

struct Editor;

/// Stacked upwards from `corner`.
void drawToasts(Editor& editor, ImVec2 corner);

}  // namespace pileus::editor
