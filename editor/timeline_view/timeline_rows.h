#pragma once
// The lower part of the timeline: the ruler with the playhead, and the rows of keys with their gestures.
#include <imgui.h>

namespace pileus::editor {

struct TimelineRoom;

void drawTimelineRows(const TimelineRoom& room, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
