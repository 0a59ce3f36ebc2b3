#include "nodes/evaluator.h"

#include <algorithm>
#include <cmath>

#include "nodes/flatten.h"
#include "nodes/graph_sockets.h"
#include "nodes/node_inputs.h"
#include "nodes/result_cache.h"

namespace pileus::nodes {
namespace {

/// What one evaluate() knows about a wanted node.
struct Run {
  Key key;                           ///< zero: not reached
  Values values;                     ///< null: none
  std::vector<Key> outputKeys;       ///< what dependants hash, one per output
  bool final = false;                ///< neither it nor anything upstream can still change
  std::optional<SocketType> passed;  ///< a dot: the type of what it passes
};

const SocketValue* find(const Values& values, const NodeType* type, std::string_view socket) {
  const int i = type ? type->outputIndex(socket) : -1;
  if (!values || i < 0 || static_cast<std::size_t>(i) >= values->size()) return nullptr;
  const SocketValue& value = (*values)[static_cast<std::size_t>(i)];
  return std::holds_alternative<std::monostate>(value) ? nullptr : &value;
}

bool isFailure(NodeState state) { return state == NodeState::Failed || state == NodeState::Skipped; }

/// "param: text" becomes "Node.param: text", anything else "Node: text".
std::string located(const std::string& node, const NodeType& type, const std::string& message) {
  const std::string_view head = std::string_view(message).substr(0, message.find(':'));
  const bool named = head.size() < message.size() &&
                     (type.param(head) || type.inputIndex(head) >= 0 || type.outputIndex(head) >= 0);
  return node + (named ? "." : ": ") + message;
}

}  // namespace

struct Evaluator::Impl {
  view::Renderer* renderer;
  TypeLookup lookup;
  ResultCache cache;
  std::uint64_t call = 0;
  Graph whole;     ///< as last given
  FlatGraph flat;  ///< of it
  const Graph& graph = flat.graph;
  bool flattened = false;
  mutable std::map<std::string, NodeStatus> groupStatuses;   ///< summaries asked for since
  std::map<std::string, std::vector<const Link*>> incoming;  ///< active links of `graph` by target
  std::map<std::string, NodeStatus> statuses;
  std::map<std::string, Run> runs;
  std::map<std::string, Values> lastGood;

  // Of the evaluate() in progress.
  const EvalSettings* settings = nullptr;
  Stopwatch clock;
  bool stepped = false;     ///< the one step that is always done was done
  bool workLeft = false;    ///< an unfinished node could go on at once
  std::size_t waiting = 0;  ///< unfinished nodes that wait for a job

  const NodeType* typeOf(const std::string& node) const {
    const Node* n = findNode(graph, node);
    if (!n) return nullptr;
    static const NodeType* const dot = findNodeType("dot");
    return n->type == "dot" ? dot : lookup(n->type);
  }
  /// What an output gives; a dot that nothing is linked to gives nothing.
  std::optional<SocketType> typeGiven(const NodeType& type, std::size_t output, const std::string& node) {
    if (type.outputs[output].any) return runs[node].passed;
    return type.outputs[output].type;
  }
  /// A group's socket is a dot in the flat graph.
  std::string socketNode(const std::string& node, std::string_view socket) const {
    return flat.groups.contains(node) ? node + "/" + std::string(socket) : node;
  }
  std::string socketName(const std::string& node, std::string_view socket, std::string_view dot) const {
    return std::string(flat.groups.contains(node) ? dot : socket);
  }
  const std::vector<const Link*>& linksInto(const std::string& node) const {
    static const std::vector<const Link*> none;
    const auto it = incoming.find(node);
    return it == incoming.end() ? none : it->second;
  }
  const Link* firstLink(const std::string& node, std::string_view socket) const {
    for (const Link* link : linksInto(node))
      if (link->toSocket == socket) return link;
    return nullptr;
  }

