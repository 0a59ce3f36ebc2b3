#include "editor/graph_view/draw_sockets.h"

#include <algorithm>

#include "editor/toolkit/theme.h"

namespace pileus::editor {
namespace {

struct SocketInk {
  ImU32 fill, edge;
};

/// One link: a dot. Many: an upright pill. Of a type nobody knows, or any: a diamond.
void drawShape(ImDrawList* draw, const SocketPlace& s, vec2 at, float r, SocketInk ink, float edge) {
  if (s.input && s.many) {
    const vec2 half = {r * 0.82f, r * 1.6f};
    draw->AddRectFilled(im(at - half - vec2(edge)), im(at + half + vec2(edge)), ink.edge, r);
    draw->AddRectFilled(im(at - half), im(at + half), ink.fill, r * 0.82f);
  } else if (!s.known || s.any) {
    const auto diamond = [&](float size, ImU32 color) {
      draw->AddQuadFilled({at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size}, {at.x - size, at.y},
                          color);
    };
    diamond(r * 1.25f + edge, ink.edge);
    diamond(r * 1.25f, ink.fill);
  } else {
    draw->AddCircleFilled(im(at), r + edge, ink.edge);
    draw->AddCircleFilled(im(at), r, ink.fill);
  }
}

/// A label from the dot inwards; a parameter's value stands at the other side.
void drawLabel(const CanvasView& view, const SocketPlace& s, vec2 at, ImU32 ink, float room, float right) {
  ImFont* font = view.level.text;
  const float y = at.y - font->FontSize * 0.5f, inset = view.px(13);
  if (!s.input) {
    const float width = std::min(textWidth(font, s.label), room);
    drawText(view.draw, font, {at.x - inset - width, y}, ink, s.label, room);
    return;
  }
  const float x = at.x + inset, used = drawText(view.draw, font, {x, y}, ink, s.label, room);
  if (s.value.empty() || s.linked) return;
  const float left = right - x - used - view.px(10), width = std::min(textWidth(font, s.value), left);
  if (width > 0) drawText(view.draw, font, {right - width, y}, palette::kTextFaint, s.value, left);
}

}  // namespace

void drawSockets(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  const float r = std::max(view.px(kSocketRadius), 2.0f * theme.scale);
  const bool tiny = view.level.zoom < 0.34f * theme.scale;
  bool sides[2] = {false, false};
  for (const SocketPlace& s : place.sockets) sides[s.input ? 0 : 1] = true;
  const float width = place.max.x - place.min.x;
  const float room = view.px(width - 28) * (sides[0] && sides[1] ? 0.6f : 1.0f);
  const float right = view.screen(place.max).x - view.px(10);
  const bool quiet = look.disabled || place.node->bypass;
  for (const SocketPlace& s : place.sockets) {
    const vec2 at = view.screen(s.at);
    const bool hovered = look.hoveredSocket == s.id && look.hoveredInput == s.input;
    const bool open = !look.accepts || look.accepts(s);
    ImU32 color = !open ? palette::kSocketOff : s.known ? socketColor(enumId(s.type)) : palette::kTextFaint;
    if (quiet && open) color = mixed(color, palette::kCanvas, 0.45f);
    if (tiny && !look.accepts) {  // a square costs a tenth of a circle, and no eye can tell
      view.draw->AddRectFilled(im(at - r * 0.8f), im(at + r * 0.8f), color);
      continue;
    }
    const float radius = hovered && open ? r * 1.3f : r;
    if (look.accepts && open) view.draw->AddCircleFilled(im(at), radius * 1.9f, faded(color, 0.22f));
    drawShape(view.draw, s, at, radius, {color, palette::kNodeBorder}, theme.scale);
    // Hollow: something has to be linked here.
    if (s.input && s.required && !s.linked && !look.accepts)
      view.draw->AddCircleFilled(im(at), radius * 0.5f, palette::kNode);
    if (!view.level.text) continue;
    const ImU32 ink = hovered && open                      ? palette::kTextStrong
                      : !open || quiet                     ? palette::kTextFaint
                      : s.linked || s.required || !s.input ? palette::kText
                                                           : palette::kTextDim;
    drawLabel(view, s, at, ink, room, right);
  }
}

}  // namespace pileus::editor
