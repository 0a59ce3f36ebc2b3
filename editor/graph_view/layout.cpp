#include "editor/graph_view/layout.h"

#include <algorithm>

namespace pileus::editor {
namespace {

NodePlace place(const nodes::Graph& graph, const std::string& name, const nodes::Node& node) {
  NodePlace p;
  p.name = name;
  p.node = &node;
  p.type = nodes::findNodeType(node.type);
  p.min = vec2(node.at);
  p.header = kHeaderHeight;
  if (p.type) {
    for (const nodes::SocketSpec& s : p.type->inputs)
      p.sockets.push_back({s.id, s.label, s.type, true, true, s.many, s.required, {}});
    for (const nodes::SocketSpec& s : p.type->outputs)
      p.sockets.push_back({s.id, s.label, s.type, true, false, false, false, {}});
  } else {
    // A node this version does not know keeps the sockets its links name, so that they stay visible.
    for (const nodes::Link& link : graph.links) {
      const auto add = [&](const std::string& id, bool input) {
        if (!findSocket(p, id, input))
          p.sockets.push_back({id, id, nodes::SocketType::Text, false, input, true, false, {}});
      };
      if (link.toNode == name) add(link.toSocket, true);
      if (link.fromNode == name) add(link.fromSocket, false);
    }
  }
  int rows[2] = {0, 0};
  const float top = p.min.y + kHeaderHeight + kNodePadding;
  for (SocketPlace& s : p.sockets) {
    const int row = rows[s.input ? 0 : 1]++;
    s.at = {s.input ? p.min.x : p.min.x + kNodeWidth, top + (static_cast<float>(row) + 0.5f) * kRowHeight};
  }
  const int count = std::max({rows[0], rows[1], 1});
  p.max = {p.min.x + kNodeWidth, top + static_cast<float>(count) * kRowHeight + kNodePadding};
  return p;
}

}  // namespace

Layout layoutGraph(const nodes::Graph& graph, const std::set<std::string>& raised) {
  Layout layout;
  layout.nodes.reserve(graph.nodes.size());
  for (const bool top : {false, true})
    for (const auto& [name, node] : graph.nodes)
      if (raised.contains(name) == top) layout.nodes.push_back(place(graph, name, *node));
  return layout;
}

const NodePlace* findPlace(const Layout& layout, std::string_view node) {
  for (const NodePlace& p : layout.nodes)
    if (p.name == node) return &p;
  return nullptr;
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
