#include "editor/graph_view/move_gesture.h"

#include <algorithm>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/draw_link.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/layout/path_geometry.h"
#include "editor/toolkit/ui.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_frames.h"

namespace pileus::editor {
namespace {

std::string named(const char* verb, const std::set<std::string>& names) {
  return verb + (names.size() == 1 ? " " + *names.begin() : std::string(" nodes"));
}

}  // namespace

const nodes::Graph& shownGraph(const Session& session, const Canvas& canvas) {
  return canvas.moving.active ? canvas.moving.graph : session.document.graph();
}

void moveBy(const Session& session, Canvas& canvas, dvec2 by) {
  MoveGesture& moving = canvas.moving;
  const std::set<std::string>& names = session.document.selection();
  if (names.empty()) return;
  moving.active = true;
  moving.by += by;
  moving.graph = nodes::moveNodes(session.document.graph(), names, moving.by);
}

void findDropLink(const Session& session, Canvas& canvas, const Layout& layout) {
  MoveGesture& moving = canvas.moving;
  const std::set<std::string>& names = session.document.selection();
  moving.onto.reset();
  if (moving.active && !moving.frame && names.size() == 1)
    moving.onto = linkUnder(layout, moving.graph, *names.begin());
}

void dropNodes(Ui& ui, Session& session, Canvas& canvas) {
  if (!canvas.moving.active) return;
  findDropLink(session, canvas, layoutGraph(canvas.moving.graph, {}));
  const MoveGesture moving = std::exchange(canvas.moving, {});
  const std::set<std::string> names = session.document.selection();
  if (moving.onto)
    tryEdit(session, ui.messages, nodes::insertOnLink(moving.graph, *names.begin(), *moving.onto),
            "Insert " + *names.begin() + " on a link");
  else
    tryEdit(session, ui.messages, moving.graph, named("Move", names));
}

void dragFrameBy(const Session& session, Canvas& canvas, const command::FrameDrag& drag, dvec2 by) {
  MoveGesture& moving = canvas.moving;
  const nodes::Graph& graph = session.document.graph();
  if (drag.frame >= graph.frames.size()) return;
  moving.active = true;
  moving.by += by;
  moving.frame = drag;
  moving.graph = drag.sides.any() ? nodes::setFrame(graph, drag.frame,
                                                    resized(graph.frames[drag.frame], drag.sides, moving.by))
                                  : nodes::moveFrame(graph, drag.frame, moving.by, drag.content);
}

void dropFrame(Ui& ui, Session& session, Canvas& canvas) {
  MoveGesture moving = std::exchange(canvas.moving, {});
  if (!moving.active || !moving.frame || moving.frame->frame >= moving.graph.frames.size()) return;
  const std::string& title = moving.graph.frames[moving.frame->frame].title;
  const char* verb = moving.frame->sides.any() ? "Resize frame" : "Move frame";
  tryEdit(session, ui.messages, std::move(moving.graph), verb + (title.empty() ? "" : " " + title));
}

void cancelMove(Canvas& canvas) { canvas.moving = {}; }

std::optional<nodes::Link> linkUnder(const Layout& layout, const nodes::Graph& graph,
                                     const std::string& name) {
  const NodePlace* place = findPlace(layout, name);
  if (!place) return std::nullopt;
  // A node that is in use already is moved about without a change of its links.
  for (const nodes::Link& link : graph.links)
    if (link.fromNode == name || link.toNode == name) return std::nullopt;
  std::optional<nodes::Link> best;
  float bestDistance = 0;
  for (const nodes::Link& link : graph.links) {
    vec2 from, to;
    nodes::SocketType type;
    float distance = 0;
    if (!linkEnds(layout, link, from, to, type) ||
        !passesThrough(linkCurve(from, to), place->min, place->max, distance))
      continue;
    if (best && distance >= bestDistance) continue;
    if (!nodes::insertOnLink(graph, name, link)) continue;
    best = link;
    bestDistance = distance;
  }
  return best;
}

}  // namespace pileus::editor
