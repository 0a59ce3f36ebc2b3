#include "nodes/evaluate/evaluator.h"

#include <algorithm>

#include "nodes/evaluate/evaluator_impl.h"
#include "renderer/base/file.h"
#include "renderer/view/renderer.h"

namespace pileus::nodes {
namespace {

const SocketValue* find(const Values& values, const NodeType* type, std::string_view socket) {
  const int i = type ? type->outputIndex(socket) : -1;
  if (!values || i < 0 || static_cast<std::size_t>(i) >= values->size()) return nullptr;
  const SocketValue& value = (*values)[static_cast<std::size_t>(i)];
  return std::holds_alternative<std::monostate>(value) ? nullptr : &value;
}

bool sameRequest(const EvalSettings& a, const EvalSettings& b) {
  return a.frame == b.frame && a.size == b.size && a.quality == b.quality && a.freeCamera == b.freeCamera &&
         a.folder == b.folder && a.draftPixels == b.draftPixels && a.draftTexels == b.draftTexels &&
         a.layer == b.layer && a.extra == b.extra && a.region == b.region && a.around == b.around &&
         a.fps == b.fps && a.ocio == b.ocio;
}

}  // namespace

Evaluator::Evaluator(view::Renderer* renderer, TypeLookup lookup) : impl_(std::make_unique<Impl>()) {
  impl_->renderer = renderer;
  impl_->lookup = std::move(lookup);
  if (renderer)
    renderer->shadows().setReclaim(this,
                                   [impl = impl_.get()](std::size_t bytes) { return impl->reclaim(bytes); });
}

Evaluator::~Evaluator() {
  if (impl_->renderer) impl_->renderer->shadows().setReclaim(this, nullptr);
}

/// Flattens a graph unless it is the one it was.
bool Evaluator::Impl::take(const Graph& given) {
  if (flattened && whole == given) return false;
  whole = given;
  flat = flatten(whole);
  flattened = true;
  incoming.clear();
  for (const Link& link : flat.graph.links) incoming[link.toNode].push_back(&link);
  std::erase_if(lastGood, [&](const auto& entry) { return !graph.nodes.contains(entry.first); });
  std::erase_if(lasting, [&](const auto& entry) { return !graph.nodes.contains(entry.first); });
  std::erase_if(statuses, [&](const auto& entry) { return !graph.nodes.contains(entry.first); });
  return true;
}

/// What an evaluation begins with.
void Evaluator::Impl::fresh(const std::string& name) {
  runs.erase(name);
  const auto it = statuses.find(name);
  if (it == statuses.end()) return;
  NodeStatus status;
  status.evaluations = it->second.evaluations;
  it->second = std::move(status);
}

/// Notes as wanted what is there already of the nodes from that place on. Numbers and colours are worked out
/// where they are missing, as the keys of others hold them; nothing else is.
void Evaluator::Impl::mark(std::size_t from) {
  if (!order || marked) return;
  const std::size_t place = at;
  const bool did = stepped, left = workLeft;
  const std::size_t waited = waiting;
  marking = true;
  for (at = from; at < order->size(); ++at) visit((*order)[at]);
  for (at = from; at < order->size(); ++at) fresh((*order)[at]);
  marking = false, marked = true;
  at = place, stepped = did, workLeft = left, waiting = waited;
}

/// For the shadow store: maps of old results go, then what others show of them.
bool Evaluator::Impl::reclaim(std::size_t bytes) {
  mark(at + 1);
  const std::size_t before = renderer->shadows().usedBytes();
  bool any = cache.dropMaps(bytes, asking);
  // What is shown of nodes that are being worked out anew, or were not asked for.
  if (before < renderer->shadows().usedBytes() + bytes) {
    const std::size_t entries = lastGood.size();
    std::erase_if(lastGood, [&](const auto& entry) {
      const auto run = runs.find(entry.first);
      return run == runs.end() || run->second.values != entry.second;
    });
    any = any || lastGood.size() < entries;
  }
  if (before < renderer->shadows().usedBytes() + bytes && letGo) any = letGo() || any;
  return any;
}

/// Another one than before, or the same once more.
void Evaluator::Impl::newRequest() {
  ++asking.request;
  answered = false;
  cache.forgetTransientErrors();
  if (cache.limit() > 0) return;
  mark(0);
  cache.dropUnwanted(asking);
  lastGood.clear();
}

EvalReport Evaluator::evaluate(const Graph& given, const std::vector<std::string>& wanted,
                               const EvalSettings& wantedSettings) {
  Impl& self = *impl_;
  const bool isOther = self.take(given);
  const Graph& graph = self.graph;
  EvalSettings settings = wantedSettings;
  settings.fps = given.settings.fps;
  settings.ocio = colorConfigPath(given.settings, settings.folder);
  const bool isNew = self.answered || isOther || wanted != self.targets || !sameRequest(settings, self.asked);
  self.targets = wanted;
  self.asked = settings;
  self.asked.seed.reset();
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
  ++self.asking.call;
  for (const auto& [name, status] : self.statuses) self.fresh(name);
  self.runs.clear();
  self.files.clear();

  EvalReport report;
  const UpstreamOrder upstream = upstreamOrder(graph, targets);
  std::vector<std::string> sound;  // those that do not depend on themselves
  std::copy_if(upstream.order.begin(), upstream.order.end(), std::back_inserter(sound),
               [&](const std::string& name) { return !upstream.cyclic.contains(name); });
  self.order = &sound;
  self.marked = false;
  for (const auto& [name, path] : upstream.cyclic)
    self.failed(name, NodeState::Failed, fail(Code::Input, "{}: cycle: {}", name, path));
  if (isNew) self.newRequest();
  for (self.at = 0; self.at < sound.size(); ++self.at) self.visit(sound[self.at]);

  double sum = 0;
  for (const std::string& name : upstream.order) {
    const NodeStatus& status = self.statuses[name];
    report.failed = report.failed || status.state == NodeState::Failed;
    sum += isFailure(status.state) ? 1 : status.fraction;
  }
  report.complete = !self.workLeft && self.waiting == 0;
  report.waitingForJobs = !self.workLeft && self.waiting > 0;
  report.fraction = upstream.order.empty() ? 1 : sum / static_cast<double>(upstream.order.size());
  self.answered = report.complete;
  self.cache.trim(self.asking, report.complete);
  self.settings = nullptr;
  self.order = nullptr;
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

std::size_t Evaluator::keptBytes() const { return impl_->cache.bytes(); }

bool Evaluator::filesChanged() const {
  return std::any_of(impl_->files.begin(), impl_->files.end(),
                     [](const auto& file) { return fileStamp(file.first) != file.second; });
}

bool Evaluator::readsFiles() const { return !impl_->files.empty(); }

void Evaluator::setLetGo(std::function<bool()> others) { impl_->letGo = std::move(others); }

void Evaluator::forgetNames() { impl_->lastGood.clear(); }

void Evaluator::clear() {
  impl_->cache.clear();
  impl_->runs.clear();
  impl_->lastGood.clear();
}

}  // namespace pileus::nodes
