#pragma once
// Node types that shape the graph and compute nothing: dots and groups. They are resolved before evaluation
// (flatten.h, evaluator.h), so that they have sockets of any type and no evaluate() of their own.
#include "nodes/declare/node_type.h"
#include "nodes/declare/value.h"

namespace pileus::nodes {

inline NodeType structureNode(std::string id, std::string label, std::string keywords) {
  NodeType type;
  type.id = std::move(id);
  type.label = std::move(label);
  type.category = "Graph";
  type.keywords = std::move(keywords);
  type.evaluate = [](std::span<const std::vector<SocketValue>>, std::span<const ParamValue>,
                     EvalContext&) -> Result<std::vector<SocketValue>> {
    return fail(Code::Internal, "this node is not evaluated");
  };
  return type;
}

inline void addAny(std::vector<SocketSpec>& sockets, std::string id, std::string label, std::string help) {
  SocketSpec& s = sockets.emplace_back();
  s.id = std::move(id);
  s.label = std::move(label);
  s.help = std::move(help);
  s.any = true;
  s.assign = [](void*, const SocketValue&) {};
  s.read = [](const void*) -> SocketValue { return {}; };
}

}  // namespace pileus::nodes
