#pragma once
// Scenes on which the curve behind the defaults of shadow maps is measured: three real volumes and three
// clouds apart from each other, each under one sun. They are graphs, so that the same scene is measured here
// and rendered by a process of its own.
#include <filesystem>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"
#include "renderer/shadow/representation.h"

namespace pileus::cli {

inline constexpr const char* kCurveRender = "Render";

struct CurveScene {
  std::string name;
  nodes::Graph graph;  ///< with an extinction map over a pseudometric map as new nodes have them
};

/// Error (Input) where `data` lacks a file.
Result<std::vector<CurveScene>> curveScenes(const std::filesystem::path& data);

/// The defaults of the two nodes.
Result<shadow::ShadowSpec> defaultShadow(const CurveScene& scene);
/// The scene's graph with every parameter of its shadow as in `spec`.
Result<nodes::Graph> withShadow(const CurveScene& scene, const shadow::ShadowSpec& spec);

}  // namespace pileus::cli
