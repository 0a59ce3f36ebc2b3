#include "nodes/graph/graph_frames.h"

#include <algorithm>

#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

// Space around the nodes of frameAround; above it is the title's.
constexpr double kMargin = 26, kTitle = 44;

/// As the canvas draws them: a header, a row for each pair of sockets.
dvec2 sizeOf(const SocketTable& table, const Node& node, const std::string& name) {
  if (node.type == "dot") return {20, 20};
  const std::size_t rows = std::max({table.inputs(name).size(), table.outputs(name).size(), std::size_t(1)});
  return {188, 44 + 24 * static_cast<double>(rows)};
}

bool inside(const Frame& frame, dvec2 p) {
  return p.x >= frame.at.x && p.y >= frame.at.y && p.x <= frame.at.x + frame.size.x &&
         p.y <= frame.at.y + frame.size.y;
}

}  // namespace

dvec2 nodeSize(const Graph& graph, const std::string& name) {
  const Node* node = findNode(graph, name);
  return node ? sizeOf(SocketTable(graph), *node, name) : dvec2(0);
}

FrameContent contentOf(const Graph& graph, std::size_t index) {
  FrameContent content;
  if (index >= graph.frames.size()) return content;
  const Frame& frame = graph.frames[index];
  const SocketTable table(graph);
  for (const auto& [name, node] : graph.nodes)
    if (inside(frame, node->at + 0.5 * sizeOf(table, *node, name))) content.nodes.insert(name);
  for (std::size_t i = 0; i < graph.frames.size(); ++i) {
    const Frame& other = graph.frames[i];
    if (i == index || !inside(frame, other.at) || !inside(frame, other.at + other.size)) continue;
    if (other.at == frame.at && other.size == frame.size) continue;  // neither lies inside the other
    content.frames.insert(i);
  }
  return content;
}

Graph addFrame(const Graph& graph, Frame frame) {
  Graph result = graph;
  result.unknown.erase("frames");
  result.frames.push_back(std::move(frame));
  return result;
}

Graph removeFrame(const Graph& graph, std::size_t index) {
  Graph result = graph;
  if (index < result.frames.size()) result.frames.erase(result.frames.begin() + static_cast<long>(index));
  return result;
}

Graph setFrame(const Graph& graph, std::size_t index, Frame frame) {
  Graph result = graph;
  if (index < result.frames.size()) result.frames[index] = std::move(frame);
  return result;
}

Graph moveFrame(const Graph& graph, std::size_t index, dvec2 by, bool withContent) {
  if (index >= graph.frames.size()) return graph;
  Graph result = graph;
  if (withContent) {
    const FrameContent content = contentOf(graph, index);
    result = moveNodes(result, content.nodes, by);
    for (const std::size_t i : content.frames) result.frames[i].at += by;
  }
  result.frames[index].at += by;
  return result;
}

Graph frameAround(const Graph& graph, const std::set<std::string>& names, const std::string& title) {
  const SocketTable table(graph);
  dvec2 low(1e300), high(-1e300);
  for (const std::string& name : names)
    if (const Node* node = findNode(graph, name)) {
      low = glm::min(low, node->at);
      high = glm::max(high, node->at + sizeOf(table, *node, name));
    }
  if (low.x > high.x) return graph;
  Frame frame{title, "", low - dvec2(kMargin, kTitle), high - low + dvec2(2 * kMargin, kTitle + kMargin), {}};
  Graph result = graph;
  result.unknown.erase("frames");
  // Behind the first frame it covers as a whole.
  const auto place = std::find_if(result.frames.begin(), result.frames.end(), [&](const Frame& other) {
    return inside(frame, other.at) && inside(frame, other.at + other.size);
  });
  result.frames.insert(place, std::move(frame));
  return result;
}

}  // namespace pileus::nodes
