#pragma once
// The controls of the compare mode, a bar under the viewport's toolbar.
#include <imgui.h>

namespace pileus::editor {

struct Editor;

void drawCompareBar(Editor& editor, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
