#include "editor/graph_view/draw_frame.h"

#include <algorithm>

#include "editor/graph_view/canvas.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/node_colors.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {

ImU32 frameTint(const nodes::Frame& frame) {
  const ImU32 own = nodeColor(frame.color);
  return own ? own : palette::kMath;
}

namespace {

/// As large as the canvas's text, but never too small to read; in the part that is on the screen.
void drawTitle(const Theme& theme, const CanvasView& view, const nodes::Frame& frame, vec2 lo, vec2 hi,
               float bar) {
  ImFont* font = view.level.strong && view.level.strong->FontSize > theme.strong->FontSize ? view.level.strong
                                                                                           : theme.strong;
  const float left = std::max(lo.x, view.min.x) + theme.px(10), room = hi.x - left - theme.px(8);
  if (room < theme.px(22) || bar < font->FontSize * 0.9f) return;
  const vec2 at(left, lo.y + 0.5f * (bar - font->FontSize));
  // Far away the title, which does not shrink any more, lies over nodes.
  if (!view.level.text && !frame.title.empty()) {
    const vec2 pad(theme.px(4), theme.px(1)),
        size(std::min(textWidth(font, frame.title), room), font->FontSize);
    view.draw->AddRectFilled(im(at - pad), im(at + size + pad),
                             mixed(palette::kCanvas, frameTint(frame), 0.35f), theme.px(3));
  }
  drawText(view.draw, font, at, palette::kText, frame.title, room);
}

}  // namespace

void drawFrames(Ui& ui, const Session& session, const Canvas& canvas, const CanvasView& view) {
  const Theme& theme = ui.theme;
  const float header = view.px(frameHeader(view.level.zoom / theme.scale));
  const std::vector<nodes::Frame>& frames = shownGraph(session, canvas).frames;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const nodes::Frame& frame = frames[i];
    const vec2 lo = glm::round(view.screen(vec2(frame.at))),
               hi = glm::round(view.screen(vec2(frame.at + frame.size)));
    if (!view.visible(lo, hi)) continue;
    const bool selected = canvas.selectedFrame == i;
    const ImU32 tint = frameTint(frame);
    const float round = std::min(view.px(10), theme.px(14)), bar = std::min(header, hi.y - lo.y);
    view.draw->AddRectFilled(im(lo), im(hi), faded(tint, 0.16f), round);
    view.draw->AddRectFilled(im(lo), {hi.x, lo.y + bar}, faded(tint, 0.3f), round,
                             bar < hi.y - lo.y ? ImDrawFlags_RoundCornersTop : ImDrawFlags_RoundCornersAll);
    view.draw->AddRect(im(lo), im(hi), selected ? palette::kSelect : faded(tint, 0.7f), round, 0,
                       selected ? 2 * theme.scale : theme.scale);
    if (view.level.text) drawTitle(theme, view, frame, lo, hi, bar);
    if (ui.trace.on()) ui.trace.rect("frame/" + std::to_string(i), im(lo), im(hi));
  }
}

void drawDistantTitles(const Theme& theme, const Session& session, const Canvas& canvas,
                       const CanvasView& view) {
  if (view.level.text) return;
  const float header = view.px(frameHeader(view.level.zoom / theme.scale));
  for (const nodes::Frame& frame : shownGraph(session, canvas).frames) {
    const vec2 lo = glm::round(view.screen(vec2(frame.at))),
               hi = glm::round(view.screen(vec2(frame.at + frame.size)));
    if (view.visible(lo, hi)) drawTitle(theme, view, frame, lo, hi, std::min(header, hi.y - lo.y));
  }
}

}  // namespace pileus::editor
