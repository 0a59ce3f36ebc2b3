#pragma once
// Shadows of one render node that can be tuned together: nodes of one kind, and the lights they shade.
#include "nodes/shadows/shadow_spec_nodes.h"
#include "renderer/truth/shadow_measure.h"

namespace pileus::nodes {

struct ShadowGroup {
  std::vector<ShadowNodes> nodes;
  std::vector<truth::Caster> casters;  ///< never empty
};

/// Of `renderNode` at `frame`, whose scene this is; ray marches are left out.
std::vector<ShadowGroup> shadowGroups(const Graph& graph, const std::string& renderNode, double frame,
                                      const view::RenderScene& scene);

/// The graph with `spec` in all nodes of the group.
Result<Graph> writeGroup(const Graph& graph, const ShadowGroup& group, const shadow::ShadowSpec& spec);

}  // namespace pileus::nodes
