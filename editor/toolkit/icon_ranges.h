#pragma once
// Which icons the fonts of the interface hold.
#include <imgui.h>

namespace pileus::editor {

/// Pairs of the first and the last one, ended by 0.
const ImWchar* iconRanges();

}  // namespace pileus::editor
