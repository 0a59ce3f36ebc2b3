#include "nodes/evaluate/evaluator.h"

#include <algorithm>

#include "nodes/evaluate/evaluator_impl.h"

namespace pileus::nodes {
namespace {

const SocketValue* find(const Values& values, const NodeType* type, std::string_view socket) {
  const int i = type ? type->outputIndex(socket) : -1;
  if (!values || i < 0 || static_cast<std::size_t>(i) >= values->size()) return nullptr;
  const SocketValue& value = (*values)[static_cast<std::size_t>(i)];
  return std::holds_alternative<std::monostate>(value) ? nullptr : &value;
}

}  // namespace

Evaluator::Evaluator(view::Renderer* renderer, TypeLookup lookup) : impl_(std::make_unique<Impl>()) {
  impl_->renderer = renderer;
  impl_->lookup = std::move(lookup);
}
Evaluator::~Evaluator() = default;

/// Flattens a graph unless it is the one it was.
void Evaluator::Impl::take(const Graph& given) {
  if (flattened && whole == given) return;
  whole = given;
  flat = flatten(whole);
  flattened = true;
  incoming.clear();
  for (const Link& link : flat.graph.links) incoming[link.toNode].push_back(&link);
  std::erase_if(lastGood, [&](const auto& entry) { return !graph.nodes.contains(entry.first); });
  std::erase_if(statuses, [&](const auto& entry) { return !graph.nodes.contains(entry.first); });
}

EvalReport Evaluator::evaluate(const Graph& given, const std::vector<std::string>& wanted,
                               const EvalSettings& wantedSettings) {
  Impl& self = *impl_;
  self.take(given);
  const Graph& graph = self.graph;
  EvalSettings settings = wantedSettings;
  settings.fps = given.settings.fps;
  std::vector<std::string> targets;
  for (const std::string& target : wanted) {
    if (!self.flat.groups.contains(target))
      targets.push_back(target);
    else
      for (auto it = graph.nodes.lower_bound(target + "/");
           it != graph.nodes.end() && it->first.starts_with(target + "/"); ++it)
        if (it->first.find('/', target.size() + 1) == std::string::npos && it->second->type == "dot")
          targets.push_back(it->first);
  }
  self.settings = &settings;
  self.groupStatuses.clear();
  self.clock.restart();
  self.stepped = self.workLeft = false;
  self.waiting = 0;
  ++self.call;
  for (auto& [name, status] : self.statuses) {
    NodeStatus fresh;
    fresh.evaluations = status.evaluations;
    status = std::move(fresh);
  }
  self.runs.clear();

  EvalReport report;
  const UpstreamOrder upstream = upstreamOrder(graph, targets);
  for (const auto& [name, path] : upstream.cyclic)
    self.failed(name, NodeState::Failed, fail(Code::Input, "{}: cycle: {}", name, path));
  for (const std::string& name : upstream.order)
    if (!upstream.cyclic.contains(name)) self.visit(name);

  double sum = 0;
  for (const std::string& name : upstream.order) {
    const NodeStatus& status = self.statuses[name];
    report.failed = report.failed || status.state == NodeState::Failed;
    sum += isFailure(status.state) ? 1 : status.fraction;
  }
  report.complete = !self.workLeft && self.waiting == 0;
  report.waitingForJobs = !self.workLeft && self.waiting > 0;
  report.fraction = upstream.order.empty() ? 1 : sum / static_cast<double>(upstream.order.size());
  self.cache.trim(self.call);
  self.settings = nullptr;
  return report;
}

const NodeStatus& Evaluator::Impl::groupStatus(const std::string& group) const {
  const auto [place, isNew] = groupStatuses.try_emplace(group);
  NodeStatus& sum = place->second;
  if (!isNew) return sum;
  const auto badness = [](NodeState state) {
    switch (state) {
      case NodeState::Idle:
        return 0;
      case NodeState::Ready:
        return 1;
      case NodeState::Partial:
        return 2;
      case NodeState::Pending:
        return 3;
      case NodeState::Skipped:
        return 4;
      case NodeState::Failed:
        return 5;
    }
    return 0;
  };
  double fractions = 0;
  int running = 0;
  const std::string prefix = group + "/";
  for (auto it = statuses.lower_bound(prefix); it != statuses.end() && it->first.starts_with(prefix); ++it) {
    const NodeStatus& s = it->second;
    const bool worse = badness(s.state) > badness(sum.state);
    if (worse) sum.state = s.state;
    if (worse && isFailure(s.state)) sum.error = s.error;
    if (worse || sum.what.empty()) sum.what = s.what;
    for (const std::string& warning : s.warnings)
      sum.warnings.push_back(it->first.substr(prefix.size()) + ": " + warning);
    sum.cpuMs += s.cpuMs;
    sum.gpuMs += s.gpuMs;
    sum.bytes += s.bytes;
    sum.evaluations += s.evaluations;
    if (s.state == NodeState::Partial || s.state == NodeState::Pending) fractions += s.fraction, ++running;
  }
  if (running > 0) sum.fraction = fractions / running;
  return sum;
}

const NodeStatus& Evaluator::status(const std::string& node) const {
  static const NodeStatus idle;
  if (impl_->flat.groups.contains(node)) return impl_->groupStatus(node);
  const auto it = impl_->statuses.find(node);
  return it == impl_->statuses.end() ? idle : it->second;
}

const SocketValue* Evaluator::output(const std::string& name, std::string_view socket) const {
  const std::string node = impl_->socketNode(name, socket);
  const auto it = impl_->runs.find(node);
  return it == impl_->runs.end()
             ? nullptr
             : find(it->second.values, impl_->typeOf(node), impl_->socketName(name, socket, "out"));
}

const SocketValue* Evaluator::input(const std::string& node, std::string_view socket) const {
  const Link* link = impl_->firstLink(impl_->socketNode(node, socket), impl_->socketName(node, socket, "in"));
  return link ? output(link->fromNode, link->fromSocket) : nullptr;
}

const SocketValue* Evaluator::lastGood(const std::string& name, std::string_view socket) const {
  const std::string node = impl_->socketNode(name, socket);
  const auto it = impl_->lastGood.find(node);
  return it == impl_->lastGood.end()
             ? nullptr
             : find(it->second, impl_->typeOf(node), impl_->socketName(name, socket, "out"));
}

const SocketValue* Evaluator::lastGoodInput(const std::string& node, std::string_view socket) const {
  const Link* link = impl_->firstLink(impl_->socketNode(node, socket), impl_->socketName(node, socket, "in"));
  return link ? lastGood(link->fromNode, link->fromSocket) : nullptr;
}

Key Evaluator::key(const std::string& node) const {
  const auto it = impl_->runs.find(node);
  return it == impl_->runs.end() ? Key{} : it->second.key;
}

void Evaluator::setCacheLimit(std::size_t bytes) { impl_->cache.setLimit(bytes); }

void Evaluator::clear() {
  impl_->cache.clear();
  impl_->runs.clear();
  impl_->lastGood.clear();
}

}  // namespace pileus::nodes
