#pragma once
// The timeline: transport, range and speed above, a ruler, and rows with the keys of animated parameters.
#include <imgui.h>

namespace pileus::editor {

struct Editor;

void drawTimeline(Editor& editor, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
