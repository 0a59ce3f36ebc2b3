#include "editor/graph_view/draw_node.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/icons.h"

namespace pileus::editor {
namespace {

constexpr float kRounding = 6, kFooter = 24;

void drawBody(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look,
              ImU32 header) {
  ImDrawList* draw = view.draw;
  const vec2 lo = glm::round(view.screen(place.min)), hi = glm::round(view.screen(place.max));
  const float r = view.px(kRounding), bottom = std::round(lo.y + view.px(place.header));
  const bool bypassed = place.node->bypass;
  // Bypassed: sunk into the canvas, but opaque, so that nothing shines through.
  const auto sunk = [&](ImU32 color) { return bypassed ? mixed(color, palette::kCanvas, 0.5f) : color; };
  // A soft shadow lifts the node off the grid.
  for (int i = 3; i >= 1; --i) {
    const auto grow = static_cast<float>(i) * theme.scale;
    draw->AddRectFilled({lo.x - grow, lo.y - grow + 2 * theme.scale},
                        {hi.x + grow, hi.y + grow + 2 * theme.scale}, palette::kShadow, r + grow);
  }
  draw->AddRectFilled(im(lo), im(hi),
                      sunk(look.hovered ? mixed(palette::kNode, palette::kHighlight, 0.03f) : palette::kNode), r);
  draw->AddRectFilled(im(lo), {hi.x, bottom},
                      sunk(look.hovered ? mixed(header, palette::kHighlight, 0.08f) : header), r,
                      ImDrawFlags_RoundCornersTop);
  const bool failed = look.status && look.status->state == nodes::NodeState::Failed;
  const ImU32 border = look.selected ? palette::kSelect : failed ? palette::kError : palette::kNodeBorder;
  const float width = look.selected ? 2 * theme.scale : theme.scale;
  draw->AddRect(im(lo), im(hi), border, r, 0, width);
}

/// Too far away for sockets and their labels: the name alone, at a size that can still be read.
void drawDistantName(const Theme& theme, const CanvasView& view, const NodePlace& place) {
  const vec2 lo = view.screen(place.min), hi = view.screen(place.max);
  const float room = hi.x - lo.x - 6 * theme.scale;
  ImFont* font = theme.small;
  if (room < theme.px(46) || hi.y - lo.y < font->FontSize) return;
  const std::string_view title =
      place.node->label.empty() ? std::string_view(place.name) : std::string_view(place.node->label);
  const float width = std::min(textWidth(font, title), room);
  const float top = lo.y + view.px(place.header);
  drawText(view.draw, font,
           {0.5f * (lo.x + hi.x - width), std::max(0.5f * (top + hi.y - font->FontSize), lo.y)},
           place.node->bypass ? palette::kTextFaint : palette::kText, title, room);
}

void drawHeader(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  ImFont* font = view.level.strong;
  const vec2 lo = view.screen(place.min);
  const float middle = lo.y + view.px(place.header) * 0.5f - font->FontSize * 0.5f;
  const char* mark = place.node->bypass ? icon::kBan
                     : place.type       ? categoryIcon(place.type->category)
                                        : icon::kWarning;
  float x = lo.x + view.px(9);
  drawText(view.draw, font, {x, middle}, faded(palette::kTextStrong, 0.75f), mark, view.px(40));
  x += view.px(24);
  float right = view.screen(place.max).x - view.px(8);
  if (look.status && !look.status->warnings.empty() && look.status->state != nodes::NodeState::Failed) {
    right -= view.px(18);
    drawText(view.draw, font, {right, middle}, palette::kWarning, icon::kWarning, view.px(40));
    right -= view.px(4);
  }
  if (look.status && look.status->state == nodes::NodeState::Failed) {
    right -= view.px(18);
    drawText(view.draw, font, {right, middle}, palette::kError, icon::kError, view.px(40));
    right -= view.px(4);
  }
  const std::string_view title =
      place.node->label.empty() ? std::string_view(place.name) : std::string_view(place.node->label);
  drawText(view.draw, font, {x, middle}, place.node->bypass ? palette::kTextDim : palette::kTextStrong, title,
           right - x);
  if (look.showTimes && look.status && look.status->evaluations > 0 &&
      look.status->state != nodes::NodeState::Idle) {
    const double ms = look.status->cpuMs + look.status->gpuMs;
    const std::string text = ms < 9.95 ? fmt::format("{:.1f} ms", ms) : fmt::format("{:.0f} ms", ms);
    ImFont* small = view.level.text;
    drawText(view.draw, small,
             {view.screen(place.max).x - textWidth(small, text), lo.y - small->FontSize - 3 * theme.scale},
             palette::kTextDim, text, 1e4f);
  }
}

void drawSockets(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  ImDrawList* draw = view.draw;
  ImFont* font = view.level.text;
  const float r = std::max(view.px(kSocketRadius), 2.0f * theme.scale);
  bool bothSides[2] = {false, false};
  for (const SocketPlace& s : place.sockets) bothSides[s.input ? 0 : 1] = true;
  const float room = view.px(kNodeWidth - 28) * (bothSides[0] && bothSides[1] ? 0.6f : 1.0f);
  for (const SocketPlace& s : place.sockets) {
    const vec2 at = view.screen(s.at);
    const bool hovered = look.hoveredSocket == s.id && look.hoveredInput == s.input;
    const bool open = !look.accepts || look.accepts(s);
    const ImU32 color = !open     ? palette::kSocketOff
                        : s.known ? socketColor(s.type)
                                  : palette::kTextFaint;
    const float radius = hovered && open ? r * 1.35f : r;
    if (look.accepts && open) draw->AddCircleFilled(im(at), radius * 1.9f, faded(color, 0.22f));
    // A many-input is a pill: it takes more than one link.
    if (s.input && s.many) {
      const vec2 half = {radius * 0.85f, radius * 1.55f};
      draw->AddRectFilled(im(at - half - vec2(theme.scale)), im(at + half + vec2(theme.scale)),
                          palette::kNodeBorder, radius);
      draw->AddRectFilled(im(at - half), im(at + half), color, radius * 0.85f);
    } else {
      draw->AddCircleFilled(im(at), radius + theme.scale, palette::kNodeBorder);
      draw->AddCircleFilled(im(at), radius, color);
    }
    if (s.input && s.required && look.linked && !look.linked(s) && !look.accepts)
      draw->AddCircleFilled(im(at), radius * 0.5f, palette::kNode);
    if (!font) continue;
    const ImU32 ink = !open ? palette::kTextFaint : hovered ? palette::kTextStrong : palette::kText;
    const float y = at.y - font->FontSize * 0.5f;
    if (s.input) {
      drawText(draw, font, {at.x + view.px(13), y}, ink, s.label, room);
    } else {
      const float width = std::min(textWidth(font, s.label), room);
      drawText(draw, font, {at.x - view.px(13) - width, y}, ink, s.label, room);
    }
  }
}

void drawProgress(const CanvasView& view, const NodePlace& place, const nodes::NodeStatus& status) {
  if (status.state != nodes::NodeState::Pending && status.state != nodes::NodeState::Partial) return;
  const float y = view.screen(place.min).y + view.px(place.header), height = std::max(view.px(3), 1.0f);
  const float x0 = view.screen(place.min).x, x1 = view.screen(place.max).x;
  view.draw->AddRectFilled({x0, y}, {x1, y + height}, palette::kTrack);
  const auto t = static_cast<float>(std::clamp(status.fraction, 0.0, 1.0));
  view.draw->AddRectFilled({x0, y}, {x0 + (x1 - x0) * t, y + height}, palette::kAccent);
}

void drawFooter(const CanvasView& view, const NodePlace& place, const nodes::NodeStatus& status) {
  if (footerHeight(status) <= 0 || !view.level.text) return;
  const bool failed = status.state == nodes::NodeState::Failed,
             pending = status.state == nodes::NodeState::Pending;
  std::string text = failed    ? status.error.message
                     : pending ? fmt::format("{} {:.0f} %", status.what, 100 * status.fraction)
                               : status.warnings.front();
  if (failed && text.starts_with(place.name + ": ")) text.erase(0, place.name.size() + 2);
  const ImU32 ink = failed ? palette::kError : pending ? palette::kTextDim : palette::kWarning;
  const ImU32 back = failed ? palette::kErrorBack : pending ? palette::kBar : palette::kWarningBack;
  const vec2 lo = glm::round(view.screen({place.min.x, place.max.y + 4})),
             hi = glm::round(view.screen({place.max.x, place.max.y + 4 + kFooter}));
  view.draw->AddRectFilled(im(lo), im(hi), back, view.px(4));
  ImFont* font = view.level.text;
  drawText(view.draw, font, {lo.x + view.px(8), (lo.y + hi.y - font->FontSize) * 0.5f}, ink, text,
           hi.x - lo.x - view.px(16));
}

}  // namespace

float footerHeight(const nodes::NodeStatus& s) {
  // Only the node that works says so; those downstream of it merely wait.
  const bool works =
      s.state == nodes::NodeState::Pending && !s.what.empty() && !s.what.starts_with("Waiting for");
  const bool any =
      s.state == nodes::NodeState::Failed || works ||
      (!s.warnings.empty() && s.state != nodes::NodeState::Idle && s.state != nodes::NodeState::Skipped);
  return any ? kFooter + 4 : 0;
}

void drawNode(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  const vec2 margin = {20, 40};
  if (!view.visible(view.screen(place.min - margin), view.screen(place.max + margin))) return;
  const ImU32 header = place.type ? categoryColor(place.type->category) : palette::kNodeUnknown;
  drawBody(theme, view, place, look, header);
  if (view.level.text)
    drawHeader(theme, view, place, look);
  else
    drawDistantName(theme, view, place);
  if (look.status) drawProgress(view, place, *look.status);
  if (view.level.zoom > 0.18f * theme.scale) drawSockets(theme, view, place, look);
  if (look.status) drawFooter(view, place, *look.status);
}

}  // namespace pileus::editor
