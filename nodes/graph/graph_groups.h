#pragma once
// Groups: nodes of type "group" that hold a graph. Inside, each node of type "group.input" or "group.output"
// is one socket of the group: the node's name is the socket's id and label, the order is that of their y
// positions.
#include <set>
#include <span>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

inline constexpr std::size_t kDeepestGroup = 16;  ///< groups within groups

/// What a group holds; null: no such node, or no group.
const Graph* groupGraph(const Graph& graph, const std::string& name);
/// A node by its path, "Group/Node"; also one of a flat graph, whose names are paths. Null: there is none.
const Node* findNodeAt(const Graph& root, const std::string& path);
/// The graph a path of group names leads to; null: there is none. An empty path leads to `root`.
const Graph* graphAt(const Graph& root, std::span<const std::string> scope);
/// `root` with the graph there replaced; links to sockets that are gone are dropped, to those of renamed
/// nodes follow.
Result<Graph> withGraphAt(const Graph& root, std::span<const std::string> scope, Graph inner);

/// A path as the groups it leads through and the node's name there.
struct NodeAt {
  std::vector<std::string> scope;
  std::string name;
  std::string path(const std::string& other) const;  ///< of another node of that graph
};
NodeAt nodeAt(const std::string& path);

/// A socket of a node given by its path.
struct SocketAt {
  std::string node, socket;
  bool operator==(const SocketAt&) const = default;
};
/// Where what arrives at an input comes from, through groups, their sockets and dots; in the order of the
/// links. Without muted links, nodes that are off, and what a bypassed group passes on. An empty `input`: at
/// any of the node's.
std::vector<SocketAt> sourcesOf(const Graph& root, const std::string& node, const std::string& input);
/// Without the links into that input.
Result<Graph> unlinked(const Graph& root, const std::string& node, const std::string& input);

/// The sockets of a group's graph, as names of its nodes in their order.
std::vector<std::string> groupInputs(const Graph& inner);
std::vector<std::string> groupOutputs(const Graph& inner);

/// Puts nodes into a new group in their place; crossing links become its sockets, nothing else changes.
/// Refused where another node lies between them (the group would need itself).
Result<Graph> groupNodes(const Graph& graph, const std::set<std::string>& names,
                         std::string* groupName = nullptr);
/// Puts what a group holds in its place; `names` gets the nodes' names.
Result<Graph> ungroup(const Graph& graph, const std::string& group, std::set<std::string>* names = nullptr);

/// How deep groups are nested: 0 without any.
std::size_t groupDepth(const Graph& graph);

}  // namespace pileus::nodes
