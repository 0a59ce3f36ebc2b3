#include "editor/graph_view/arrange_commands.h"

#include "editor/app/editor.h"
#include "editor/graph_view/layout/layout_cache.h"

namespace pileus::editor {
namespace {

struct Picked {
  std::vector<std::string>
      names;  ///< in the graph's order, so that the outcome does not hang on what is drawn first
  std::vector<Box> boxes;
  std::vector<BoxLink> links;
};

Picked pick(Editor& editor, bool allWithout) {
  const std::shared_ptr<const Layout> layout = shownLayout(editor);
  const std::set<std::string>& selection = editor.document.selection();
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

void move(Editor& editor, const Picked& picked, const std::vector<dvec2>& at, const std::string& label) {
  nodes::Graph graph = editor.document.graph();
  for (std::size_t i = 0; i < at.size(); ++i)
    graph = nodes::moveNodes(graph, {picked.names[i]}, at[i] - picked.boxes[i].at);
  tryEdit(editor, std::move(graph), label);
}

}  // namespace

void arrangeNodes(Editor& editor) {
  if (editor.canvas.moving.active) return;
  const Picked picked = pick(editor, true);
  if (picked.boxes.size() < 2)
    return editor.messages.hint("Select two or more nodes to arrange them, or none for all.");
  move(editor, picked, arranged(picked.boxes, picked.links), "Arrange nodes");
}

void alignNodes(Editor& editor, Align how) {
  if (editor.canvas.moving.active) return;
  const Picked picked = pick(editor, false);
  if (picked.boxes.size() < 2) return editor.messages.hint("Select two or more nodes to align them.");
  move(editor, picked, aligned(picked.boxes, how), "Align nodes");
}

void distributeNodes(Editor& editor, bool horizontal) {
  if (editor.canvas.moving.active) return;
  const Picked picked = pick(editor, false);
  if (picked.boxes.size() < 3) return editor.messages.hint("Select three or more nodes to distribute them.");
  move(editor, picked, distributed(picked.boxes, horizontal), "Distribute nodes");
}

}  // namespace pileus::editor
