#pragma once
// The viewport's toolbar: which output, display, view, exposure, resolution. Display, view and exposure edit
// the output node.
#include <imgui.h>

namespace pileus::editor {

struct ViewportRoom;

void drawViewportBar(const ViewportRoom& room, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
