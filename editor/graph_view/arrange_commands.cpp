#include "editor/graph_view/arrange_commands.h"

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/layout/layout_cache.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

struct Picked {
  std::vector<std::string>
      names;  ///< in the graph's order, so that the outcome does not hang on what is drawn first
  std::vector<Box> boxes;
  std::vector<BoxLink> links;
};

Picked pick(const Session& session, const Clock& clock, const Settings& settings, Canvas& canvas,
            bool allWithout) {
  const std::shared_ptr<const Layout> layout = shownLayout(session, clock, settings, canvas);
  const std::set<std::string>& selection = session.document.selection();
  Picked picked;
  std::vector<int> boxOf(layout->nodes.size(), -1);
  for (const int i : layout->byName) {
    const NodePlace& p = layout->nodes[static_cast<std::size_t>(i)];
    if (!selection.contains(p.name) && !(allWithout && selection.empty())) continue;
    boxOf[static_cast<std::size_t>(i)] = static_cast<int>(picked.boxes.size());
    picked.names.push_back(p.name);
    picked.boxes.push_back({dvec2(p.min), dvec2(p.max - p.min)});
  }
  for (const LinkPlace& l : layout->links) {
    const int from = boxOf[static_cast<std::size_t>(l.from)], to = boxOf[static_cast<std::size_t>(l.to)];
    if (from < 0 || to < 0 || from == to) continue;
    picked.links.push_back(
        {from, to, static_cast<double>(l.a.y - layout->nodes[static_cast<std::size_t>(l.from)].min.y),
         static_cast<double>(l.b.y - layout->nodes[static_cast<std::size_t>(l.to)].min.y)});
  }
  return picked;
}

void move(Ui& ui, Session& session, const Picked& picked, const std::vector<dvec2>& at,
          const std::string& label) {
  nodes::Graph graph = session.document.graph();
  for (std::size_t i = 0; i < at.size(); ++i)
    graph = nodes::moveNodes(graph, {picked.names[i]}, at[i] - picked.boxes[i].at);
  tryEdit(session, ui.messages, std::move(graph), label);
}

}  // namespace

void arrangeNodes(const GraphRoom& room) {
  if (room.canvas.moving.active) return;
  const Picked picked = pick(room.session, room.clock, room.settings, room.canvas, true);
  if (picked.boxes.size() < 2)
    return room.ui.messages.hint("Select two or more nodes to arrange them, or none for all.");
  move(room.ui, room.session, picked, arranged(picked.boxes, picked.links), "Arrange nodes");
}

void alignNodes(const GraphRoom& room, Align how) {
  if (room.canvas.moving.active) return;
  const Picked picked = pick(room.session, room.clock, room.settings, room.canvas, false);
  if (picked.boxes.size() < 2) return room.ui.messages.hint("Select two or more nodes to align them.");
  move(room.ui, room.session, picked, aligned(picked.boxes, how), "Align nodes");
}

void distributeNodes(const GraphRoom& room, bool horizontal) {
  if (room.canvas.moving.active) return;
  const Picked picked = pick(room.session, room.clock, room.settings, room.canvas, false);
  if (picked.boxes.size() < 3) return room.ui.messages.hint("Select three or more nodes to distribute them.");
  move(room.ui, room.session, picked, distributed(picked.boxes, horizontal), "Distribute nodes");
}

}  // namespace pileus::editor
