#include "nodes/evaluate/picture_layers.h"

namespace pileus::nodes {

view::ExtraLayers wantedLayers(const Graph& graph, const std::string& output) {
  const Node* node = findNode(graph, output);
  const NodeType* type = node ? findNodeType(node->type) : nullptr;
  if (!type || type->id != "output.exr") return {};
  const auto on = [&](const char* id) {
    const ParamSpec* spec = type->param(id);
    const ParamValue value = spec ? paramValue(*node, *spec) : ParamValue(false);
    return std::get_if<bool>(&value) && std::get<bool>(value);
  };
  return {on("depth"), on("lights")};
}

}  // namespace pileus::nodes
