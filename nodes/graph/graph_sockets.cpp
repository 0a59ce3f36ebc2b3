#include "nodes/graph/graph_sockets.h"

#include <algorithm>

#include "nodes/graph/graph_groups.h"

namespace pileus::nodes {
namespace {

using Found = std::optional<SocketType>;

SocketInfo infoOf(const SocketSpec& s) {
  return {s.id, s.label, s.help, s.type, s.many, s.required, true, s.any, false};
}

/// A type that can be linked to all of these.
bool commonSource(const std::vector<SocketType>& takers) {
  return std::any_of(takers.begin(), takers.end(),
                     [&](SocketType from) {
                       return std::all_of(takers.begin(), takers.end(),
                                          [&](SocketType to) { return convertible(from, to); });
                     }) ||
         std::all_of(takers.begin(), takers.end(),
                     [](SocketType to) { return convertible(SocketType::Number, to); });
}

/// A node type that takes `from` and gives `to`: what the user may have meant to put between.
const NodeType* bridge(SocketType from, SocketType to) {
  for (const NodeType& type : allNodeTypes())
    for (const SocketSpec& in : type.inputs)
      if (!in.any && convertible(from, in.type))
        for (const SocketSpec& out : type.outputs)
          if (!out.any && convertible(out.type, to)) return &type;
  return nullptr;
}

std::string_view labelOf(SocketType type) {
  for (const auto& item : enumInfo(static_cast<SocketType*>(nullptr)))
    if (item.value == type) return item.label;
  return "?";
}

}  // namespace

bool isSocket(const Node& node, const ParamSpec& spec) {
  if (constantOnly(spec.type)) return false;
  return spec.socket || std::find(node.expose.begin(), node.expose.end(), spec.id) != node.expose.end();
}

bool passesThrough(std::string_view type) {
  return type == "dot" || type == "group.input" || type == "group.output";
}

/// Follows links through dots and groups to what decides a type.
struct TypeTracer {
  /// Where a value comes from: its type, or the input of the graph around it ("": nothing linked).
  struct Origin {
    Found type;
    std::string groupInput;
  };
  // Deep enough for every graph that is meant; a cycle of dots in a faulty file ends here.
  static constexpr int kDeepest = 256;

  static Origin origin(const SocketTable& t, const std::string& node, const std::string& socket,
                       int depth = 0) {
    const Node* n = findNode(*t.graph_, node);
    if (!n || depth > kDeepest) return {};
    if (n->type == "group.input") return {std::nullopt, node};
    if (n->type == "dot") return originInto(t, node, "in", depth + 1);
    if (n->group) {
      if (!findNode(*n->group, socket)) return {};
      const SocketTable inner(*n->group);
      const Origin from = originInto(inner, socket, "in", depth + 1);
      return from.groupInput.empty() ? from : originInto(t, node, from.groupInput, depth + 1);
    }
    const NodeType* type = findNodeType(n->type);
    const int i = type ? type->outputIndex(socket) : -1;
    if (i < 0) return {};
    return {type->outputs[static_cast<std::size_t>(i)].type, ""};
  }

  static Origin originInto(const SocketTable& t, const std::string& node, const std::string& socket,
                           int depth) {
    for (const Link* link : t.into(node))
      if (link->toSocket == socket) return origin(t, link->fromNode, link->fromSocket, depth + 1);
    return {};
  }

  /// The types that everything behind an input takes; `outputs`: the graph's own outputs reached.
  static void takers(const SocketTable& t, const std::string& node, const std::string& socket,
                     std::vector<SocketType>& types, std::vector<std::string>& outputs, int depth = 0) {
    const Node* n = findNode(*t.graph_, node);
    if (!n || depth > kDeepest) return;
    if (n->type == "group.output") {
      outputs.push_back(node);
    } else if (n->type == "dot") {
      takersOf(t, node, "out", types, outputs, depth + 1);
    } else if (n->group) {
      if (!findNode(*n->group, socket)) return;
      const SocketTable inner(*n->group);
      std::vector<std::string> through;
      takersOf(inner, socket, "out", types, through, depth + 1);
      for (const std::string& out : through) takersOf(t, node, out, types, outputs, depth + 1);
    } else if (const NodeType* type = findNodeType(n->type)) {
      if (const int i = type->inputIndex(socket); i >= 0)
        types.push_back(type->inputs[static_cast<std::size_t>(i)].type);
      else if (const ParamSpec* spec = type->param(socket))
        types.push_back(socketType(spec->type));
    }
  }

