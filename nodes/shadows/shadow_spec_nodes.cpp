#include "nodes/shadows/shadow_spec_nodes.h"

#include <algorithm>
#include <array>
#include <functional>

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;
using Kind = ShadowSpec::Kind;

struct KindName {
  Kind kind;
  const char* type;
};
constexpr std::array kKinds{
    KindName{Kind::Extinction, "shadow.extinction"}, KindName{Kind::FourierOpacity, "shadow.fourier_opacity"},
    KindName{Kind::TransmittanceFunction, "shadow.transmittance_function"},
    KindName{Kind::Deep, "shadow.deep"}, KindName{Kind::RayMarch, "shadow.ray_march"}};
constexpr int kDefaultResolution = 1024;  ///< of shadow.extinction without a metric

std::optional<Kind> kindOf(std::string_view type) {
  for (const KindName& k : kKinds)
    if (type == k.type) return k.kind;
  return std::nullopt;
}

/// Every parameter of a node type and the member it stands for, walked in one place: by what reads and by
/// what writes.
template <class Spec, class Visit>
void visitMetric(Spec& m, const Visit& visit) {
  visit("representation", m.metric);
  visit("intervals", m.intervals);
  visit("coefficients", m.coefficients);
  visit("resolution", m.resolution);
  visit("storage", m.storage);
  visit("coverage", m.coverage);
  visit("weighting", m.weighting);
  visit("horizon", m.horizon);
  visit("compact", m.compact);
}

template <class Spec, class Visit>
void visitShadow(Spec& s, const Visit& visit) {
  switch (s.kind) {
    case Kind::Extinction:
      visit("basis", s.extinction.basis);
      visit("coefficients", s.extinction.coefficients);
      visit("resolution", s.extinction.resolution);
      visit("storage", s.extinction.storage);
      visit("accumulation", s.extinction.accumulation);
      visit("damping", s.extinction.damping);
      return;
    case Kind::FourierOpacity:
      visit("coefficients", s.coefficients);
      visit("range", s.range);
      visit("damping", s.damping);
      visit("storage", s.storage);
      visit("resolution", s.resolution);
      return;
    case Kind::TransmittanceFunction:
      visit("coefficients", s.coefficients);
      visit("basis", s.basis);
      visit("storage", s.storage);
      visit("resolution", s.resolution);
      return;
    case Kind::Deep:
      visit("error_bound", s.errorBound);
      visit("node_budget", s.nodeBudget);
      visit("filter", s.filter);
      visit("resolution", s.resolution);
      return;
    case Kind::RayMarch:
      visit("step_scale", s.stepScale);
      return;
  }
}

/// Members whose parameter the type lacks keep what they hold.
class Reader {
 public:
  Reader(const Node& node, double frame) : node_(node), type_(findNodeType(node.type)), frame_(frame) {}
  template <class T>
  void operator()(const char* id, T& member) const {
    const ParamSpec* spec = type_ ? type_->param(id) : nullptr;
    if (!spec) return;
    const ParamValue value = paramValue(node_, *spec, frame_);
    if constexpr (DescribedEnum<T>) {
      if (const auto* text = std::get_if<std::string>(&value)) member = enumFromId<T>(*text).value_or(member);
    } else if (const T* v = std::get_if<T>(&value)) {
      member = *v;
    }
  }

 private:
  const Node& node_;
  const NodeType* type_;
  double frame_;
};

/// Sets what differs from what the node says.
class Writer {
 public:
  Writer(Graph graph, std::string node) : graph_(std::move(graph)), node_(std::move(node)) {}
  template <class T>
  void operator()(const char* id, const T& member) const {
    if (error_) return;
    ParamValue value;
    if constexpr (DescribedEnum<T>)
      value = std::string(enumId(member));
    else
      value = member;
    auto edited = setParam(graph_, node_, id, value);
    if (edited)
      graph_ = std::move(edited).value();
    else
      error_ = edited.error();
  }
  Result<Graph> finish() && {
    if (error_) return *error_;
    return std::move(graph_);
  }

 private:
  mutable Graph graph_;
  std::string node_;
  mutable std::optional<Error> error_;
};

const Link* linkInto(const Graph& graph, const std::string& node, std::string_view socket) {
  for (const Link& l : graph.links)
    if (!l.muted && l.toNode == node && l.toSocket == socket) return &l;
  return nullptr;
}

}  // namespace

Result<ShadowNodes> readShadow(const Graph& graph, const std::string& name, double frame) {
  const Node* node = findNode(graph, name);
  const auto kind = node ? kindOf(node->type) : std::nullopt;
  if (!kind) return fail(Code::Input, "{}: is no shadow node", name);
  ShadowNodes out{name, "", {}};
  out.spec.kind = *kind;
  visitShadow(out.spec, Reader(*node, frame));
  if (*kind != Kind::Extinction) return out;
  out.spec.metric.metric = shadow::Metric::None;
  if (const Link* link = linkInto(graph, name, "metric"))
    if (const Node* metric = findNode(graph, link->fromNode);
        metric && metric->type == "shadow.pseudometric") {
      out.metric = link->fromNode;
      visitMetric(out.spec.metric, Reader(*metric, frame));
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
    if (kindOf(node->type) && !node->bypass && name != renderNode) {
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
  if (!node || kindOf(node->type) != wanted.kind)
    return fail(Code::Arguments, "{}: is no node for {}", shadow.node, shadow::describe(wanted));
  ShadowSpec spec = wanted;
  Graph edited = graph;
  if (spec.kind == Kind::Extinction) {
    if (shadow.metric.empty() != (spec.metric.metric == shadow::Metric::None))
      return fail(
          Code::Arguments, "{}: {}", shadow.node,
          shadow.metric.empty() ? "has no pseudometric to write to" : "its pseudometric cannot become none");
    if (!shadow.metric.empty()) {
      Writer metric(std::move(edited), shadow.metric);
      visitMetric(std::as_const(spec.metric), metric);
      PILEUS_TRY(edited, std::move(metric).finish());
      if (spec.extinction.resolution == spec.metric.resolution) spec.extinction.resolution = 0;
    }
  }
  Writer writer(std::move(edited), shadow.node);
  visitShadow(std::as_const(spec), writer);
  return std::move(writer).finish();
}

}  // namespace pileus::nodes
