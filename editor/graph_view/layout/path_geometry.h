#pragma once
// Lines drawn freely on the canvas against what lies there: which links they cross, which nodes they
// surround. Canvas units.
#include <set>
#include <string>
#include <vector>

#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Crossing {
  nodes::Link link;
  vec2 at{0};
};
/// Every link that the line crosses, once each at its first crossing, in the graph's order.
std::vector<Crossing> crossings(const Layout& layout, const nodes::Graph& graph,
                                const std::vector<vec2>& line);
/// Nodes that the closed line surrounds or touches.
std::set<std::string> nodesAround(const Layout& layout, const std::vector<vec2>& line);
/// Does the curve pass through the rectangle? Its distance to the middle goes to `distance`.
bool passesThrough(const Curve& curve, vec2 min, vec2 max, float& distance);

}  // namespace pileus::editor
