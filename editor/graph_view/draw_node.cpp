#include "editor/graph_view/draw_node.h"

#include <algorithm>
#include <cmath>

#include "editor/graph_view/draw_sockets.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/node_colors.h"
#include "editor/graph_view/node_footer.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"

namespace pileus::editor {
namespace {

constexpr float kRounding = 7;

struct Frame {
  vec2 lo{0}, hi{0};
  float round = 0, header = 0;  ///< pixels
};
Frame frameOf(const Theme& theme, const CanvasView& view, const NodePlace& place) {
  Frame f{glm::round(view.screen(place.min)), glm::round(view.screen(place.max)), view.px(kRounding),
          std::round(view.px(place.header))};
  // A name that does not shrink any more keeps room below the colour.
  if (!view.level.text)
    f.header = std::clamp(f.hi.y - f.lo.y - theme.small->FontSize - theme.px(4), theme.px(3),
                          std::max(f.header, theme.px(3)));
  return f;
}

void drawShadow(const Theme& theme, const CanvasView& view, const Frame& f) {
  if (view.level.zoom < 0.34f * theme.scale) return;
  for (int i = view.level.text ? 3 : 1; i >= 1; --i) {
    const auto grow = static_cast<float>(i) * theme.scale;
    view.draw->AddRectFilled({f.lo.x - grow, f.lo.y - grow + 2 * theme.scale},
                             {f.hi.x + grow, f.hi.y + grow + 2 * theme.scale}, palette::kShadow,
                             f.round + grow);
  }
}

/// Cards behind the node: it holds more than itself.
void drawStack(const Theme& theme, const CanvasView& view, const Frame& f) {
  for (int i = 2; i >= 1; --i) {
    const float by = view.px(3.5f) * static_cast<float>(i);
    const vec2 lo = f.lo + vec2(by, -by), hi = f.hi + vec2(by, -by);
    view.draw->AddRectFilled(im(lo), im(hi),
                             mixed(palette::kNode, palette::kCanvas, 0.2f * static_cast<float>(i)), f.round);
    view.draw->AddRect(im(lo), im(hi), palette::kScroll, f.round, 0, theme.scale);
  }
}

void drawBody(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look,
              const Frame& f) {
  ImDrawList* draw = view.draw;
  // Sunk into the canvas, but opaque, so that nothing shines through.
  const float sink = look.disabled ? 0.7f : place.node->bypass ? 0.5f : look.unfound ? 0.6f : 0.0f;
  const auto shade = [&](ImU32 color, float light) {
    if (look.hovered) color = mixed(color, palette::kHighlight, light);
    return sink > 0 ? mixed(color, palette::kCanvas, sink) : color;
  };
  ImU32 body = shade(palette::kNode, 0.03f);
  if (look.showTimes) body = mixed(body, palette::kWarning, 0.16f * static_cast<float>(look.share));
  const ImU32 header = shade(nodeColorOf(place), 0.08f);
  if (view.level.zoom < 0.16f * theme.scale) {  // a few pixels: one plain rectangle in its colour
    draw->AddRectFilled(im(f.lo), im(f.hi), look.selected ? palette::kSelect : mixed(body, header, 0.6f));
    return;
  }
  draw->AddRectFilled(im(f.lo), im(f.hi), body, f.round);
  draw->AddRectFilled(im(f.lo), {f.hi.x, f.lo.y + f.header}, header, f.round, ImDrawFlags_RoundCornersTop);
}

void drawBorder(const Theme& theme, const CanvasView& view, const NodeLook& look, const Frame& f) {
  const bool failed = look.status && look.status->state == nodes::NodeState::Failed;
  const bool strong = look.selected || look.found;
  if (look.found) {
    const vec2 grow(theme.px(3));
    view.draw->AddRect(im(f.lo - grow), im(f.hi + grow), faded(palette::kAccent, 0.45f), f.round + grow.x, 0,
                       theme.px(3));
  }
  view.draw->AddRect(im(f.lo), im(f.hi),
                     look.selected ? palette::kSelect
                     : look.found  ? palette::kAccent
                     : failed      ? palette::kError
                                   : palette::kNodeBorder,
                     f.round, 0, strong ? 2 * theme.scale : theme.scale);
}

/// Disabled: hatched, as if struck out.
void drawHatch(const Theme& theme, const CanvasView& view, const Frame& f) {
  view.draw->PushClipRect({f.lo.x, f.lo.y + f.header}, im(f.hi), true);
  const float step = std::max(view.px(11), theme.px(5)), height = f.hi.y - f.lo.y;
  for (float x = f.lo.x - height; x < f.hi.x; x += step)
    view.draw->AddLine({x, f.hi.y}, {x + height, f.lo.y}, faded(palette::kTextFaint, 0.16f), theme.scale);
  view.draw->PopClipRect();
}

/// Bypassed: what comes in goes straight through.
void drawThrough(const Theme& theme, const CanvasView& view, const NodePlace& place) {
  const SocketPlace *in = nullptr, *out = nullptr;
  for (const SocketPlace& s : place.sockets)
    if (!s.input && !out) out = &s;
  for (const SocketPlace& s : place.sockets)
    if (s.input && !in && out && s.type == out->type) in = &s;
  const float middle = 0.5f * (place.min.y + place.header + place.max.y);
  const vec2 a = view.screen(in ? in->at : vec2(place.min.x, middle)),
             d = view.screen(out ? out->at : vec2(place.max.x, middle));
  const ImU32 ink = faded(in ? socketColor(enumId(in->type)) : palette::kError, 0.55f);
  const vec2 reach((d.x - a.x) * 0.5f, 0);
  view.draw->AddBezierCubic(im(a), im(a + reach), im(d - reach), im(d), ink,
                            std::max(view.px(2.4f), theme.scale));
}

/// Too far away for sockets and their labels: the name alone, at a size that can still be read, in as many
/// lines as there is room for.
void drawDistantName(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look,
                     const Frame& f) {
  const float bottom =
      place.thumbnail == Thumbnail::None ? f.hi.y : std::round(view.screen(place.pictureMin).y);
  const float room = f.hi.x - f.lo.x - 6 * theme.scale;
  ImFont* font = theme.small;
  if (room < theme.px(46) || bottom - f.lo.y < font->FontSize) return noteHidden(f.lo, f.hi, titleOf(place));
  const bool quiet = place.node->bypass || look.disabled || look.unfound;
  const ImU32 ink = quiet ? palette::kTextFaint : palette::kText;
  const float height = bottom - f.lo.y - f.header;
  const std::vector<std::string_view> lines =
      linesOf(font, titleOf(place), room, std::max(1, static_cast<int>(height / font->FontSize)));
  const float all = font->FontSize * static_cast<float>(lines.size());
  float y = std::max(0.5f * (f.lo.y + f.header + bottom - all), f.lo.y);
  for (const std::string_view line : lines) {
    const float width = std::min(textWidth(font, line), room);
    drawText(view.draw, font, {0.5f * (f.lo.x + f.hi.x - width), y}, ink, line, room);
    if (textWidth(font, line) > room) noteCut(f.lo, f.hi, titleOf(place));
    y += font->FontSize;
  }
}

/// An eye and the slot's number: what the viewport shows, and what a digit would. Returns what is left.
float drawViewMark(const Theme& theme, const CanvasView& view, const NodeLook& look, float right,
                   const Frame& f) {
  if (!look.viewed && look.slot == 0) return right;
  ImFont* font = view.level.text;
  const ImU32 ink = look.viewed ? palette::kTextStrong : faded(palette::kTextStrong, 0.7f);
  const char digit[2] = {static_cast<char>('0' + look.slot), 0};
  const float eye = look.viewed ? view.px(18) : 0, number = look.slot > 0 ? view.px(9) : 0;
  const vec2 lo = {right - eye - number - view.px(9), f.lo.y + view.px(5)},
             hi = {right, f.lo.y + f.header - view.px(5)};
  view.draw->AddRectFilled(im(lo), im(hi), faded(palette::kCanvas, look.viewed ? 0.55f : 0.3f), view.px(5));
  const float y = 0.5f * (lo.y + hi.y - font->FontSize);
  float x = lo.x + view.px(5);
  if (look.viewed) drawText(view.draw, font, {x, y}, ink, icon::kEye, view.px(30));
  x += eye;
  if (look.slot > 0) drawText(view.draw, font, {x, y}, ink, digit, view.px(20));
  return lo.x - theme.px(4);
}

void drawHeader(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look,
                const Frame& f) {
  ImFont* font = view.level.strong;
  const float y = f.lo.y + f.header * 0.5f - font->FontSize * 0.5f;
  const char* mark = look.disabled        ? icon::kPower
                     : place.node->bypass ? icon::kBan
                     : place.type         ? categoryIcon(place.type->category)
                                          : icon::kWarning;
  const bool quiet = place.node->bypass || look.disabled || look.unfound;
  const ImU32 ink = quiet ? palette::kTextDim : palette::kTextStrong;
  float x = f.lo.x + view.px(9), right = f.hi.x - view.px(7);
  drawText(view.draw, font, {x, y}, faded(ink, 0.7f), mark, view.px(40));
  x += view.px(24);
  right = drawViewMark(theme, view, look, right, f);
  if (look.status && look.status->state == nodes::NodeState::Failed) {
    // The source of the trouble: a solid mark.
    const float r = view.px(8);
    const vec2 at = {right - r, f.lo.y + f.header * 0.5f};
    view.draw->AddCircleFilled(im(at), r, palette::kError);
    view.draw->AddLine({at.x, at.y - r * 0.55f}, {at.x, at.y + r * 0.12f}, palette::kNodeBorder, view.px(2));
    view.draw->AddCircleFilled({at.x, at.y + r * 0.5f}, view.px(1.3f), palette::kNodeBorder);
    right -= 2 * r + view.px(5);
  }
  // A long name does without its weight before it is cut.
  if (textWidth(font, titleOf(place)) > right - x) font = view.level.text;
  drawText(view.draw, font, {x, y}, ink, titleOf(place), right - x);
}

void drawProgress(const CanvasView& view, const NodePlace& place, const nodes::NodeStatus& status) {
  if (status.state != nodes::NodeState::Pending && status.state != nodes::NodeState::Partial) return;
  const float y = view.screen(place.min).y + view.px(place.header), height = std::max(view.px(3), 1.0f);
  const float x0 = view.screen(place.min).x, x1 = view.screen(place.max).x;
  view.draw->AddRectFilled({x0, y}, {x1, y + height}, palette::kTrack);
  const auto t = static_cast<float>(std::clamp(status.fraction, 0.0, 1.0));
  view.draw->AddRectFilled({x0, y}, {x0 + (x1 - x0) * t, y + height}, palette::kAccent);
}

/// The picture in its room, as large as it fits; tiles in as few rows as make them largest.
void drawPicture(const Theme& theme, const CanvasView& view, const NodePlace& place,
                 const NodePicture* picture) {
  const vec2 lo = glm::round(view.screen(place.pictureMin)), hi = glm::round(view.screen(place.pictureMax));
  const vec2 room = hi - lo;
  ImDrawList* draw = view.draw;
  draw->AddRectFilled(im(lo), im(hi), palette::kPictureEmpty, view.px(3));
  if (!picture || !picture->texture) {
    if (!view.level.text) return;
    const std::string_view words = "not made yet";
    const float width = textWidth(view.level.text, words);
    drawText(draw, view.level.text,
             {0.5f * (lo.x + hi.x - width), 0.5f * (lo.y + hi.y - view.level.text->FontSize)},
             palette::kTextFaint, words, room.x);
    return;
  }
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture->texture));
  if (picture->tiles == 0) {
    const vec2 size = vec2(picture->size) * std::min(room.x / static_cast<float>(picture->size.x),
                                                     room.y / static_cast<float>(picture->size.y));
    const vec2 at = glm::round(lo + 0.5f * (room - size));
    draw->AddImage(texture, im(at), im(at + glm::round(size)));
    return;
  }
  const float gap = std::max(std::round(view.px(2)), theme.scale);
  const int n = picture->tiles;
  int columns = 1;
  float edge = 0;
  for (int c = 1; c <= n; ++c) {
    const auto rows = static_cast<float>((n + c - 1) / c), across = static_cast<float>(c);
    const float fits =
        std::floor(std::min((room.x - gap * (across + 1)) / across, (room.y - gap * (rows + 1)) / rows));
    if (fits > edge) edge = fits, columns = c;
  }
  if (edge < 2) return;
  const int rows = (n + columns - 1) / columns;
  const vec2 whole = vec2(columns, rows) * (edge + gap) - gap, first = glm::round(lo + 0.5f * (room - whole));
  for (int i = 0; i < n; ++i) {
    const vec2 at = first + vec2(i % columns, i / columns) * (edge + gap);
    draw->AddImage(texture, im(at), im(at + edge), {static_cast<float>(i) / static_cast<float>(n), 0},
                   {static_cast<float>(i + 1) / static_cast<float>(n), 1});
  }
}

