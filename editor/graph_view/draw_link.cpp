#include "editor/graph_view/draw_link.h"

#include <algorithm>

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

void drawLink(const Theme& theme, const CanvasView& view, vec2 from, vec2 to, ImU32 color,
              const LinkLook& look) {
  const Curve k = linkCurve(from, to);
  const vec2 a = view.screen(k.a), b = view.screen(k.b), c = view.screen(k.c), d = view.screen(k.d);
  if (!view.visible(glm::min(glm::min(a, b), glm::min(c, d)), glm::max(glm::max(a, b), glm::max(c, d))))
    return;
  const float width = std::clamp(view.px(2.6f), 1.2f * theme.scale, 5.0f * theme.scale);
  const ImU32 ink = look.selected ? palette::kSelect
                                  : faded(color, look.dimmed    ? 0.25f
                                                 : look.muted   ? 0.3f
                                                 : look.hovered ? 1.0f
                                                                : 0.82f);
  if (view.level.zoom < 0.3f * theme.scale) {  // a curve would be smaller than it can be seen
    view.draw->AddLine(im(a), im(d), ink, width);
    return;
  }
  view.draw->AddBezierCubic(im(a), im(b), im(c), im(d),
                            faded(palette::kNodeBorder, look.dimmed ? 0.2f : 0.7f), width + 2 * theme.scale);
  view.draw->AddBezierCubic(im(a), im(b), im(c), im(d), ink,
                            look.hovered || look.selected ? width * 1.35f : width);
}

}  // namespace pileus::editor
