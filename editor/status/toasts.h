#pragma once
// Notices in the lower right corner of the window: newest at the bottom, out of the way, gone by themselves.
#include <imgui.h>

namespace pileus::editor {

struct Ui;

/// Stacked upwards from `corner`.
void drawToasts(Ui& ui, ImVec2 corner);

}  // namespace pileus::editor
