#pragma once
// Pictures of light from everywhere become lights: the nodes that do it, added to a graph. Pure: no window,
// no GPU.
#include <filesystem>
#include <string>

#include "nodes/graph/graph.h"

namespace pileus::editor {

struct EnvironmentScene {
  nodes::Graph graph;
  std::string node;  ///< the new environment
};

/// An Environment of that file that lights the first render, where there is one: a Volume Render through
/// shadow maps of its own of what it draws (128 texels: what they stand for is wide), a Path Trace at once.
Result<EnvironmentScene> addEnvironment(const nodes::Graph& graph, const std::filesystem::path& file);

}  // namespace pileus::editor
