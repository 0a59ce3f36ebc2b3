#pragma once
// Finding nodes of a graph by name, type, parameter or value, inside groups too. Pure.
#include <string>
#include <string_view>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::editor {

struct FindMatch {
  std::vector<std::string> scope;  ///< groups from the outermost in
  std::string node;
  std::string where;  ///< what matched, for people: "Sun", "Coverage 0.36"
  int score = 0;
};

/// Best first: names before types before parameters, then in the order of the graph. Every word of the query
/// has to be found in the node, capitals or not; an empty query finds nothing. Values are those of `frame`.
std::vector<FindMatch> findMatches(const nodes::Graph& graph, std::string_view query, double frame = 1);

}  // namespace pileus::editor
