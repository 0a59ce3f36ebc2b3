#pragma once
// Shadow nodes as the description the renderer's comparisons and searches work with, and back: parameters
// only, never nodes or links.
#include <string>
#include <vector>

#include "nodes/graph/graph.h"
#include "renderer/shadow/representation.h"

namespace pileus::nodes {

/// One shadow of a render node.
struct ShadowNodes {
  std::string node;    ///< shadow.extinction, shadow.fourier_opacity, shadow.transmittance_function,
                       ///< shadow.deep, shadow.ray_march
  std::string metric;  ///< shadow.pseudometric that feeds a shadow.extinction; "" without one
  shadow::ShadowSpec spec;
};

/// What `node` and, for a shadow.extinction, the pseudometric linked to it say at `frame`. Error (Input)
/// where it is no shadow node.
Result<ShadowNodes> readShadow(const Graph& graph, const std::string& node, double frame = 1);

/// The shadows that reach the lights of `renderNode`, in the order of its links; muted links and bypassed
/// shadows left out.
std::vector<ShadowNodes> shadowsOf(const Graph& graph, const std::string& renderNode, double frame = 1);

/// `spec` written into those nodes; animated parameters among them become constant. Error (Arguments): a spec
/// of another kind, a metric without a node for it, or a value outside its range.
Result<Graph> writeShadow(const Graph& graph, const ShadowNodes& shadow, const shadow::ShadowSpec& spec);

}  // namespace pileus::nodes
