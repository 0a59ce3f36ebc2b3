#include "editor/viewed_node.h"

#include <fmt/core.h>

#include <deque>

#include "editor/editor.h"

namespace pileus::editor {
namespace {

constexpr auto kImage = nodes::SocketType::Image;

const nodes::NodeType* typeOf(const nodes::Graph& graph, const std::string& name) {
  const nodes::Node* node = nodes::findNode(graph, name);
  return node ? nodes::findNodeType(node->type) : nullptr;
}

}  // namespace

std::string imageOutput(const nodes::Graph& graph, const std::string& node) {
  if (const nodes::NodeType* type = typeOf(graph, node))
    for (const nodes::SocketSpec& s : type->outputs)
      if (s.type == kImage) return s.id;
  return {};
}

const nodes::SocketValue* shownImage(const nodes::Evaluator& evaluator, const nodes::Graph& graph,
                                     const std::string& node) {
  const std::string output = imageOutput(graph, node);
  return output.empty() ? evaluator.input(node, "image") : evaluator.output(node, output);
}

bool viewable(const nodes::Graph& graph, const std::string& node) {
  const nodes::NodeType* type = typeOf(graph, node);
  return type && (type->isOutput || !imageOutput(graph, node).empty());
}

std::string nearestPicture(const nodes::Graph& graph, const std::string& node) {
  std::deque<std::string> open{node};
  std::set<std::string> seen{node};
  for (; !open.empty(); open.pop_front()) {
    if (viewable(graph, open.front())) return open.front();
    for (const nodes::Link& link : graph.links)
      if (!link.muted && link.fromNode == open.front() && seen.insert(link.toNode).second)
        open.push_back(link.toNode);
  }
  return {};
}

int slotOf(const ViewSlots& slots, const std::string& node) {
  for (std::size_t i = 0; i < slots.size(); ++i)
    if (!node.empty() && slots[i] == node) return static_cast<int>(i) + 1;
  return 0;
}

void viewNode(Editor& editor, const std::string& node) {
  const nodes::Graph& graph = editor.document.graph();
  const std::string shown = nearestPicture(graph, node);
  if (shown.empty())
    return editor.messages.hint(
        fmt::format("{} has no picture, and none is made with it: link it to a Render node.", node));
  editor.viewport.activeView = shown;
  if (shown == node)
    editor.messages.note("Viewing " + node);
  else
    editor.messages.note(fmt::format("{} has no picture of its own: viewing {}, which uses it", node, shown));
}

void viewSelected(Editor& editor) {
  if (editor.document.selection().size() == 1)
    viewNode(editor, *editor.document.selection().begin());
  else
    editor.messages.hint("Select one node to view it.");
}

void viewSlot(Editor& editor, int number) {
  std::string& slot = editor.canvas.slots.at(static_cast<std::size_t>(number - 1));
  const nodes::Graph& graph = editor.document.graph();
  if (!slot.empty() && nodes::findNode(graph, slot)) return viewNode(editor, slot);
  const std::set<std::string>& selection = editor.document.selection();
  if (selection.size() != 1)
    return editor.messages.hint(
        fmt::format("View slot {} is free: select one node and press {} to put it there.", number, number));
  if (nearestPicture(graph, *selection.begin()).empty()) return viewNode(editor, *selection.begin());
  for (std::string& other : editor.canvas.slots)  // a node is in one slot
    if (other == *selection.begin()) other.clear();
  slot = *selection.begin();
  viewNode(editor, slot);
}

void clearViewSlots(Editor& editor) { editor.canvas.slots = {}; }

}  // namespace pileus::editor
