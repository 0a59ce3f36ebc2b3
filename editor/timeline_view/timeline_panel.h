#pragma once
// The timeline: transport, range and speed above, a ruler, and rows with the keys of animated parameters.
#include <imgui.h>

namespace pileus::editor {

struct TimelineRoom;

void drawTimeline(const TimelineRoom& room, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
