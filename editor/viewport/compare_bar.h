#pragma once
// The controls of the compare mode, a bar under the viewport's toolbar.
#include <imgui.h>

namespace pileus::editor {

struct Shown;
struct Ui;

void drawCompareBar(Ui& ui, Shown& shown, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
