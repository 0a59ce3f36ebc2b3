#pragma once
// The canvas as it is on the screen this frame: the map between canvas units and pixels, and where to draw.
#include <imgui.h>

#include "editor/toolkit/theme.h"
#include "renderer/base/math.h"

namespace pileus::editor {

inline vec2 vec(ImVec2 v) { return {v.x, v.y}; }
inline ImVec2 im(vec2 v) { return {v.x, v.y}; }

struct CanvasView {
  vec2 min{0}, max{0};  ///< the panel, pixels
  vec2 origin{0};       ///< pixel of canvas (0, 0); whole, so that text stays sharp
  ZoomLevel level;
  ImDrawList* draw = nullptr;

  vec2 screen(vec2 canvas) const { return origin + canvas * level.zoom; }
  vec2 canvas(vec2 pixel) const { return (pixel - origin) / level.zoom; }
  float px(float units) const { return units * level.zoom; }
  bool visible(vec2 lo, vec2 hi) const {
    return hi.x >= min.x && lo.x <= max.x && hi.y >= min.y && lo.y <= max.y;
  }
};

/// Text at whole pixels, cut with an ellipsis beyond `width`. Returns the width drawn.
float drawText(ImDrawList* draw, ImFont* font, vec2 at, ImU32 color, std::string_view text, float width);
float textWidth(ImFont* font, std::string_view text);

}  // namespace pileus::editor
