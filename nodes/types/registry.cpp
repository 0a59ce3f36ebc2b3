// The list of node types, in the order of types/list.inc.
#include <map>

#include "nodes/declare/node_type.h"

namespace pileus::nodes {

#define NODE(name) NodeType node_##name();
#include "nodes/types/list.inc"
#undef NODE

std::span<const NodeType> allNodeTypes() {
  static const std::vector<NodeType> types = [] {
    std::vector<NodeType> list;
#define NODE(name) list.push_back(node_##name());
#include "nodes/types/list.inc"
#undef NODE
    return list;
  }();
  return types;
}

const NodeType* findNodeType(std::string_view id) {
  static const std::map<std::string_view, const NodeType*> byId = [] {
    std::map<std::string_view, const NodeType*> map;
    for (const NodeType& type : allNodeTypes()) map.emplace(type.id, &type);
    return map;
  }();
  const auto it = byId.find(id);
  return it == byId.end() ? nullptr : it->second;
}

}  // namespace pileus::nodes
