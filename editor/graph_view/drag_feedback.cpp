#include "editor/graph_view/drag_feedback.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/graph_view/canvas.h"
#include "editor/graph_view/draw_link.h"
#include "editor/graph_view/layout/path_geometry.h"
#include "editor/graph_view/link_gestures.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using State = Interaction::State;

/// The ends of the links under way that stay where they are.
std::vector<SocketPlace> fixedEnds(const Layout& layout, const LinkDrag& drag) {
  std::vector<SocketPlace> ends;
  const auto add = [&](const std::string& name, const std::string& socket, bool input) {
    const NodePlace* node = findPlace(layout, name);
    if (const SocketPlace* s = node ? findSocket(*node, socket, input) : nullptr) ends.push_back(*s);
  };
  for (const nodes::Link& link : drag.moves) add(link.toNode, link.toSocket, true);
  if (drag.moves.empty()) add(drag.node, drag.socket, !drag.fromOutput);
  return ends;
}

/// The links under way: to the socket they would snap to, else to the pointer; a refusal stands beside the
/// pointer.
void drawDraggedLinks(Ui& ui, const Canvas& canvas, const CanvasView& view, const Layout& layout,
                      const Hit& hit) {
  const Interaction& m = canvas.interaction;
  const std::string refusal = refusalAt(canvas, layout, hit);
  vec2 loose = view.canvas(m.last);
  if (refusal.empty() && (hit.kind == Hit::Kind::Input || hit.kind == Hit::Kind::Output))
    if (const NodePlace* target = findPlace(layout, hit.node))
      if (const SocketPlace* s = findSocket(*target, hit.socket, hit.kind == Hit::Kind::Input)) loose = s->at;
  LinkLook look;
  look.hovered = true;
  for (const SocketPlace& fixed : fixedEnds(layout, m.link)) {
    const ImU32 color = refusal.empty() ? socketColor(enumId(fixed.type)) : palette::kError;
    if (fixed.input)
      drawLink(ui.theme, view, loose, fixed.at, color, look);
    else
      drawLink(ui.theme, view, fixed.at, loose, color, look);
  }
  if (refusal.empty()) return;
  tooltip(ui.theme, refusal, palette::kError);
  ui.trace.note("refusal", refusal);
}

void drawBox(const Interaction& m, ImDrawList* draw) {
  const vec2 lo = glm::min(m.press, m.last), hi = glm::max(m.press, m.last);
  draw->AddRectFilled(im(lo), im(hi), faded(palette::kAccent, 0.12f));
  draw->AddRect(im(lo), im(hi), faded(palette::kAccent, 0.8f));
}

struct StrokeLook {
  ImU32 color;
  const char* verb;
};
StrokeLook lookOf(Stroke stroke) {
  switch (stroke) {
    case Stroke::Cut:
      return {palette::kError, "cut"};
    case Stroke::Mute:
      return {palette::kWarning, "muted"};
    case Stroke::Dots:
      return {palette::kGood, "given a dot"};
    default:
      return {palette::kAccent, ""};
  }
}

/// The line, the links it crosses in its colour, and a mark where it crosses each.
void drawStroke(Ui& ui, const Session& session, const Canvas& canvas, const CanvasView& view,
                const Layout& layout) {
  const Interaction& m = canvas.interaction;
  const Theme& theme = ui.theme;
  const StrokeLook look = lookOf(m.stroke);
  std::vector<vec2> line = m.path;
  line.push_back(m.last);
  std::vector<ImVec2> screen(line.size());
  std::transform(line.begin(), line.end(), screen.begin(), im);
  const auto count = static_cast<int>(screen.size());
  if (m.stroke == Stroke::Lasso) {
    view.draw->AddPolyline(screen.data(), count, faded(look.color, 0.9f), ImDrawFlags_Closed, theme.px(1.5f));
    return;
  }
  for (vec2& p : line) p = view.canvas(p);
  const std::vector<Crossing> crossed = crossings(layout, shownGraph(session, canvas), line);
  LinkLook strong;
  strong.hovered = true;
  for (const Crossing& c : crossed) {
    vec2 from, to;
    nodes::SocketType type;
    if (linkEnds(layout, c.link, from, to, type)) drawLink(theme, view, from, to, look.color, strong);
    view.draw->AddCircleFilled(im(view.screen(c.at)), theme.px(5), palette::kCanvas);
    view.draw->AddCircleFilled(im(view.screen(c.at)), theme.px(3.5f), look.color);
  }
  view.draw->AddPolyline(screen.data(), count, look.color, 0, theme.px(2));
  ui.trace.note("stroke", fmt::format("{} {}", crossed.size(), look.verb));
}

}  // namespace

bool isPickedUp(const LinkDrag& drag, const nodes::Link& link) {
  return drag.replaces == link || std::find(drag.moves.begin(), drag.moves.end(), link) != drag.moves.end();
}

void drawDragFeedback(Ui& ui, const Session& session, const Canvas& canvas, const CanvasView& view,
                      const Layout& layout, const Hit& hit) {
  const Interaction& m = canvas.interaction;
  if (m.state == State::DraggingLink) drawDraggedLinks(ui, canvas, view, layout, hit);
  if (m.state == State::BoxSelecting) drawBox(m, view.draw);
  if (m.state == State::Stroking) drawStroke(ui, session, canvas, view, layout);
  if (canvas.moving.onto)
    ui.trace.note("drop link", canvas.moving.onto->fromNode + " -> " + canvas.moving.onto->toNode);
}

}  // namespace pileus::editor
