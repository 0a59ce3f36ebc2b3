#pragma once
// The status line: the last message, what the picture is, and where the time went.
#include <imgui.h>

namespace pileus::editor {

struct StatusRoom;

void drawStatusLine(const StatusRoom& room, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
