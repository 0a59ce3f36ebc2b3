#pragma once
// Text at a place of the screen, and ImGui's vectors as ours.
#include <imgui.h>

#include <string>
#include <string_view>

#include "renderer/base/math.h"

namespace pileus::editor {

inline vec2 vec(ImVec2 v) { return {v.x, v.y}; }
inline ImVec2 im(vec2 v) { return {v.x, v.y}; }

/// Text at whole pixels, cut with an ellipsis beyond `width`. Returns the width drawn.
float drawText(ImDrawList* draw, ImFont* font, vec2 at, ImU32 color, std::string_view text, float width);
float textWidth(ImFont* font, std::string_view text);
/// The path, or where that is too wide an ellipsis and its end: it says more than the beginning.
std::string endOfPath(ImFont* font, const std::string& path, float width);

}  // namespace pileus::editor
