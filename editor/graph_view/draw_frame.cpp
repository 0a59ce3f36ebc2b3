#include "editor/graph_view/draw_frame.h"

#include <algorithm>

#include "editor/editor.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/node_colors.h"

namespace pileus::editor {

ImU32 frameTint(const nodes::Frame& frame) {
  const ImU32 own = nodeColor(frame.color);
  return own ? own : palette::kMath;
}

void drawFrames(Editor& editor, const CanvasView& view) {
  const Theme& theme = editor.theme;
  const float header = view.px(frameHeader(view.level.zoom / theme.scale));
  const std::vector<nodes::Frame>& frames = shownGraph(editor).frames;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const nodes::Frame& frame = frames[i];
    const vec2 lo = glm::round(view.screen(vec2(frame.at))),
               hi = glm::round(view.screen(vec2(frame.at + frame.size)));
    if (!view.visible(lo, hi)) continue;
    const bool selected = editor.canvas.selectedFrame == i;
    const ImU32 tint = frameTint(frame);
    const float round = std::min(view.px(10), theme.px(14)), bar = std::min(header, hi.y - lo.y);
    view.draw->AddRectFilled(im(lo), im(hi), faded(tint, 0.16f), round);
    view.draw->AddRectFilled(im(lo), {hi.x, lo.y + bar}, faded(tint, 0.3f), round,
                             bar < hi.y - lo.y ? ImDrawFlags_RoundCornersTop : ImDrawFlags_RoundCornersAll);
    view.draw->AddRect(im(lo), im(hi), selected ? palette::kSelect : faded(tint, 0.7f), round, 0,
                       selected ? 2 * theme.scale : theme.scale);
    // As large as the canvas's text, but never too small to read; in the part that is on the screen.
    ImFont* font = view.level.strong && view.level.strong->FontSize > theme.strong->FontSize
                       ? view.level.strong
                       : theme.strong;
    const float left = std::max(lo.x, view.min.x) + theme.px(10);
    if (hi.x - left > theme.px(30) && bar >= font->FontSize * 0.9f)
      drawText(view.draw, font, {left, lo.y + 0.5f * (bar - font->FontSize)}, palette::kText, frame.title,
               hi.x - left - theme.px(8));
    if (editor.trace.on()) editor.trace.rect("frame/" + std::to_string(i), im(lo), im(hi));
  }
}

}  // namespace pileus::editor
