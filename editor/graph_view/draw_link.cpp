#include "editor/graph_view/draw_link.h"

#include <algorithm>

#include "editor/toolkit/theme.h"

namespace pileus::editor {

bool linkEnds(const Layout& layout, const nodes::Link& link, vec2& from, vec2& to, nodes::SocketType& type) {
  const NodePlace* a = findPlace(layout, link.fromNode);
  const NodePlace* b = findPlace(layout, link.toNode);
  if (!a || !b) return false;
  const SocketPlace* out = findSocket(*a, link.fromSocket, false);
  const SocketPlace* in = findSocket(*b, link.toSocket, true);
  if (!out || !in) return false;
  from = out->at;
  to = in->at;
  type = out->type;
  return true;
}

namespace {

/// A curve as dashes: a link that is there, but carries nothing.
void drawDashes(const CanvasView& view, const vec2 (&p)[4], ImU32 ink, float width) {
  const float length = glm::length(p[3] - p[0]) + glm::length(p[1] - p[0]);
  const int count = std::clamp(static_cast<int>(length / (5 * width)), 4, 160);
  const auto at = [&](int i) {
    const float t = static_cast<float>(i) / static_cast<float>(2 * count), s = 1 - t;
    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
  };
  for (int i = 0; i < count; ++i) view.draw->AddLine(im(at(2 * i)), im(at(2 * i + 1)), ink, width);
}

}  // namespace

void drawLink(const Theme& theme, const CanvasView& view, vec2 from, vec2 to, ImU32 color,
              const LinkLook& look) {
  const Curve k = linkCurve(from, to);
  const vec2 p[4] = {view.screen(k.a), view.screen(k.b), view.screen(k.c), view.screen(k.d)};
  if (!view.visible(glm::min(glm::min(p[0], p[1]), glm::min(p[2], p[3])),
                    glm::max(glm::max(p[0], p[1]), glm::max(p[2], p[3]))))
    return;
  const bool strong = look.hovered || look.selected;
  const float width = std::clamp(view.px(2.2f), 1.1f * theme.scale, 4.5f * theme.scale);
  const float alpha = look.dimmed ? 0.2f : look.muted ? 0.45f : look.hovered ? 1.0f : 0.66f;
  const ImU32 ink = look.selected ? palette::kSelect : faded(color, alpha);
  if (view.level.zoom < 0.34f * theme.scale) {  // a curve would be smaller than it can be seen
    view.draw->AddLine(im(p[0]), im(p[3]), ink, strong ? 1.6f * width : width);
    return;
  }
  const auto curve = [&](ImU32 shade, float thickness) {
    view.draw->AddBezierCubic(im(p[0]), im(p[1]), im(p[2]), im(p[3]), shade, thickness);
  };
  if (strong) curve(faded(look.selected ? palette::kSelect : color, 0.2f), width * 4);
  if (look.muted && !look.selected) return drawDashes(view, p, ink, width);
  // An edge keeps crossing links apart, where they are wide enough to need it.
  if (view.level.text) curve(faded(palette::kCanvas, look.dimmed ? 0.2f : 0.8f), width + 2.5f * theme.scale);
  curve(ink, strong ? width * 1.35f : width);
}

}  // namespace pileus::editor
