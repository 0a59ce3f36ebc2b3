#pragma once
// What an exported still says about itself in its EXR header.
#include <filesystem>
#include <map>
#include <string>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

/// "software", "pileus:workingSpace", "pileus:graph" (hash of the graph's text) and the text itself, with
/// file names as seen from `target` (relative ones start in `folder`): a still dropped on the window opens
/// its graph.
std::map<std::string, std::string> stillMetadata(const Graph& graph, const std::filesystem::path& target,
                                                 const std::filesystem::path& folder);

}  // namespace pileus::nodes
