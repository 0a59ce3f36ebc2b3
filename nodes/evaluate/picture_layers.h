#pragma once
// Which layers an output asks of the pictures that feed it, and what they are called in its file.
#include <string>
#include <vector>

#include "nodes/graph/graph.h"
#include "renderer/image/image.h"
#include "renderer/view/picture_layer.h"

namespace pileus::nodes {

class Evaluator;  // evaluator.h

/// By the parameters of an EXR output; none for any other node.
view::ExtraLayers wantedLayers(const Graph& graph, const std::string& output);

/// A picture has a layer for each light that arrives, "light1" and so on, and a soft sun is many of them. As
/// a file it gets one for each light node, the sum of its own, by the node's name: letters, digits and
/// underscores, as other programs take them. Where what is seen of the environments is apart, it gets one for
/// each group of lights, with that. Nothing is rendered again by it. `evaluator`: what it was last
/// asked for is the output. Where it cannot be told whose light is whose, the layers stay.
void nameLightLayers(image::Image& picture, const Evaluator& evaluator, const Graph& graph,
                     const std::string& output);

/// By the index of a light in the picture that feeds `output`: the path of its node. Empty where that cannot
/// be told. `evaluator` as above.
std::vector<std::string> lightNodes(const Evaluator& evaluator, const Graph& graph,
                                    const std::string& output);
/// What a light node is balanced with: the name of its group, or the node's own path where it has none.
std::string lightGroup(const Graph& root, const std::string& path);

/// A layer's name for a node's: never empty, never one that means something else.
std::string layerName(std::string_view node);

}  // namespace pileus::nodes
