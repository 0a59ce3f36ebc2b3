// Groups as graphs within graphs: their sockets, and putting a changed one back.
#include "nodes/graph/graph_groups.h"

#include <algorithm>
#include <utility>

#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_sockets.h"

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

/// `into`: an input of a node in the graph at `scope`; "": any of them.
void follow(const Graph& root, const NodeAt& to, const std::string& into, std::set<std::string>& seen,
            std::vector<SocketAt>& out) {
  const Graph* graph = graphAt(root, to.scope);
  if (!graph || !seen.insert(to.path(to.name) + "." + into).second) return;
  for (const Link& link : graph->links) {
    if (link.toNode != to.name || link.muted || (!into.empty() && link.toSocket != into)) continue;
    const Node* from = findNode(*graph, link.fromNode);
    if (!from || from->disabled) continue;
    NodeAt at{to.scope, link.fromNode};
    if (from->group) {
      if (from->bypass) continue;
      at.scope.push_back(std::exchange(at.name, link.fromSocket));
      follow(root, at, "in", seen, out);
    } else if (from->type == "group.input") {
      if (at.scope.empty()) continue;
      const std::string socket = std::exchange(at.name, at.scope.back());
      at.scope.pop_back();
      follow(root, at, socket, seen, out);
    } else if (passesThrough(from->type)) {
      follow(root, at, "in", seen, out);
    } else {
      out.push_back({at.path(at.name), link.fromSocket});
    }
  }
}

}  // namespace

std::string NodeAt::path(const std::string& other) const {
  std::string out;
  for (const std::string& group : scope) out += group + "/";
  return out + other;
}

NodeAt nodeAt(const std::string& path) {
  NodeAt at;
  std::size_t begin = 0;
  for (std::size_t slash; (slash = path.find('/', begin)) != std::string::npos; begin = slash + 1)
    at.scope.push_back(path.substr(begin, slash - begin));
  at.name = path.substr(begin);
  return at;
}

std::vector<SocketAt> sourcesOf(const Graph& root, const std::string& node, const std::string& input) {
  std::vector<SocketAt> out;
  std::set<std::string> seen;
  follow(root, nodeAt(node), input, seen, out);
  return out;
}

Result<Graph> unlinked(const Graph& root, const std::string& node, const std::string& input) {
  const NodeAt at = nodeAt(node);
  const Graph* graph = graphAt(root, at.scope);
  if (!graph) return fail(Code::Arguments, "there is no node '{}'", node);
  Graph without = *graph;
  std::erase_if(without.links, [&](const Link& l) { return l.toNode == at.name && l.toSocket == input; });
  return withGraphAt(root, at.scope, std::move(without));
}

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
