#pragma once
// A tree of groups as one flat graph, which is what is evaluated.
#include <map>
#include <set>
#include <string>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

struct FlatGraph {
  /// Names are paths ("Group/Node"). Sockets of groups are dots here; disabled nodes, their links and muted
  /// links are gone.
  Graph graph;
  std::set<std::string> groups;         ///< paths of the groups taken apart
  std::map<std::string, Error> faults;  ///< groups that could not be, by path; they stay as nodes
};

FlatGraph flatten(const Graph& root);

}  // namespace pileus::nodes