  static void takersOf(const SocketTable& t, const std::string& node, const std::string& socket,
                       std::vector<SocketType>& types, std::vector<std::string>& outputs, int depth) {
    for (const Link* link : t.outOf(node))
      if (link->fromSocket == socket) takers(t, link->toNode, link->toSocket, types, outputs, depth + 1);
  }

  static std::vector<SocketType> takersOfOutput(const SocketTable& t, const std::string& node,
                                                const std::string& socket) {
    std::vector<SocketType> types;
    std::vector<std::string> outputs;
    takersOf(t, node, socket, types, outputs, 0);
    return types;
  }
  static std::vector<SocketType> takersOfInput(const SocketTable& t, const std::string& node,
                                               const std::string& socket) {
    std::vector<SocketType> types;
    std::vector<std::string> outputs;
    takers(t, node, socket, types, outputs);
    return types;
  }

  /// Decides the type of a socket that has none of its own.
  static void settle(const SocketTable& t, const std::string& node, SocketInfo& info, bool input) {
    const Node* n = findNode(*t.graph_, node);
    const std::string_view type = n->type;
    Origin from;
    std::vector<SocketType> to;
    if (type == "dot" || (n->group && input)) {
      from = type == "dot" ? origin(t, node, "out") : originInto(t, node, info.id, 0);
      to = type == "dot" ? takersOfOutput(t, node, "out") : takersOfInput(t, node, info.id);
      // Inside a group decides what it takes; outside may be linked to anything else.
      if (n->group && !to.empty()) from = {};
    } else if (input) {
      from = originInto(t, node, info.id, 0);
    } else {
      from = origin(t, node, info.id);
      if (!from.type) to = takersOfOutput(t, node, info.id);
    }
    info.any = !from.type && to.empty();
    info.type = from.type ? *from.type : to.empty() ? SocketType::Number : to.front();
  }
};

SocketTable::SocketTable(const Graph& graph) : graph_(&graph) {
  for (const Link& link : graph.links) {
    into_[link.toNode].push_back(&link);
    outOf_[link.fromNode].push_back(&link);
  }
}

const std::vector<const Link*>& SocketTable::into(const std::string& node) const {
  static const std::vector<const Link*> none;
  const auto it = into_.find(node);
  return it == into_.end() ? none : it->second;
}

const std::vector<const Link*>& SocketTable::outOf(const std::string& node) const {
  static const std::vector<const Link*> none;
  const auto it = outOf_.find(node);
  return it == outOf_.end() ? none : it->second;
}

std::vector<SocketInfo> SocketTable::inputs(const std::string& node) const {
  std::vector<SocketInfo> list;
  const Node* n = findNode(*graph_, node);
  if (!n) return list;
  if (n->type == "group") {
    if (n->group)
      for (const std::string& name : groupInputs(*n->group))
        list.push_back({name, name, findNode(*n->group, name)->label, {}, false, false, true, true, false});
  } else if (const NodeType* type = findNodeType(n->type)) {
    for (const SocketSpec& s : type->inputs) list.push_back(infoOf(s));
    for (const ParamSpec& p : type->params)
      if (isSocket(*n, p))
        list.push_back({p.id, p.label, p.help, socketType(p.type), false, false, true, false, true});
  } else {
    for (const Link* link : into(node))
      if (std::none_of(list.begin(), list.end(), [&](const SocketInfo& s) { return s.id == link->toSocket; }))
        list.push_back(
            {link->toSocket, link->toSocket, "", SocketType::Text, true, false, false, false, false});
  }
  for (SocketInfo& info : list)
    if (info.any) TypeTracer::settle(*this, node, info, true);
  return list;
}

std::vector<SocketInfo> SocketTable::outputs(const std::string& node) const {
  std::vector<SocketInfo> list;
  const Node* n = findNode(*graph_, node);
  if (!n) return list;
  if (n->type == "group") {
    if (n->group)
      for (const std::string& name : groupOutputs(*n->group))
        list.push_back({name, name, findNode(*n->group, name)->label, {}, false, false, true, true, false});
  } else if (const NodeType* type = findNodeType(n->type)) {
    for (const SocketSpec& s : type->outputs) list.push_back(infoOf(s));
  } else {
    for (const Link* link : outOf(node))
      if (std::none_of(list.begin(), list.end(),
                       [&](const SocketInfo& s) { return s.id == link->fromSocket; }))
        list.push_back(
            {link->fromSocket, link->fromSocket, "", SocketType::Text, false, false, false, false, false});
  }
  for (SocketInfo& info : list)
    if (info.any) TypeTracer::settle(*this, node, info, false);
  return list;
}

std::optional<SocketInfo> SocketTable::input(const std::string& node, std::string_view socket) const {
  for (SocketInfo& info : inputs(node))
    if (info.id == socket) return std::move(info);
  return std::nullopt;
}

std::optional<SocketInfo> SocketTable::output(const std::string& node, std::string_view socket) const {
  for (SocketInfo& info : outputs(node))
    if (info.id == socket) return std::move(info);
  return std::nullopt;
}

std::optional<std::string> SocketTable::refusal(const Link& link) const {
  const Node* from = findNode(*graph_, link.fromNode);
  const Node* to = findNode(*graph_, link.toNode);
  if (!from) return fmt::format("there is no node '{}'", link.fromNode);
  if (!to) return fmt::format("there is no node '{}'", link.toNode);
  const NodeType* fromType = findNodeType(from->type);
  const NodeType* toType = findNodeType(to->type);
  if (!fromType) return fmt::format("{} is of the unknown type '{}'", link.fromNode, from->type);
  if (!toType) return fmt::format("{} is of the unknown type '{}'", link.toNode, to->type);
  if (!output(link.fromNode, link.fromSocket))
    return fmt::format("{} has no output '{}'", link.fromNode, link.fromSocket);
  if (!toType->param(link.toSocket) && !input(link.toNode, link.toSocket))
    return fmt::format("{} has no input '{}'", link.toNode, link.toSocket);
  if (const ParamSpec* spec = toType->param(link.toSocket); spec && constantOnly(spec->type))
    return fmt::format("{}.{} takes no link", link.toNode, link.toSocket);

  const Found gives = TypeTracer::origin(*this, link.fromNode, link.fromSocket).type;
  std::vector<SocketType> takers = TypeTracer::takersOfInput(*this, link.toNode, link.toSocket);
  if (gives) {
    for (const SocketType takes : takers) {
      if (convertible(*gives, takes)) continue;
      std::string text = fmt::format("{} takes {}, not {}", link.toNode, labelOf(takes), labelOf(*gives));
      if (const NodeType* helper = bridge(*gives, takes))
        text += fmt::format(": put a {} node between", helper->label);
      return text;
    }
  } else if (!takers.empty()) {
    const auto others = TypeTracer::takersOfOutput(*this, link.fromNode, link.fromSocket);
    takers.insert(takers.end(), others.begin(), others.end());
    if (!commonSource(takers))
      return fmt::format("{} takes {}, but {} already goes to {}", link.toNode, labelOf(takers.front()),
                         link.fromNode, labelOf(takers.back()));
  }

  // A path from the target back to the source would become a cycle.
  std::map<std::string_view, std::string_view> cameFrom{{link.toNode, ""}};
  std::vector<std::string_view> open{link.toNode};
  for (std::size_t i = 0; i < open.size() && !cameFrom.contains(link.fromNode); ++i)
    if (const auto it = outOf_.find(open[i]); it != outOf_.end())
      for (const Link* next : it->second)
        if (cameFrom.emplace(next->toNode, open[i]).second) open.push_back(next->toNode);
  if (!cameFrom.contains(link.fromNode)) return std::nullopt;
  std::string path = link.toNode;
  for (std::string_view name = link.fromNode; name != link.toNode; name = cameFrom[name])
    path = std::string(name) + " -> " + path;
  return "this would be a cycle: " + link.toNode + " -> " + path;
}

std::vector<SocketInfo> inputsOf(const Graph& graph, const std::string& node) {
  return SocketTable(graph).inputs(node);
}
std::vector<SocketInfo> outputsOf(const Graph& graph, const std::string& node) {
  return SocketTable(graph).outputs(node);
}
std::optional<std::string> linkRefusal(const Graph& graph, const Link& link) {
  return SocketTable(graph).refusal(link);
}

}  // namespace pileus::nodes
