#pragma once
// Edits of frames: titled rectangles that carry the nodes inside them. An index that is out of range changes
// nothing.
#include <set>
#include <string>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

/// What belongs to a frame: nodes whose centre lies inside, and frames that lie inside as a whole.
struct FrameContent {
  std::set<std::string> nodes;
  std::set<std::size_t> frames;
};
FrameContent contentOf(const Graph& graph, std::size_t frame);

Graph addFrame(const Graph& graph, Frame frame);  ///< in front of the others
Graph removeFrame(const Graph& graph, std::size_t index);
Graph setFrame(const Graph& graph, std::size_t index, Frame frame);
Graph moveFrame(const Graph& graph, std::size_t index, dvec2 by, bool withContent = true);
/// A frame around nodes, behind the frames it would cover. Without nodes nothing changes.
Graph frameAround(const Graph& graph, const std::set<std::string>& names, const std::string& title);

/// A node's size on the canvas, from its sockets: what "inside" means.
dvec2 nodeSize(const Graph& graph, const std::string& node);

}  // namespace pileus::nodes