  void take(const Graph& given);
  void visit(const std::string& name);
  void visitDot(const std::string& name);
  const NodeStatus& groupStatus(const std::string& group) const;
  std::optional<Error> gather(const std::string& name, const Node& node, const NodeType& type,
                              NodeInputs& in);
  void passThrough(const NodeType& type, const NodeInputs& in, Run& run);
  void step(const std::string& name, const NodeType& type, const NodeInputs& in, CachedResult& result,
            const Key& key);
  void publish(const std::string& name, const NodeType& type, const NodeInputs& in,
               const CachedResult& result);
  void failed(const std::string& name, NodeState state, Error error) {
    NodeStatus& status = statuses[name];
    status.state = state;
    status.error = std::move(error);
  }
};

Evaluator::Evaluator(view::Renderer* renderer, TypeLookup lookup) : impl_(std::make_unique<Impl>()) {
  impl_->renderer = renderer;
  impl_->lookup = std::move(lookup);
}
Evaluator::~Evaluator() = default;

/// Collects the values, keys and parameters of a node. An error names node and key.
std::optional<Error> Evaluator::Impl::gather(const std::string& name, const Node& node, const NodeType& type,
                                             NodeInputs& in) {
  in.links.resize(type.inputs.size());
  in.keys.resize(type.inputs.size());
  for (const Link* incomingLink : linksInto(name)) {
    const Link& link = *incomingLink;
    const int index = type.inputIndex(link.toSocket), param = type.paramIndex(link.toSocket);
    if (index < 0 && param < 0)
      return fail(Code::Input, "{}.{}: there is no such input", name, link.toSocket);
    const auto i = static_cast<std::size_t>(index);
    const SocketType takes =
        index >= 0 ? type.inputs[i].type : socketType(type.params[static_cast<std::size_t>(param)].type);
    const NodeType* source = typeOf(link.fromNode);
    const int output = source ? source->outputIndex(link.fromSocket) : -1;
    if (output < 0)
      return fail(Code::Input, "{}.{}: {} has no output '{}'", name, link.toSocket, link.fromNode,
                  link.fromSocket);
    const auto o = static_cast<std::size_t>(output);
    const auto gives = typeGiven(*source, o, link.fromNode);
    if (gives && !convertible(*gives, takes))
      return fail(Code::Input, "{}.{}: takes {}, but {}.{} gives {}", name, link.toSocket, enumId(takes),
                  link.fromNode, link.fromSocket, enumId(*gives));
    if (index >= 0 ? !type.inputs[i].many && in.linked.contains(index) : in.paramLinks.contains(param))
      return fail(Code::Input, "{}.{}: takes one link, but has several", name, link.toSocket);
    if (index >= 0)
      in.linked.insert(index);
    else
      in.paramLinks[param] = incomingLink;
    const Run& run = runs[link.fromNode];
    in.final = in.final && run.final;
    if (!run.values || (!run.final && std::isinf(settings->budgetMs))) {
      if (in.waitingFor.empty()) in.waitingFor = link.fromNode;
      continue;
    }
    const SocketValue value = convertedValue((*run.values)[o], takes);
    if (std::holds_alternative<std::monostate>(value)) continue;  // a bypassed node with nothing to pass on
    if (index < 0) {
      in.linkedParams[param] = value;
      continue;
    }
    in.links[i].push_back(value);
    in.keys[i].push_back(run.outputKeys[o]);
  }
  return resolveParams(name, node, type, *settings, in);
}

/// A bypassed node: its first input of the first output's type, under that input's own key.
void Evaluator::Impl::passThrough(const NodeType& type, const NodeInputs& in, Run& run) {
  std::vector<SocketValue> values(type.outputs.size());
  run.outputKeys.assign(type.outputs.size(), Hasher().add("nothing").key());
  run.final = in.final;
  if (!type.outputs.empty()) {
    const auto input = std::find_if(type.inputs.begin(), type.inputs.end(), [&](const SocketSpec& spec) {
      return spec.type == type.outputs[0].type;
    });
    const auto i = static_cast<std::size_t>(input - type.inputs.begin());
    if (input != type.inputs.end() && !in.links[i].empty()) {
      values[0] = joinedValue(in.links[i]);
      run.outputKeys[0] = in.keys[i][0];
      if (in.keys[i].size() > 1) {
        Hasher joined;
        joined.add("joined");
        for (const Key& key : in.keys[i]) joined.add(key);
        run.outputKeys[0] = joined.key();
      }
      run.key = run.outputKeys[0];
    }
  }
  run.values = std::make_shared<const std::vector<SocketValue>>(std::move(values));
}

/// One call of the node's evaluate(); nothing it throws gets past here.
void Evaluator::Impl::step(const std::string& name, const NodeType& type, const NodeInputs& in,
                           CachedResult& result, const Key& key) {
  EvalContext context(*settings, renderer, result.state, key, clock);
  const Stopwatch watch;
  Result<std::vector<SocketValue>> values = fail(Code::Internal, "not evaluated");
  try {
    values = type.evaluate(in.links, in.params, context);
  } catch (const std::exception& e) {
    values = fail(Code::Internal, "internal error: {}", e.what());
  } catch (...) {
    values = fail(Code::Internal, "internal error: unknown exception");
  }
  ++statuses[name].evaluations;
  result.cpuMs += watch.ms();
  result.gpuMs += context.gpuMs();
  result.bytes = std::max(result.bytes, context.bytes());
  result.warnings = context.warnings();
  result.notes = context.notes();
  result.lastStepped = call;
  result.complete = !values || !context.incomplete();
  result.usable = values && context.usable();
  result.revision = context.revision();
  result.fraction = context.fraction();
  result.what = context.what();
  result.waitsForJob = context.waitsForJob();
  if (!values) result.error = values.error();
  if (result.usable)
    result.values = std::make_shared<const std::vector<SocketValue>>(std::move(*values));
  else if (result.complete)
    result.values = nullptr;
  if (result.complete) result.state.reset();
  // Looking after a job costs nothing: it is not the step of real work that each call is owed.
  if (result.complete || !result.waitsForJob) stepped = true;
}

void Evaluator::Impl::publish(const std::string& name, const NodeType& type, const NodeInputs& in,
                              const CachedResult& result) {
  NodeStatus& status = statuses[name];
  Run& run = runs[name];
  status.cpuMs = result.cpuMs;
  status.gpuMs = result.gpuMs;
  status.bytes = result.bytes;
  status.warnings.insert(status.warnings.end(), result.warnings.begin(), result.warnings.end());
  status.notes = result.notes;
  if (result.error) {
    failed(name, NodeState::Failed, {result.error->code, located(name, type, result.error->message)});
    return;
  }
  status.fraction = result.complete ? 1 : result.fraction;
  status.what = result.what;
  status.state = result.values ? (result.complete && in.final ? NodeState::Ready : NodeState::Partial)
                               : NodeState::Pending;
  run.values = result.values;
  run.final = result.complete && in.final;
  if (!result.values) return;
  lastGood[name] = result.values;
  for (std::size_t i = 0; i < type.outputs.size(); ++i) {
    Hasher hash;
    hash.add(run.key).add(i);
    if (!result.complete) hash.add("partial").add(result.revision);
    run.outputKeys.push_back(hash.key());
  }
}

/// A dot passes on what it is given under the same key, so that it changes nothing downstream.
void Evaluator::Impl::visitDot(const std::string& name) {
  Run& run = runs[name];
  NodeStatus& status = statuses[name];
  const auto& links = linksInto(name);
  SocketValue value;
  Key key = Hasher().add("nothing").key();
  run.final = true;
  if (links.size() > 1)
    return failed(name, NodeState::Failed, fail(Code::Input, "{}: takes one link, but has several", name));
  if (!links.empty()) {
    const Link& link = *links.front();
    const NodeType* source = typeOf(link.fromNode);
    const int output = source ? source->outputIndex(link.fromSocket) : -1;
    if (output < 0 || link.toSocket != "in")
      return failed(name, NodeState::Failed,
                    fail(Code::Input, "{}.{}: {} has no output '{}'", name, link.toSocket, link.fromNode,
                         link.fromSocket));
    const auto o = static_cast<std::size_t>(output);
    run.passed = typeGiven(*source, o, link.fromNode);
    const Run& from = runs[link.fromNode];
    if (!from.values || (!from.final && std::isinf(settings->budgetMs))) {
      run.final = false;
      status.state = NodeState::Pending;
      status.fraction = 0;
      status.what = "Waiting for " + link.fromNode;
      return;
    }
    run.final = from.final;
    value = (*from.values)[o];
    key = from.outputKeys[o];
    status.fraction = statuses[link.fromNode].fraction;
  }
  run.key = key;
  run.outputKeys = {key};
  run.values = std::make_shared<const std::vector<SocketValue>>(1, std::move(value));
  lastGood[name] = run.values;
  status.state = run.final ? NodeState::Ready : NodeState::Partial;
}

/// Brings one node up to date; everything upstream has been visited.
void Evaluator::Impl::visit(const std::string& name) {
  const Node& node = *findNode(graph, name);
  if (const auto fault = flat.faults.find(name); fault != flat.faults.end())
    return failed(name, NodeState::Failed, fault->second);
  const NodeType* type = typeOf(name);
  if (!type)
    return failed(name, NodeState::Failed, fail(Code::Input, "{}: unknown node type '{}'", name, node.type));
  for (const Link* link : linksInto(name)) {
    const auto slash = link->fromNode.rfind('/');
    if (!findNode(graph, link->fromNode) && slash != std::string::npos &&
        flat.groups.contains(link->fromNode.substr(0, slash)))
      return failed(name, NodeState::Failed,
                    fail(Code::Input, "{}.{}: {} has no output '{}'", name, link->toSocket,
                         link->fromNode.substr(0, slash), link->fromNode.substr(slash + 1)));
    if (!findNode(graph, link->fromNode))
      return failed(name, NodeState::Failed,
                    fail(Code::Input, "{}.{}: there is no node '{}'", name, link->toSocket, link->fromNode));
    if (const NodeStatus& from = statuses[link->fromNode]; isFailure(from.state)) {
      const std::string& source = from.state == NodeState::Failed ? link->fromNode : from.what;
      const Error error = fail(from.error.code, "{}: skipped, because {} failed", name, source);
      statuses[name].what = source;
      return failed(name, NodeState::Skipped, error);
    }
  }
  if (node.type == "dot") return visitDot(name);
  NodeInputs in;
  if (auto error = gather(name, node, *type, in)) return failed(name, NodeState::Failed, std::move(*error));
  Run& run = runs[name];
  NodeStatus& status = statuses[name];
  status.warnings = in.warnings;
  if (!in.waitingFor.empty()) {
    status.state = NodeState::Pending;
    status.fraction = 0;
    status.what = "Waiting for " + in.waitingFor;
    return;
  }
  if (node.bypass) {
    passThrough(*type, in, run);
    lastGood[name] = run.values;
    status.state = run.final ? NodeState::Ready : NodeState::Partial;
    return;
  }
  for (std::size_t i = 0; i < type->inputs.size(); ++i)
    if (type->inputs[i].required && in.links[i].empty())
      return failed(name, NodeState::Failed,
                    fail(Code::Input, "{}.{}: nothing is linked", name, type->inputs[i].id));

  run.key = contentKey(*type, in, *settings, graph.settings);
  if (settings->quality == Quality::Draft && (type->uses & UsesQuality)) {
    // What is there in full already is better than a draft and costs nothing.
    EvalSettings full = *settings;
    full.quality = Quality::Final;
    const Key key = contentKey(*type, in, full, graph.settings);
    if (cache.finished(key)) run.key = key;
  }
  CachedResult& result = cache.at(run.key, call);
  const bool isNew = result.lastStepped == 0;
  const bool mayStep = !stepped || clock.ms() < settings->budgetMs || (!isNew && result.waitsForJob);
  if (!result.complete && result.lastStepped != call && mayStep) step(name, *type, in, result, run.key);
  if (!result.complete) {
    if (result.lastStepped == call && result.waitsForJob)
      ++waiting;
    else
      workLeft = true;
  }
  publish(name, *type, in, result);
}

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
