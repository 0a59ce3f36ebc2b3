#include "editor/picture/viewed_node.h"

#include <fmt/core.h>

#include <deque>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"
#include "nodes/declare/value.h"
#include "nodes/graph/graph_groups.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::editor {
namespace {

/// A node by its path, with the graph it is in.
struct Found {
  const nodes::Graph* graph = nullptr;  ///< null: there is no such node
  std::string name, folder;             ///< "Group/" before the name; "" in the document itself
  const nodes::NodeType* type = nullptr;
};

Found find(const nodes::Graph& root, const std::string& path) {
  const nodes::NodeAt at = nodes::nodeAt(path);
  Found found{nodes::graphAt(root, at.scope), at.name, at.path("")};
  const nodes::Node* node = found.graph ? nodes::findNode(*found.graph, found.name) : nullptr;
  if (!node) return {};
  found.type = nodes::findNodeType(node->type);
  return found;
}

std::string imageOutput(const Found& found) {
  if (found.graph)
    for (const nodes::SocketInfo& s : nodes::outputsOf(*found.graph, found.name))
      if (s.type == nodes::SocketType::Image && s.known && !s.any) return s.id;
  return {};
}

}  // namespace

std::string imageOutput(const nodes::Graph& root, const std::string& node) {
  return imageOutput(find(root, node));
}

const nodes::SocketValue* shownImage(const nodes::Evaluator& evaluator, const nodes::Graph& root,
                                     const std::string& node) {
  const std::string output = imageOutput(root, node);
  return output.empty() ? evaluator.input(node, "image") : evaluator.output(node, output);
}

bool viewable(const nodes::Graph& root, const std::string& node) {
  const Found found = find(root, node);
  return (found.type && found.type->isOutput) || !imageOutput(found).empty();
}

std::string nearestPicture(const nodes::Graph& root, const std::string& node) {
  const Found start = find(root, node);
  if (!start.graph) return {};
  std::deque<std::string> open{start.name};
  std::set<std::string> seen{start.name};
  for (; !open.empty(); open.pop_front()) {
    if (viewable(root, start.folder + open.front())) return start.folder + open.front();
    for (const nodes::Link& link : start.graph->links)
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

namespace {

void viewPath(Messages& messages, const Session& session, Shown& shown, const std::string& path) {
  const std::string nearest = nearestPicture(session.document.root(), path);
  const auto shortName = [](const std::string& p) { return p.substr(p.rfind('/') + 1); };
  if (nearest.empty())
    return messages.hint(fmt::format("{} has no picture, and none is made with it: link it to a Render node.",
                                     shortName(path)));
  shown.activeView = nearest;
  if (nearest == path)
    messages.note("Viewing " + nearest);
  else
    messages.note(fmt::format("{} has no picture of its own: viewing {}, which uses it", shortName(path),
                              shortName(nearest)));
}

}  // namespace

void viewNode(Messages& messages, const Session& session, Shown& shown, const std::string& node) {
  viewPath(messages, session, shown, session.document.scopedName(node));
}

void viewSelected(Messages& messages, const Session& session, Shown& shown) {
  if (session.document.selection().size() == 1)
    viewNode(messages, session, shown, *session.document.selection().begin());
  else
    messages.hint("Select one node to view it.");
}

void viewSlot(Messages& messages, const Session& session, Shown& shown, int number) {
  std::string& slot = shown.slots.at(static_cast<std::size_t>(number - 1));
  if (find(session.document.root(), slot).graph) return viewPath(messages, session, shown, slot);
  const std::set<std::string>& selection = session.document.selection();
  if (selection.size() != 1)
    return messages.hint(
        fmt::format("View slot {} is free: select one node and press {} to put it there.", number, number));
  const std::string path = session.document.scopedName(*selection.begin());
  if (!nearestPicture(session.document.root(), path).empty()) {
    for (std::string& other : shown.slots)  // a node is in one slot
      if (other == path) other.clear();
    slot = path;
  }
  viewPath(messages, session, shown, path);
}

void clearViewSlots(Shown& shown) { shown.slots = {}; }

void viewsFollow(const Session& session, Shown& shown, const std::string& from, const std::string& to) {
  const std::string before = session.document.scopedName(from), after = session.document.scopedName(to);
  const auto follow = [&](std::string& path) {
    if (path == before || path.starts_with(before + "/")) path.replace(0, before.size(), after);
  };
  follow(shown.activeView);
  for (std::string& slot : shown.slots) follow(slot);
}

}  // namespace pileus::editor
