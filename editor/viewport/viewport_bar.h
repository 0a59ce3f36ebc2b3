#pragma once
// The viewport's toolbar: which output, display, view, exposure, resolution. Display, view and exposure edit
// the output node.
#include <imgui.h>

#include "renderer/view/display.h"

namespace pileus::editor {

struct Editor;

/// As the shown output's parameters say.
view::DisplaySettings displaySettings(const Editor& editor);
void drawViewportBar(Editor& editor, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
