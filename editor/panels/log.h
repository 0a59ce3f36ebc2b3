#pragma once
// The log panel: the last lines of the log, newest at the bottom.
#include <imgui.h>

namespace pileus::editor {

struct Editor;

void drawLog(Editor& editor, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
