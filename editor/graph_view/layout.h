#pragma once
// Where nodes and sockets lie, in canvas units: pure geometry of a graph, shared by drawing and hit testing.
#include <string>
#include <string_view>
#include <vector>

#include "nodes/graph.h"

namespace pileus::editor {

struct SocketPlace {
  std::string id, label;
  nodes::SocketType type = nodes::SocketType::Number;
  bool known = true;  ///< false: of an unknown node type, inferred from links
  bool input = true, many = false, required = false;
  vec2 at{0};  ///< the dot's centre
};

struct NodePlace {
  std::string name;
  const nodes::Node* node = nullptr;      ///< of the graph laid out; valid as long as it lives
  const nodes::NodeType* type = nullptr;  ///< null: unknown type
  vec2 min{0}, max{0};
  float header = 0;  ///< height of the title bar
  std::vector<SocketPlace> sockets;
};

struct Layout {
  std::vector<NodePlace> nodes;  ///< back to front: selected ones last
};

inline constexpr float kNodeWidth = 188, kHeaderHeight = 30, kRowHeight = 24, kNodePadding = 7,
                       kSocketRadius = 5.5f;

/// `raised` nodes are drawn, and hit, above the others.
Layout layoutGraph(const nodes::Graph& graph, const std::set<std::string>& raised);
const NodePlace* findPlace(const Layout& layout, std::string_view node);
const SocketPlace* findSocket(const NodePlace& place, std::string_view socket, bool input);

/// Control points of a link's cubic curve.
struct Curve {
  vec2 a{0}, b{0}, c{0}, d{0};
};
Curve linkCurve(vec2 from, vec2 to);
/// Shortest distance of a point to the curve (sampled finely).
float distance(const Curve& curve, vec2 point);

/// Bounds of some nodes (all when empty); false when there are none.
bool bounds(const Layout& layout, const std::set<std::string>& names, vec2& min, vec2& max);

}  // namespace pileus::editor
