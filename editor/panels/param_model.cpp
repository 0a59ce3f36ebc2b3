#include "editor/panels/param_model.h"

#include <algorithm>

namespace pileus::editor::model {
namespace {

using nodes::Node;
using nodes::ParamSpec;
using nodes::ParamType;
using nodes::ParamValue;

template <class Change>
Graph changed(const Graph& graph, const std::string& name, Change change) {
  Graph next = graph;
  auto node = std::make_shared<Node>(*graph.nodes.at(name));
  change(*node);
  next.nodes[name] = std::move(node);
  return next;
}

}  // namespace

Result<Graph> setParamAt(const Graph& graph, const std::string& node, const ParamSpec& spec,
                         const ParamValue& value, int frame) {
  const Node* n = nodes::findNode(graph, node);
  if (n && n->animated.contains(spec.id)) return setKey(graph, node, spec, value, frame);
  return nodes::setParam(graph, node, spec.id, value);
}

Result<Graph> setKey(const Graph& graph, const std::string& node, const ParamSpec& spec,
                     const ParamValue& value, int frame) {
  PILEUS_TRY(const ParamValue checked, nodes::checkedParam(spec, value));
  return changed(graph, node, [&](Node& n) {
    n.params.erase(spec.id);
    std::vector<nodes::AnimationKey>& keys = n.animated[spec.id].keys;
    const auto at = std::lower_bound(keys.begin(), keys.end(), frame,
                                     [](const nodes::AnimationKey& k, int f) { return k.frame < f; });
    if (at != keys.end() && at->frame == frame)
      at->value = checked;
    else
      keys.insert(at, {static_cast<double>(frame), checked});
  });
}

Result<Graph> removeKey(const Graph& graph, const std::string& node, const ParamSpec& spec, int frame) {
  const Node* n = nodes::findNode(graph, node);
  if (!n || !n->animated.contains(spec.id)) return graph;
  if (n->animated.at(spec.id).keys.size() <= 1) return clearAnimation(graph, node, spec, frame);
  return changed(graph, node, [&](Node& m) {
    std::erase_if(m.animated[spec.id].keys, [&](const nodes::AnimationKey& k) { return k.frame == frame; });
  });
}

Result<Graph> clearAnimation(const Graph& graph, const std::string& node, const ParamSpec& spec, int frame) {
  const Node* n = nodes::findNode(graph, node);
  if (!n || !n->animated.contains(spec.id)) return graph;
  return nodes::setParam(graph, node, spec.id, nodes::paramValue(*n, spec, frame));
}

Result<Graph> resetParams(const Graph& graph, const std::string& node) {
  return changed(graph, node, [](Node& n) {
    n.params.clear();
    n.animated.clear();
    std::erase_if(n.unknown, [](const auto& u) { return u.first.starts_with("params/"); });
  });
}

Result<Graph> exposeParam(const Graph& graph, const std::string& node, const ParamSpec& spec, bool on) {
  return changed(graph, node, [&](Node& n) {
    std::erase(n.expose, spec.id);
    if (on) n.expose.push_back(spec.id);
  });
}

bool canExpose(const ParamSpec& spec) {
  return spec.type == ParamType::Float || spec.type == ParamType::Int || spec.type == ParamType::Vector ||
         spec.type == ParamType::Color || spec.type == ParamType::Text;
}

}  // namespace pileus::editor::model
