#include "editor/graph_view/layout/layout.h"

#include <algorithm>

#include "nodes/graph/graph_sockets.h"

namespace pileus::editor {
namespace {

constexpr float kMapPicture = 88, kImagePicture = 97, kEnvironmentPicture = 86;  // height

void addSockets(NodePlace& p, const nodes::SocketTable& table, double frame) {
  const auto add = [&](nodes::SocketInfo s, bool input) {
    SocketPlace socket;
    socket.id = std::move(s.id);
    socket.label = std::move(s.label);
    socket.type = s.type;
    socket.known = s.known;
    socket.any = s.any;
    socket.input = input;
    socket.many = s.many;
    socket.required = s.required;
    if (const nodes::ParamSpec* spec = s.param && p.type ? p.type->param(socket.id) : nullptr)
      socket.value = nodes::formatParam(*spec, nodes::paramValue(*p.node, *spec, frame)) +
                     (spec->unit.empty() ? "" : " " + spec->unit);
    p.sockets.push_back(std::move(socket));
  };
  for (nodes::SocketInfo& s : table.inputs(p.name)) add(std::move(s), true);
  for (nodes::SocketInfo& s : table.outputs(p.name)) add(std::move(s), false);
}

/// A dot is a point on a link, with a socket at either side of it. Its place is that of a square of 20.
void placeDot(NodePlace& p) {
  p.min += 0.5f * (vec2(20) - vec2(kDotWidth, kDotHeight));
  p.max = p.min + vec2(kDotWidth, kDotHeight);
  for (SocketPlace& s : p.sockets) s.at = {s.input ? p.min.x : p.max.x, 0.5f * (p.min.y + p.max.y)};
}

NodePlace place(const nodes::SocketTable& table, const std::string& name, const nodes::NodePtr& node,
                const ThumbnailChoice& thumbnails, double frame) {
  NodePlace p;
  p.name = name;
  p.node = node;
  p.type = nodes::findNodeType(node->type);
  p.min = vec2(node->at);
  addSockets(p, table, frame);
  p.dot = node->type == "dot";
  if (p.dot) {
    placeDot(p);
    return p;
  }
  p.header = kHeaderHeight;
  int rows[2] = {0, 0};
  const float top = p.min.y + kHeaderHeight + kNodePadding;
  for (SocketPlace& s : p.sockets) {
    const int row = rows[s.input ? 0 : 1]++;
    s.at = {s.input ? p.min.x : p.min.x + kNodeWidth, top + (static_cast<float>(row) + 0.5f) * kRowHeight};
  }
  const int count = std::max({rows[0], rows[1], 1});
  p.max = {p.min.x + kNodeWidth, top + static_cast<float>(count) * kRowHeight + kNodePadding};
  if (p.type && thumbnails.shows(name)) p.thumbnail = thumbnailKind(*p.type);
  if (p.thumbnail != Thumbnail::None) {
    p.pictureMin = {p.min.x + 8, p.max.y};
    const float height = p.thumbnail == Thumbnail::Map           ? kMapPicture
                         : p.thumbnail == Thumbnail::Environment ? kEnvironmentPicture
                                                                 : kImagePicture;
    p.pictureMax = {p.max.x - 8, p.max.y + height};
    p.max.y = p.pictureMax.y + 8;
  }
  return p;
}

int indexOf(const Layout& layout, std::string_view node) {
  const auto it = std::lower_bound(
      layout.byName.begin(), layout.byName.end(), node,
      [&](int i, std::string_view name) { return layout.nodes[static_cast<std::size_t>(i)].name < name; });
  return it != layout.byName.end() && layout.nodes[static_cast<std::size_t>(*it)].name == node ? *it : -1;
}

SocketPlace* socketOf(NodePlace& place, std::string_view socket, bool input) {
  return const_cast<SocketPlace*>(findSocket(place, socket, input));
}

void placeLinks(Layout& layout, const nodes::Graph& graph) {
  layout.links.reserve(graph.links.size());
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    const nodes::Link& link = graph.links[i];
    const int from = indexOf(layout, link.fromNode), to = indexOf(layout, link.toNode);
    if (from < 0 || to < 0) continue;
    SocketPlace* out = socketOf(layout.nodes[static_cast<std::size_t>(from)], link.fromSocket, false);
    SocketPlace* in = socketOf(layout.nodes[static_cast<std::size_t>(to)], link.toSocket, true);
    if (!out || !in) continue;
    out->linked = in->linked = true;
    layout.links.push_back({static_cast<int>(i), from, to, out->at, in->at, out->type});
  }
}

}  // namespace

