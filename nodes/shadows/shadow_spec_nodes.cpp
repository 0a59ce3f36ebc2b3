#include "nodes/shadows/shadow_spec_nodes.h"

#include <algorithm>
#include <functional>

#include "nodes/shadows/shadow_inputs.h"

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;
using Kind = ShadowSpec::Kind;

constexpr int kDefaultResolution = 1024;  ///< of shadow.extinction without a metric

/// The In of a node type, as a node begins with it; null where the type has another.
template <class In>
const In* defaultsOf(const Node& node) {
  const NodeType* type = findNodeType(node.type);
  return type ? std::any_cast<In>(&type->defaults) : nullptr;
}

std::optional<Kind> kindOf(const Node& node) {
  const ShadowIn* defaults = defaultsOf<ShadowIn>(node);
  return defaults ? std::optional(defaults->spec.kind) : std::nullopt;
}

/// What the node's parameters say at a frame.
template <class In>
std::optional<In> read(const Node& node, double frame) {
  const In* defaults = defaultsOf<In>(node);
  if (!defaults) return std::nullopt;
  In in = *defaults;
  for (const ParamSpec& spec : findNodeType(node.type)->params) spec.set(&in, paramValue(node, spec, frame));
  return in;
}

/// The graph with these parameters in a node whose type has this In.
template <class In>
Result<Graph> written(Graph graph, const std::string& name, const In& in) {
  const Node* node = findNode(graph, name);
  if (!node || !defaultsOf<In>(*node)) return fail(Code::Arguments, "there is no node '{}' for this", name);
  for (const ParamSpec& spec : findNodeType(node->type)->params) {
    PILEUS_TRY(graph, setParam(graph, name, spec.id, spec.get(&in)));
  }
  return graph;
}

const Link* linkInto(const Graph& graph, const std::string& node, std::string_view socket) {
  for (const Link& l : graph.links)
    if (!l.muted && l.toNode == node && l.toSocket == socket) return &l;
  return nullptr;
}

}  // namespace

Result<ShadowNodes> readShadow(const Graph& graph, const std::string& name, double frame) {
  const Node* node = findNode(graph, name);
  const auto in = node ? read<ShadowIn>(*node, frame) : std::nullopt;
  if (!in) return fail(Code::Input, "{}: is no shadow node", name);
  ShadowNodes out{name, "", in->spec};
  if (out.spec.kind != Kind::Extinction) return out;
  out.spec.metric.metric = shadow::Metric::None;
  if (const Link* link = linkInto(graph, name, "metric"))
    if (const Node* from = findNode(graph, link->fromNode))
      if (const auto metric = read<MetricIn>(*from, frame)) {
        out.metric = link->fromNode;
        out.spec.metric = metric->metric;
      }
  // 0: the metric's.
  if (out.spec.extinction.resolution == 0)
    out.spec.extinction.resolution = out.metric.empty() ? kDefaultResolution : out.spec.metric.resolution;
  if (out.metric.empty()) out.spec.metric.resolution = out.spec.extinction.resolution;
  return out;
}

std::vector<ShadowNodes> shadowsOf(const Graph& graph, const std::string& renderNode, double frame) {
  std::vector<ShadowNodes> out;
  std::set<std::string> seen;
  const std::function<void(const std::string&)> visit = [&](const std::string& name) {
    const Node* node = findNode(graph, name);
    if (!node || !seen.insert(name).second) return;
    if (kindOf(*node) && !node->bypass && name != renderNode) {
      if (auto shadow = readShadow(graph, name, frame)) out.push_back(std::move(shadow).value());
      return;
    }
    const NodeType* type = findNodeType(node->type);
    for (const Link& l : graph.links) {
      if (l.muted || l.toNode != name || !type) continue;
      const int input = type->inputIndex(l.toSocket);
      if (input >= 0 && (type->inputs[std::size_t(input)].any ||
                         type->inputs[std::size_t(input)].type == SocketType::Light))
        visit(l.fromNode);
    }
  };
  visit(renderNode);
  return out;
}

Result<Graph> writeShadow(const Graph& graph, const ShadowNodes& shadow, const ShadowSpec& wanted) {
  const Node* node = findNode(graph, shadow.node);
  if (!node || kindOf(*node) != wanted.kind)
    return fail(Code::Arguments, "{}: is no node for {}", shadow.node, shadow::describe(wanted));
  ShadowSpec spec = wanted;
  Graph edited = graph;
  if (spec.kind == Kind::Extinction) {
    if (shadow.metric.empty() != (spec.metric.metric == shadow::Metric::None))
      return fail(
          Code::Arguments, "{}: {}", shadow.node,
          shadow.metric.empty() ? "has no pseudometric to write to" : "its pseudometric cannot become none");
    if (!shadow.metric.empty()) {
      MetricIn metric;
      metric.metric = spec.metric;
      PILEUS_TRY(edited, written(std::move(edited), shadow.metric, metric));
      if (spec.extinction.resolution == spec.metric.resolution) spec.extinction.resolution = 0;
    }
  }
  ShadowIn in;
  in.spec = spec;
  return written(std::move(edited), shadow.node, in);
}

}  // namespace pileus::nodes
