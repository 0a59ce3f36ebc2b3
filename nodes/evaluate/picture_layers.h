#pragma once
// Which layers an output asks of the pictures that feed it.
#include <string>

#include "nodes/graph/graph.h"
#include "renderer/view/picture_layer.h"

namespace pileus::nodes {

/// By the parameters of an EXR output; none for any other node.
view::ExtraLayers wantedLayers(const Graph& graph, const std::string& output);

}  // namespace pileus::nodes
