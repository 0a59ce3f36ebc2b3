// One node of an evaluation: what arrives, what is cached, what is worked out, and what is left for those
// behind it.
#include <algorithm>
#include <cmath>

#include "nodes/declare/eval_context.h"
#include "nodes/evaluate/evaluator_impl.h"
#include "nodes/graph/graph_sockets.h"
#include "renderer/base/log.h"

namespace pileus::nodes {
namespace {

/// "param: text" becomes "Node.param: text", anything else "Node: text".
std::string located(const std::string& node, const NodeType& type, const std::string& message) {
  const std::string_view head = std::string_view(message).substr(0, message.find(':'));
  const bool named = head.size() < message.size() &&
                     (type.param(head) || type.inputIndex(head) >= 0 || type.outputIndex(head) >= 0);
  return node + (named ? "." : ": ") + message;
}

/// Are its results for parameters, and no more work than reading one?
bool givesNumbers(const NodeType& type) {
  return !type.outputs.empty() &&
         std::all_of(type.outputs.begin(), type.outputs.end(), [](const SocketSpec& output) {
           return output.type == SocketType::Number || output.type == SocketType::Vector ||
                  output.type == SocketType::Color || output.type == SocketType::Text;
         });
}

std::string usesText(unsigned uses) {
  constexpr std::pair<unsigned, std::string_view> kNames[] = {
      {UsesFrame, "frame"},   {UsesSize, "size"}, {UsesQuality, "quality"}, {UsesFreeCamera, "freeCamera"},
      {UsesLayers, "layers"}, {UsesRate, "rate"}, {UsesColors, "colors"}};
  std::string text;
  for (const auto& [bit, name] : kNames)
    if (uses & bit) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace

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
    in.draft = in.draft || run.draft;
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
  run.draft = in.draft;
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
  EvalContext context(*settings, renderer, result.state, key, clock, type.uses, &lasting[name]);
  const Stopwatch watch;
  Result<std::vector<SocketValue>> values = fail(Code::Internal, "not evaluated");
  try {
    values = type.evaluate(in.links, in.params, context);
  } catch (const std::exception& e) {
    values = fail(Code::Internal, "internal error: {}", e.what());
  } catch (...) {
    values = fail(Code::Internal, "internal error: unknown exception");
  }
  if (context.undeclared())
    log::error("{}: internal error: {} reads parts of the context that it does not declare: {}", name,
               type.id, usesText(context.undeclared()));
  ++statuses[name].evaluations;
  result.cpuMs += watch.ms();
  result.gpuMs += context.gpuMs();
  result.bytes = std::max(result.bytes, context.bytes());
  result.warnings = context.warnings();
  result.notes = context.notes();
  result.lastStepped = asking.call;
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
  cache.count(result);
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
    run.draft = from.draft;
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
  for (std::size_t i = 0; i < in.files.size(); ++i) files[in.files[i]] = in.stamps[i];
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

  run.key = contentKey(*type, in, *settings);
  run.draft = in.draft;
  if (settings->quality == Quality::Draft && (type->uses & UsesQuality)) {
    // What is there in full already is better than a draft and costs nothing.
    EvalSettings full = *settings;
    full.quality = Quality::Final;
    const Key key = contentKey(*type, in, full);
    if (cache.finished(key))
      run.key = key;
    else
      run.draft = true;
  }
  CachedResult& result = cache.at(run.key, asking);
  result.passing = run.draft || !in.final;
  const bool isNew = result.lastStepped == 0;
  const bool mayStep = marking
                           ? givesNumbers(*type)
                           : !stepped || clock.ms() < settings->budgetMs || (!isNew && result.waitsForJob);
  if (!result.complete && result.lastStepped != asking.call && mayStep)
    step(name, *type, in, result, run.key);
  if (!result.complete) {
    if (result.lastStepped == asking.call && result.waitsForJob)
      ++waiting;
    else
      workLeft = true;
  }
  publish(name, *type, in, result);
}

}  // namespace pileus::nodes
