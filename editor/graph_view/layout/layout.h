#pragma once
// Where nodes, sockets and links lie, in canvas units: pure geometry of a graph, shared by drawing and hit
// testing.
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::editor {

struct SocketPlace {
  std::string id, label;
  nodes::SocketType type = nodes::SocketType::Number;
  bool known = true;  ///< false: of an unknown node type, inferred from links
  bool any = false;   ///< takes anything: its type is a guess
  bool input = true, many = false, required = false;
  bool linked = false;  ///< by a link that exists, muted or not
  std::string value;    ///< of a parameter shown as a socket: what it holds while nothing is linked
  vec2 at{0};           ///< the dot's centre
};

/// What a node's picture shows.
enum class Thumbnail { None, Image, Map, Environment };

struct NodePlace {
  std::string name;
  nodes::NodePtr node;
  const nodes::NodeType* type = nullptr;  ///< null: unknown type
  vec2 min{0}, max{0};
  bool dot = false;                       ///< a point on a link
  float header = 0;                       ///< height of the title bar
  Thumbnail thumbnail = Thumbnail::None;  ///< shown below the sockets
  vec2 pictureMin{0}, pictureMax{0};      ///< room for it
  std::vector<SocketPlace> sockets;
};

struct LinkPlace {
  int link = 0;          ///< index into the graph's links
  int from = 0, to = 0;  ///< indices into Layout::nodes
  vec2 a{0}, b{0};       ///< ends
  nodes::SocketType type = nodes::SocketType::Number;
};

struct Layout {
  std::vector<NodePlace> nodes;  ///< back to front: selected ones last
  std::vector<LinkPlace> links;  ///< of those whose sockets exist, in the graph's order
  std::vector<int> byName;       ///< indices into nodes, by name
  bool animated = false;         ///< another frame would show another value
};

inline constexpr float kNodeWidth = 188, kHeaderHeight = 30, kRowHeight = 24, kNodePadding = 7,
                       kSocketRadius = 5.5f, kDotWidth = 44, kDotHeight = 24;

/// Which nodes show a picture of what they made.
struct ThumbnailChoice {
  bool all = false;
  std::set<std::string> exceptions;
  bool shows(const std::string& node) const { return all != exceptions.contains(node); }
  bool operator==(const ThumbnailChoice&) const = default;
};
/// What kind of picture a node of this type can show.
Thumbnail thumbnailKind(const nodes::NodeType& type);

/// `raised` nodes are drawn, and hit, above the others. Sockets show the values of `frame`.
Layout layoutGraph(const nodes::Graph& graph, const std::set<std::string>& raised,
                   const ThumbnailChoice& thumbnails = {}, double frame = 1);
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
