// The edits of graph.h: each makes a new graph from an old one; unchanged nodes are shared.
#include <algorithm>

#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

/// Links the sources of a node's inputs to the targets of its outputs where the types agree.
Graph bridged(const Graph& graph, const std::string& name) {
  const SocketTable table(graph);
  const std::vector<SocketInfo> inputs = table.inputs(name), outputs = table.outputs(name);
  Graph result = graph;
  for (const Link* out : table.outOf(name)) {
    const auto output = std::find_if(outputs.begin(), outputs.end(),
                                     [&](const SocketInfo& s) { return s.id == out->fromSocket; });
    if (out->muted || output == outputs.end()) continue;
    const auto input = std::find_if(inputs.begin(), inputs.end(), [&](const SocketInfo& s) {
      return !s.param && (s.any || output->any || s.type == output->type);
    });
    if (input == inputs.end()) continue;
    const auto target = table.input(out->toNode, out->toSocket);
    // In place of the old link, so that the order within a many-input stays; a single input takes the first.
    std::vector<Link> links;
    for (const Link& link : result.links) {
      if (!sameEnds(link, *out)) {
        links.push_back(link);
        continue;
      }
      bool taken = false;
      for (const Link* in : table.into(name)) {
        if (in->toSocket != input->id || in->muted || (taken && !(target && target->many))) continue;
        const Link joined{in->fromNode, in->fromSocket, out->toNode, out->toSocket, false};
        if (hasLink(result, joined) || table.refusal(joined)) continue;
        links.push_back(joined);
        taken = true;
      }
    }
    result.links = std::move(links);
  }
  return result;
}

}  // namespace

Result<Graph> addNode(const Graph& graph, std::string_view type, dvec2 at, std::string_view name) {
  const NodeType* found = findNodeType(type);
  if (!found) return fail(Code::Arguments, "there is no node type '{}'", type);
  std::string wanted = name.empty() ? freeName(graph, found->label) : std::string(name);
  PILEUS_CHECK(checkName(wanted));
  if (graph.nodes.contains(wanted)) return fail(Code::Arguments, "a node named '{}' exists already", wanted);
  Graph result = graph;
  Node node;
  node.type = found->id;
  node.at = at;
  if (node.type == "group") node.group = std::make_shared<const Graph>();
  result.nodes.emplace(std::move(wanted), std::make_shared<const Node>(std::move(node)));
  return result;
}

Graph removeNodes(const Graph& graph, const std::set<std::string>& names, bool reconnect) {
  Graph result = graph;
  for (const std::string& name : names) {
    if (reconnect) result = bridged(result, name);
    std::erase_if(result.links,
                  [&](const Link& link) { return link.fromNode == name || link.toNode == name; });
    result.nodes.erase(name);
  }
  return result;
}

Result<Graph> connect(const Graph& graph, const Link& wanted) {
  Graph result = graph;
  Link link = wanted;
  link.muted = false;
  const auto input = SocketTable(graph).input(link.toNode, link.toSocket);
  const bool many = input && input->many;
  // What it replaces: the same link, or whatever a single input held. The first one's place is kept.
  const auto replaced = [&](const Link& l) { return many ? sameEnds(l, link) : sameInput(l, link); };
  const auto first = std::find_if(result.links.begin(), result.links.end(), replaced);
  const auto place = std::count_if(result.links.begin(), first, [&](const Link& l) { return !replaced(l); });
  std::erase_if(result.links, replaced);
  if (const auto reason = linkRefusal(result, link))
    return fail(Code::Arguments, "{}.{} -> {}.{}: {}", link.fromNode, link.fromSocket, link.toNode,
                link.toSocket, *reason);
  result.links.insert(result.links.begin() + place, link);
  if (!input) expose(result, link.toNode, link.toSocket);  // a parameter becomes a socket
  return result;
}

Graph disconnect(const Graph& graph, const Link& link) {
  Graph result = graph;
  std::erase_if(result.links, [&](const Link& l) { return sameEnds(l, link); });
  return result;
}

Graph setMuted(const Graph& graph, const Link& link, bool muted) {
  Graph result = graph;
  for (Link& l : result.links)
    if (sameEnds(l, link)) l.muted = muted;
  return result;
}

Result<Graph> setParam(const Graph& graph, const std::string& name, const std::string& param,
                       const ParamValue& value) {
  const Node* node = findNode(graph, name);
  if (!node) return fail(Code::Arguments, "there is no node '{}'", name);
  const NodeType* type = findNodeType(node->type);
  if (!type) return fail(Code::Arguments, "{} is of the unknown type '{}'", name, node->type);
  const ParamSpec* spec = type->param(param);
  if (!spec) return fail(Code::Arguments, "{} ({}) has no parameter '{}'", name, type->id, param);
  const auto checked = checkedParam(*spec, value);
  if (!checked) return fail(checked.error().code, "{}.{}: {}", name, param, checked.error().message);
  Graph result = graph;
  changeNode(result, name, [&](Node& n) {
    n.animated.erase(param);
    n.unknown.erase("params/" + param);
    if (*checked == spec->fallback)
      n.params.erase(param);
    else
      n.params[param] = *checked;
  });
  return result;
}

Result<Graph> renameNode(const Graph& graph, const std::string& from, const std::string& to) {
  const auto it = graph.nodes.find(from);
  if (it == graph.nodes.end()) return fail(Code::Arguments, "there is no node '{}'", from);
  if (from == to) return graph;
  PILEUS_CHECK(checkName(to));
  if (graph.nodes.contains(to)) return fail(Code::Arguments, "a node named '{}' exists already", to);
  Graph result = graph;
  result.nodes.erase(from);
  result.nodes.emplace(to, it->second);
  for (Link& link : result.links) {
    if (link.fromNode == from) link.fromNode = to;
    if (link.toNode == from) link.toNode = to;
  }
  return result;
}

Graph moveNodes(const Graph& graph, const std::set<std::string>& names, dvec2 by) {
  Graph result = graph;
  for (const std::string& name : names) changeNode(result, name, [&](Node& node) { node.at += by; });
  return result;
}

Graph setBypass(const Graph& graph, const std::set<std::string>& names, bool bypass) {
  Graph result = graph;
  for (const std::string& name : names) changeNode(result, name, [&](Node& node) { node.bypass = bypass; });
  return result;
}

}  // namespace pileus::nodes
