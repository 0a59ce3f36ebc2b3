#include "editor/graph_view/canvas_draw.h"

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_overlays.h"
#include "editor/graph_view/drag_feedback.h"
#include "editor/graph_view/draw_link.h"
#include "editor/graph_view/draw_node.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/node_footer.h"
#include "editor/graph_view/node_status.h"
#include "editor/graph_view/scopes.h"
#include "editor/graph_view/thumbnails.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "renderer/base/profile.h"

namespace pileus::editor {
namespace {

using State = Interaction::State;

bool dragsLink(const Canvas& canvas) { return canvas.interaction.state == State::DraggingLink; }

/// Milliseconds of everything that was evaluated for what is shown.
double allMs(const Session& session, const Shown& shown, const Layout& layout) {
  double sum = 0;
  for (const NodePlace& p : layout.nodes) {
    const nodes::NodeStatus& s = statusOf(session, shown, p.name);
    if (s.state != nodes::NodeState::Idle) sum += s.cpuMs + s.gpuMs;
  }
  return sum;
}

void traceNode(Ui& ui, const Session& session, const Shown& shown, const CanvasView& view,
               const NodePlace& place) {
  UiTrace& trace = ui.trace;
  trace.rect("node/" + place.name, im(view.screen(place.min)), im(view.screen(place.max)));
  trace.rect("header/" + place.name, im(view.screen(place.min)),
             im(view.screen({place.max.x, place.min.y + place.header})));
  const float r = view.px(kSocketRadius);
  for (const SocketPlace& s : place.sockets)
    trace.rect("socket/" + place.name + (s.input ? "/in/" : "/out/") + s.id, im(view.screen(s.at) - r),
               im(view.screen(s.at) + r));
  const nodes::NodeStatus& status = statusOf(session, shown, place.name);
  if (const FooterRect f = footerRect(view, place, status); f.max.x > f.min.x)
    trace.rect((footerKind(status) == FooterKind::Follower ? "waits/" : "footer/") + place.name, im(f.min),
               im(f.max));
}

std::string socketText(const NodePlace& place, const Hit& hit) {
  const SocketPlace* s = findSocket(place, hit.socket, hit.kind == Hit::Kind::Input);
  if (!s) return {};
  const auto kinds = nodes::enumInfo(static_cast<nodes::SocketType*>(nullptr));
  std::string text = s->label + " (" + std::string(kinds[static_cast<std::size_t>(s->type)].label) +
                     (s->many ? ", takes many links)" : ")");
  if (!s->value.empty()) text += "\n" + s->value;
  if (place.type)
    for (const nodes::SocketSpec& spec : s->input ? place.type->inputs : place.type->outputs)
      if (spec.id == s->id && !spec.help.empty()) text += "\n" + spec.help;
  return text;
}

}  // namespace

void drawGrid(const Theme& theme, const CanvasView& view) {
  for (const auto& [step, color] :
       {std::pair{20.0f, palette::kGrid}, std::pair{100.0f, palette::kGridStrong}}) {
    const float pixels = step * view.level.zoom;
    if (pixels < 11 * theme.scale) continue;
    // Fades in, so that a step of the zoom does not make it jump out.
    const ImU32 ink = faded(color, std::clamp((pixels - 8 * theme.scale) / (12 * theme.scale), 0.25f, 1.0f));
    const vec2 first = view.min - vec2(std::fmod(view.min.x - view.origin.x, pixels),
                                       std::fmod(view.min.y - view.origin.y, pixels));
    for (float x = first.x - pixels; x < view.max.x; x += pixels)
      view.draw->AddRectFilled({std::floor(x), view.min.y}, {std::floor(x) + 1, view.max.y}, ink);
    for (float y = first.y - pixels; y < view.max.y; y += pixels)
      view.draw->AddRectFilled({view.min.x, std::floor(y)}, {view.max.x, std::floor(y) + 1}, ink);
  }
}

void drawLinks(const Theme& theme, const Session& session, const Canvas& canvas, const CanvasView& view,
               const Layout& layout, const Hit& hit) {
  const bool dragging = dragsLink(canvas);
  const nodes::Graph& graph = shownGraph(session, canvas);
  for (const LinkPlace& place : layout.links) {
    const nodes::Link& link = graph.links[static_cast<std::size_t>(place.link)];
    if (dragging && isPickedUp(canvas.interaction.link, link)) continue;
    LinkLook look;
    look.selected = session.selectedLink == link || canvas.moving.onto == link;
    look.hovered = hit.kind == Hit::Kind::Link && hit.link == link && !dragging;
    look.muted = link.muted;
    look.dimmed = dragging;
    drawLink(theme, view, place.a, place.b, socketColor(enumId(place.type)), look);
  }
}

void drawNodes(const GraphRoom& room, const CanvasView& view, const Layout& layout, const Hit& hit) {
  const Canvas& canvas = room.canvas;
  const bool dragging = dragsLink(room.canvas), times = room.settings.showTimes;
  const double total = times ? std::max(allMs(room.session, room.shown, layout), 1e-3) : 1;
  // A View node on show is the rule; worth a mark is another node in its place.
  const std::string viewed =
      room.shown.activeView.empty() ? std::string() : shownView(room.session, room.shown);
  const std::set<std::string>& selection = room.session.document.selection();
  // What hangs below a node is drawn with it.
  const vec2 margin = {20, 76};
  for (const NodePlace& place : layout.nodes) {
    if (!view.visible(view.screen(place.min - margin), view.screen(place.max + margin))) continue;
    const bool underPointer =
        hit.kind != Hit::Kind::Link && hit.kind != Hit::Kind::Canvas && hit.node == place.name;
    NodeLook look;
    look.selected = selection.contains(place.name);
    look.hovered = underPointer && hit.kind == Hit::Kind::Node && !dragging;
    look.disabled = place.node->disabled;
    const std::string known = evaluatedName(room.session, place.name);
    look.viewed = known == viewed;
    look.slot = slotOf(room.shown.slots, known);
    look.stacked = place.node->group != nullptr;
    look.status = &room.shown.preview.evaluator().status(known);
    if (times) {
      look.showTimes = true;
      look.share = look.status->state == nodes::NodeState::Idle
                       ? 0
                       : std::clamp((look.status->cpuMs + look.status->gpuMs) / total, 0.0, 1.0);
    }
    if (canvas.find.open) {
      look.found = canvas.find.matches.contains(place.name);
      look.unfound = !canvas.find.query.empty() && !look.found;
    }
    std::string source;
    if (look.status->state == nodes::NodeState::Skipped && view.level.text) {
      source = sourceOfError(room.session, room.shown, room.canvas, layout, place.name);
      look.source = source;
      look.hoveredFooter = canvas.overlays.follower == place.name;
    }
    if (underPointer && hit.kind != Hit::Kind::Node)
      look.hoveredSocket = hit.socket, look.hoveredInput = hit.kind == Hit::Kind::Input;
    if (dragging)
      look.accepts = [&](const SocketPlace& s) {
        return !canvas.refusals.contains(socketKey(place.name, s.id, s.input));
      };
    NodePicture picture;
    if (place.thumbnail != Thumbnail::None && view.level.zoom > 0.25f * room.ui.theme.scale) {
      picture = nodePicture(room, place);
      look.picture = &picture;
    }
    drawNode(room.ui.theme, view, place, look);
    if (room.ui.trace.on() && (look.viewed || look.slot))
      room.ui.trace.note("badge/" + place.name, (look.viewed ? "viewed " : "") +
                                                    (look.slot ? std::to_string(look.slot) : std::string()));
  }
  if (!room.ui.trace.on()) return;
  const ThreadStopwatch clock;
  for (const NodePlace& place : layout.nodes) traceNode(room.ui, room.session, room.shown, view, place);
  room.ui.trace.ms += clock.ms();
}

void drawHints(const Theme& theme, const Session& session, const Canvas& canvas, const CanvasView& view) {
  if (!shownGraph(session, canvas).nodes.empty()) return;
  const vec2 middle = 0.5f * (view.min + view.max);
  const bool inside = !session.document.scope().empty();
  const char* lines[] = {
      inside ? "This group is empty" : "This graph is empty", "Press Tab, or right-click, to add a node",
      inside ? "Press U to go back out" : "or drop a file, or open a preset from the File menu"};
  float y = middle.y - theme.px(34);
  for (int i = 0; i < 3; ++i) {
    ImFont* font = i == 0 ? theme.title : theme.body;
    drawText(view.draw, font, {middle.x - 0.5f * textWidth(font, lines[i]), y},
             i == 0 ? palette::kTextDim : palette::kTextFaint, lines[i], 1e4f);
    y += font->FontSize + theme.px(i == 0 ? 10 : 5);
  }
}

void drawCanvasTooltip(Ui& ui, const Session& session, const Shown& shown, const Canvas& canvas,
                       const Layout& layout, const Hit& hit, bool hovered) {
  if (canvas.interaction.busy()) return;
  const std::string& follower = canvas.overlays.follower;
  const bool overNode = hovered && (hit.kind == Hit::Kind::Node || hit.kind == Hit::Kind::Input ||
                                    hit.kind == Hit::Kind::Output);
  const NodePlace* place = findPlace(layout, !follower.empty() ? follower
                                             : overNode        ? hit.node
                                                               : std::string());
  if (!place) return;
  const nodes::NodeStatus& status = statusOf(session, shown, place->name);
  using S = nodes::NodeState;
  std::string text;
  ImU32 ink = palette::kText;
  if (follower.empty() && hit.kind != Hit::Kind::Node) {
    text = socketText(*place, hit);
  } else if (status.state == S::Failed) {
    text = status.error.message;
    ink = palette::kError;
  } else if (status.state == S::Skipped) {
    const std::string source = sourceOfError(session, shown, canvas, layout, place->name);
    text = source.empty() ? status.error.message
                          : "Waits for " + source + ":\n" + statusOf(session, shown, source).error.message;
    if (!follower.empty()) text += "\nClick to go there.";
  } else if (!status.warnings.empty() && status.state != S::Idle) {
    for (const std::string& w : status.warnings) text += (text.empty() ? "" : "\n") + w;
    ink = palette::kWarning;
  } else if (!place->type) {
    text = "Unknown node type " + place->node->type + ": it is kept as it is and does nothing.";
    ink = palette::kWarning;
  }
  if (text.empty()) return;
  tooltip(ui.theme, text, ink);
  ui.trace.note("tooltip", text);
}

}  // namespace pileus::editor