/// A small circle on the line that runs through; what lies around it can be grabbed too.
void drawDot(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  const vec2 lo = view.screen(place.min), hi = view.screen(place.max), at = 0.5f * (lo + hi);
  const SocketPlace* out = nullptr;
  for (const SocketPlace& s : place.sockets)
    if (!s.input) out = &s;
  const ImU32 color = out ? socketColor(enumId(out->type)) : palette::kTextFaint;
  const ImU32 ink = look.disabled || look.unfound ? mixed(color, palette::kCanvas, 0.6f) : color;
  const float width = std::clamp(view.px(2.2f), 1.1f * theme.scale, 4.5f * theme.scale);
  view.draw->AddLine({lo.x, at.y}, {hi.x, at.y}, faded(ink, 0.66f), width);
  const float r = std::max(view.px(look.hovered ? 7.5f : 6.5f), 2 * theme.scale);
  if (look.selected || look.found)
    view.draw->AddCircleFilled(im(at), r + 3 * theme.scale,
                               look.selected ? palette::kSelect : palette::kAccent);
  view.draw->AddCircleFilled(im(at), r + theme.scale, palette::kNodeBorder);
  view.draw->AddCircleFilled(im(at), r, ink);
  if (look.accepts) drawSockets(theme, view, place, look);
}

}  // namespace

