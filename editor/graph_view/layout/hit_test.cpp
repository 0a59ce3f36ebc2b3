#include "editor/graph_view/layout/hit_test.h"

#include <algorithm>
#include <cmath>

#include "editor/graph_view/draw_link.h"
#include "editor/graph_view/frames.h"

namespace pileus::editor {
namespace {

/// `side`: only labels of inputs (true) or outputs (false).
const SocketPlace* socketAt(const NodePlace& node, vec2 at, float reach, bool labels,
                            std::optional<bool> side) {
  const SocketPlace* best = nullptr;
  float bestDistance = reach;
  for (const SocketPlace& s : node.sockets) {
    const float d = glm::length(at - s.at);
    if (d < bestDistance) best = &s, bestDistance = d;
  }
  if (best || !labels) return best;
  // The label: from the dot inwards, one row high; inputs own the left part of a shared row.
  for (const SocketPlace& s : node.sockets) {
    if (std::abs(at.y - s.at.y) > 0.5f * kRowHeight || (side && s.input != *side)) continue;
    const float inwards = s.input ? at.x - s.at.x : s.at.x - at.x;
    const float width = 13 + 8.0f * static_cast<float>(std::min<std::size_t>(s.label.size(), 14));
    if (inwards >= -reach && inwards <= width) return &s;
  }
  return nullptr;
}

}  // namespace

Hit hitTest(const Layout& layout, const nodes::Graph& graph, vec2 at, float zoom,
            const Interaction& machine) {
  const bool dragging = machine.state == Interaction::State::DraggingLink;
  const float reach = std::clamp((dragging ? 18.0f : 11.0f) / zoom, 8.0f, 40.0f);
  const bool readable = zoom > 0.5f;
  // A label that the dragged link cannot end at is a part of the node like any other.
  std::optional<bool> side;
  if (dragging) side = machine.link.fromOutput && machine.link.moves.empty();
  for (auto node = layout.nodes.rbegin(); node != layout.nodes.rend(); ++node) {
    const bool near = at.x >= node->min.x - reach && at.x <= node->max.x + reach && at.y >= node->min.y &&
                      at.y <= node->max.y;
    if (!near) continue;
    // A dot's sockets leave its middle to be grabbed.
    const bool body =
        node->dot && !dragging && std::abs(at.x - 0.5f * (node->min.x + node->max.x)) < 0.25f * kDotWidth;
    const SocketPlace* s =
        body || zoom <= 0.18f ? nullptr : socketAt(*node, at, reach, readable && !node->dot, side);
    if (s) {
      Hit hit{s->input ? Hit::Kind::Input : Hit::Kind::Output, node->name, s->id, {}, {}};
      for (const nodes::Link& link : graph.links)
        if (s->input ? link.toNode == node->name && link.toSocket == s->id
                     : link.fromNode == node->name && link.fromSocket == s->id)
          hit.links.push_back(link);
      if (s->input && !s->many && !hit.links.empty()) hit.taken = hit.links.back();
      return hit;
    }
    if (at.x >= node->min.x && at.x <= node->max.x) return {Hit::Kind::Node, node->name, {}, {}, {}};
  }
  if (dragging) return {};
  const nodes::Link* best = nullptr;
  float bestDistance = 7.0f / zoom;
  for (const nodes::Link& link : graph.links) {
    vec2 from, to;
    nodes::SocketType type;
    if (!linkEnds(layout, link, from, to, type)) continue;
    const float d = distance(linkCurve(from, to), at);
    if (d < bestDistance) best = &link, bestDistance = d;
  }
  if (best) return {Hit::Kind::Link, {}, {}, *best, {}};
  return frameAt(graph, at, zoom).value_or(Hit{});
}

std::set<std::string> nodesInside(const Layout& layout, vec2 a, vec2 b) {
  const vec2 lo = glm::min(a, b), hi = glm::max(a, b);
  std::set<std::string> names;
  for (const NodePlace& p : layout.nodes)
    if (p.max.x >= lo.x && p.min.x <= hi.x && p.max.y >= lo.y && p.min.y <= hi.y) names.insert(p.name);
  return names;
}

}  // namespace pileus::editor
