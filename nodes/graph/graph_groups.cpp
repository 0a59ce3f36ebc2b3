// Groups as graphs within graphs: their sockets, and putting a changed one back.
#include "nodes/graph/graph_groups.h"

#include "nodes/graph/graph_change.h"

namespace pileus::nodes {
namespace {

std::vector<std::string> socketNodes(const Graph& inner, std::string_view type) {
  std::vector<std::string> names;
  for (const auto& [name, node] : inner.nodes)
    if (node->type == type) names.push_back(name);
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return inner.nodes.at(a)->at.y < inner.nodes.at(b)->at.y;
  });
  return names;
}

/// What a socket of the old graph is called in the new one; "" = gone. A renamed node is still the same
/// object.
std::string followed(const Graph& before, const Graph& after, const std::string& socket,
                     std::string_view type) {
  const auto same = after.nodes.find(socket);
  if (same != after.nodes.end() && same->second->type == type) return socket;
  const auto old = before.nodes.find(socket);
  if (old == before.nodes.end()) return "";
  for (const auto& [name, node] : after.nodes)
    if (node == old->second && !before.nodes.contains(name)) return name;
  return "";
}

}  // namespace

const Graph* groupGraph(const Graph& graph, const std::string& name) {
  const Node* node = findNode(graph, name);
  return node ? node->group.get() : nullptr;
}

const Node* findNodeAt(const Graph& root, const std::string& path) {
  if (const Node* node = findNode(root, path)) return node;
  const std::size_t slash = path.find('/');
  const Graph* inner = slash == std::string::npos ? nullptr : groupGraph(root, path.substr(0, slash));
  return inner ? findNodeAt(*inner, path.substr(slash + 1)) : nullptr;
}

const Graph* graphAt(const Graph& root, std::span<const std::string> scope) {
  const Graph* graph = &root;
  for (const std::string& name : scope)
    if (!(graph = groupGraph(*graph, name))) return nullptr;
  return graph;
}

Result<Graph> withGraphAt(const Graph& root, std::span<const std::string> scope, Graph inner) {
  if (scope.empty()) return inner;
  const std::string& name = scope.front();
  const Graph* before = groupGraph(root, name);
  if (!before) return fail(Code::Arguments, "there is no group '{}'", name);
  PILEUS_TRY(Graph after, withGraphAt(*before, scope.subspan(1), std::move(inner)));
  Graph result = root;
  for (Link& link : result.links) {
    if (link.toNode == name) link.toSocket = followed(*before, after, link.toSocket, "group.input");
    if (link.fromNode == name) link.fromSocket = followed(*before, after, link.fromSocket, "group.output");
  }
  std::erase_if(result.links, [](const Link& l) { return l.toSocket.empty() || l.fromSocket.empty(); });
  changeNode(result, name, [&](Node& node) { node.group = std::make_shared<const Graph>(std::move(after)); });
  return result;
}

std::vector<std::string> groupInputs(const Graph& inner) { return socketNodes(inner, "group.input"); }
std::vector<std::string> groupOutputs(const Graph& inner) { return socketNodes(inner, "group.output"); }

std::size_t groupDepth(const Graph& graph) {
  std::size_t deepest = 0;
  for (const auto& [name, node] : graph.nodes)
    if (node->group) deepest = std::max(deepest, 1 + groupDepth(*node->group));
  return deepest;
}

}  // namespace pileus::nodes
