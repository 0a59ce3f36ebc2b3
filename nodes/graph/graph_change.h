#pragma once
// What the edits of a graph share; private to graph_*.cpp.
#include <algorithm>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

inline bool sameEnds(const Link& a, const Link& b) {
  return a.fromNode == b.fromNode && a.fromSocket == b.fromSocket && a.toNode == b.toNode &&
         a.toSocket == b.toSocket;
}
inline bool sameInput(const Link& a, const Link& b) {
  return a.toNode == b.toNode && a.toSocket == b.toSocket;
}
/// Muted or not.
inline bool hasLink(const Graph& graph, const Link& link) {
  return std::any_of(graph.links.begin(), graph.links.end(),
                     [&](const Link& l) { return sameEnds(l, link); });
}
inline std::string linkText(const Link& link) {
  return link.fromNode + "." + link.fromSocket + " -> " + link.toNode + "." + link.toSocket;
}

/// Replaces a node by a changed copy; without a difference nothing is copied.
template <class Change>
void changeNode(Graph& graph, const std::string& name, Change change) {
  const auto it = graph.nodes.find(name);
  if (it == graph.nodes.end()) return;
  Node node = *it->second;
  change(node);
  if (!(node == *it->second)) it->second = std::make_shared<const Node>(std::move(node));
}

inline void expose(Graph& graph, const std::string& name, const std::string& param) {
  changeNode(graph, name, [&](Node& node) {
    if (std::find(node.expose.begin(), node.expose.end(), param) == node.expose.end())
      node.expose.push_back(param);
  });
}

}  // namespace pileus::nodes