ImU32 nodeColorOf(const NodePlace& place) {
  if (const ImU32 own = nodeColor(place.node->color)) return own;
  return place.type ? categoryColor(place.type->category) : palette::kNodeUnknown;
}

std::string_view titleOf(const NodePlace& place) {
  return place.node->label.empty() ? std::string_view(place.name) : std::string_view(place.node->label);
}

void drawNode(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  if (place.dot) return drawDot(theme, view, place, look);
  const Frame f = frameOf(theme, view, place);
  drawShadow(theme, view, f);
  if (look.stacked) drawStack(theme, view, f);
  drawBody(theme, view, place, look, f);
  if (view.level.zoom < 0.16f * theme.scale) {
    noteHidden(f.lo, f.hi, titleOf(place));
    if (look.status) drawFooter(theme, view, place, look);
    return;
  }
  if (place.thumbnail != Thumbnail::None && view.level.zoom > 0.25f * theme.scale)
    drawPicture(theme, view, place, look.picture);
  if (look.disabled) drawHatch(theme, view, f);
  if (place.node->bypass) drawThrough(theme, view, place);
  if (look.status) drawProgress(view, place, *look.status);
  drawBorder(theme, view, look, f);
  if (view.level.text)
    drawHeader(theme, view, place, look, f);
  else
    drawDistantName(theme, view, place, look, f);
  if (view.level.zoom > 0.25f * theme.scale) drawSockets(theme, view, place, look);
  if (look.status) drawFooter(theme, view, place, look);
  if (look.status && look.showTimes) drawCosts(theme, view, place, look);
}

}  // namespace pileus::editor
