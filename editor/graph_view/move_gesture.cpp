#include "editor/graph_view/move_gesture.h"

#include <algorithm>

#include "editor/app/editor.h"
#include "editor/graph_view/draw_link.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/layout/path_geometry.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_frames.h"

namespace pileus::editor {
namespace {

std::string named(const char* verb, const std::set<std::string>& names) {
  return verb + (names.size() == 1 ? " " + *names.begin() : std::string(" nodes"));
}

}  // namespace

const nodes::Graph& shownGraph(const Editor& editor) {
  return editor.canvas.moving.active ? editor.canvas.moving.graph : editor.document.graph();
}

void moveBy(Editor& editor, dvec2 by) {
  MoveGesture& moving = editor.canvas.moving;
  const std::set<std::string>& names = editor.document.selection();
  if (names.empty()) return;
  moving.active = true;
  moving.by += by;
  moving.graph = nodes::moveNodes(editor.document.graph(), names, moving.by);
}

void findDropLink(Editor& editor, const Layout& layout) {
  MoveGesture& moving = editor.canvas.moving;
  const std::set<std::string>& names = editor.document.selection();
  moving.onto.reset();
  if (moving.active && !moving.frame && names.size() == 1)
    moving.onto = linkUnder(layout, moving.graph, *names.begin());
}

void dropNodes(Editor& editor) {
  if (!editor.canvas.moving.active) return;
  findDropLink(editor, layoutGraph(editor.canvas.moving.graph, {}));
  const MoveGesture moving = std::exchange(editor.canvas.moving, {});
  const std::set<std::string> names = editor.document.selection();
  if (moving.onto)
    tryEdit(editor, nodes::insertOnLink(moving.graph, *names.begin(), *moving.onto),
            "Insert " + *names.begin() + " on a link");
  else
    tryEdit(editor, moving.graph, named("Move", names));
}

void dragFrameBy(Editor& editor, const command::FrameDrag& drag, dvec2 by) {
  MoveGesture& moving = editor.canvas.moving;
  const nodes::Graph& graph = editor.document.graph();
  if (drag.frame >= graph.frames.size()) return;
  moving.active = true;
  moving.by += by;
  moving.frame = drag;
  moving.graph = drag.sides.any() ? nodes::setFrame(graph, drag.frame,
                                                    resized(graph.frames[drag.frame], drag.sides, moving.by))
                                  : nodes::moveFrame(graph, drag.frame, moving.by, drag.content);
}

void dropFrame(Editor& editor) {
  MoveGesture moving = std::exchange(editor.canvas.moving, {});
  if (!moving.active || !moving.frame || moving.frame->frame >= moving.graph.frames.size()) return;
  const std::string& title = moving.graph.frames[moving.frame->frame].title;
  const char* verb = moving.frame->sides.any() ? "Resize frame" : "Move frame";
  tryEdit(editor, std::move(moving.graph), verb + (title.empty() ? "" : " " + title));
}

void cancelMove(Editor& editor) { editor.canvas.moving = {}; }

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