Thumbnail thumbnailKind(const nodes::NodeType& type) {
  for (const nodes::SocketSpec& s : type.outputs)
    if (s.type == nodes::SocketType::Image) return Thumbnail::Image;
  for (const nodes::SocketSpec& s : type.inputs)
    if (type.isOutput && s.type == nodes::SocketType::Image) return Thumbnail::Image;
  if (type.id == "light.environment" || type.id == "light.sky") return Thumbnail::Environment;
  // A march keeps no map.
  return type.category == "Shadow" && type.id != "shadow.ray_march" ? Thumbnail::Map : Thumbnail::None;
}

Layout layoutGraph(const nodes::Graph& graph, const std::set<std::string>& raised,
                   const ThumbnailChoice& thumbnails, double frame) {
  Layout layout;
  const nodes::SocketTable table(graph);
  layout.nodes.reserve(graph.nodes.size());
  layout.byName.reserve(graph.nodes.size());
  for (const bool top : {false, true})
    for (const auto& [name, node] : graph.nodes)
      if (raised.contains(name) == top) layout.nodes.push_back(place(table, name, node, thumbnails, frame));
  for (const NodePlace& p : layout.nodes)
    for (const SocketPlace& s : p.sockets)
      layout.animated |= !s.value.empty() && p.node->animated.contains(s.id);
  for (std::size_t i = 0; i < layout.nodes.size(); ++i) layout.byName.push_back(static_cast<int>(i));
  std::sort(layout.byName.begin(), layout.byName.end(), [&](int a, int b) {
    return layout.nodes[static_cast<std::size_t>(a)].name < layout.nodes[static_cast<std::size_t>(b)].name;
  });
  placeLinks(layout, graph);
  return layout;
}

const NodePlace* findPlace(const Layout& layout, std::string_view node) {
  const int i = indexOf(layout, node);
  return i < 0 ? nullptr : &layout.nodes[static_cast<std::size_t>(i)];
}

const SocketPlace* findSocket(const NodePlace& place, std::string_view socket, bool input) {
  for (const SocketPlace& s : place.sockets)
    if (s.input == input && s.id == socket) return &s;
  return nullptr;
}

Curve linkCurve(vec2 from, vec2 to) {
  const float reach =
      std::clamp(std::abs(to.x - from.x) * 0.5f, 28.0f, 160.0f) + (to.x < from.x ? 30.0f : 0.0f);
  return {from, from + vec2(reach, 0), to - vec2(reach, 0), to};
}

float distance(const Curve& k, vec2 p) {
  float best = glm::length(p - k.a);
  vec2 last = k.a;
  constexpr int kSteps = 32;
  for (int i = 1; i <= kSteps; ++i) {
    const float t = static_cast<float>(i) / kSteps, s = 1 - t;
    const vec2 q = s * s * s * k.a + 3 * s * s * t * k.b + 3 * s * t * t * k.c + t * t * t * k.d;
    const vec2 edge = q - last;
    const float length2 = glm::dot(edge, edge);
    const float u = length2 > 0 ? std::clamp(glm::dot(p - last, edge) / length2, 0.0f, 1.0f) : 0.0f;
    best = std::min(best, glm::length(p - (last + u * edge)));
    last = q;
  }
  return best;
}

bool bounds(const Layout& layout, const std::set<std::string>& names, vec2& min, vec2& max) {
  bool any = false;
  for (const NodePlace& p : layout.nodes) {
    if (!names.empty() && !names.contains(p.name)) continue;
    min = any ? glm::min(min, p.min) : p.min;
    max = any ? glm::max(max, p.max) : p.max;
    any = true;
  }
  return any;
}

}  // namespace pileus::editor
