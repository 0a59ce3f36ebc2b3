#pragma once
// The canvas as it is on the screen this frame: the map between canvas units and pixels, and where to draw.
#include <imgui.h>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "renderer/base/math.h"

namespace pileus::editor {

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

}  // namespace pileus::editor
