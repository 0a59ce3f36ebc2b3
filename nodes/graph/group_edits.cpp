// Making groups from nodes, and nodes from groups.
#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_groups.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

constexpr double kColumn = 260, kRow = 70;  // of the sockets' nodes beside what they feed

/// A socket's label as a node name that is free.
std::string socketName(const Graph& inner, const std::optional<SocketInfo>& info,
                       std::string_view otherwise) {
  std::string name = info ? info->label : std::string(otherwise);
  for (char& c : name)
    if (c == '.' || c == '/' || c == '=' || c == '>') c = ' ';
  if (!checkName(name)) name = otherwise;
  return freeName(inner, name);
}

void addSocket(Graph& inner, const std::string& name, std::string_view type, dvec2 at) {
  Node node;
  node.type = type;
  node.at = at;
  inner.nodes.emplace(name, std::make_shared<const Node>(std::move(node)));
}

struct Bounds {
  dvec2 low{1e300}, high{-1e300};
};
Bounds boundsOf(const Graph& graph) {
  Bounds b;
  for (const auto& [name, node] : graph.nodes) b = {glm::min(b.low, node->at), glm::max(b.high, node->at)};
  return b;
}

using Socket = std::pair<std::string, std::string>;

/// Would the group need itself? Names a node between, "" = none.
std::string nodeBetween(const Graph& graph, const std::string& group) {
  const SocketTable table(graph);
  std::set<std::string> seen;
  std::vector<std::string> open;
  for (const Link* link : table.outOf(group)) open.push_back(link->toNode);
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    if (!seen.insert(name).second) continue;
    for (const Link* link : table.outOf(name)) {
      if (link->toNode == group) return name;
      open.push_back(link->toNode);
    }
  }
  return "";
}

}  // namespace

Result<Graph> groupNodes(const Graph& graph, const std::set<std::string>& names, std::string* groupName) {
  Graph inner, outer = graph;
  std::set<std::string> members;  // without the sockets' nodes, which may share names with nodes outside
  for (const std::string& name : names) {
    const auto it = graph.nodes.find(name);
    // The sockets of the group around it stay where they are.
    if (it == graph.nodes.end() || it->second->type == "group.input" || it->second->type == "group.output")
      continue;
    inner.nodes.insert(*it);
    outer.nodes.erase(name);
    members.insert(name);
  }
  if (inner.nodes.empty()) return fail(Code::Arguments, "no nodes to group");
  if (groupDepth(inner) >= kDeepestGroup)
    return fail(Code::Arguments, "groups may be nested {} deep", kDeepestGroup);
  const std::string group = freeName(graph, "Group");
  const SocketTable table(graph);
  const Bounds bounds = boundsOf(inner);

  std::map<Socket, std::string> inputs, outputs;  // what they stand for -> name of the node
  std::vector<Link> links;
  for (const Link& link : graph.links) {
    const bool from = members.contains(link.fromNode), to = members.contains(link.toNode);
    if (from && to) {
      inner.links.push_back(link);
    } else if (to) {
      const Socket source{link.fromNode, link.fromSocket};
      auto it = inputs.find(source);
      if (it == inputs.end()) {
        const auto info = table.input(link.toNode, link.toSocket);
        const std::string name = socketName(inner, info, "Input");
        addSocket(inner, name, "group.input",
                  {bounds.low.x - kColumn, bounds.low.y + kRow * static_cast<double>(inputs.size())});
        links.push_back({source.first, source.second, group, name, false});
        it = inputs.emplace(source, name).first;
      }
      inner.links.push_back({it->second, "out", link.toNode, link.toSocket, link.muted});
    } else if (from) {
      const Socket source{link.fromNode, link.fromSocket};
      auto it = outputs.find(source);
      if (it == outputs.end()) {
        const std::string name = socketName(inner, table.output(link.fromNode, link.fromSocket), "Output");
        addSocket(inner, name, "group.output",
                  {bounds.high.x + kColumn, bounds.low.y + kRow * static_cast<double>(outputs.size())});
        inner.links.push_back({link.fromNode, link.fromSocket, name, "in", false});
        it = outputs.emplace(source, name).first;
      }
      links.push_back({group, it->second, link.toNode, link.toSocket, link.muted});
    } else {
      links.push_back(link);
    }
  }
  outer.links = std::move(links);
  Node node;
  node.type = "group";
  node.at = 0.5 * (bounds.low + bounds.high);
  node.group = std::make_shared<const Graph>(std::move(inner));
  outer.nodes.emplace(group, std::make_shared<const Node>(std::move(node)));
  if (const std::string between = nodeBetween(outer, group); !between.empty())
    return fail(Code::Arguments, "{} lies between these nodes: group it with them", between);
  if (groupName) *groupName = group;
  return outer;
}

Result<Graph> ungroup(const Graph& graph, const std::string& group, std::set<std::string>* names) {
  const Node* node = findNode(graph, group);
  if (!node) return fail(Code::Arguments, "there is no node '{}'", group);
  if (!node->group) return fail(Code::Arguments, "{} is no group", group);
  const Graph& inner = *node->group;
  Graph result = graph;
  result.nodes.erase(group);
  if (names) names->clear();

  Graph content = inner;
  std::erase_if(content.nodes, [](const auto& entry) {
    return entry.second->type == "group.input" || entry.second->type == "group.output";
  });
  const Bounds bounds = boundsOf(content);
  const dvec2 by = content.nodes.empty() ? dvec2(0) : node->at - 0.5 * (bounds.low + bounds.high);
  std::map<std::string, std::string> renamed;
  for (const auto& [name, old] : content.nodes) {
    Node copy = *old;
    copy.at += by;
    copy.disabled = copy.disabled || node->disabled;
    const std::string& free = renamed[name] = freeName(result, name);
    result.nodes.emplace(free, std::make_shared<const Node>(std::move(copy)));
    if (names) names->insert(free);
  }
  for (Frame frame : inner.frames) {
    frame.at += by;
    result.frames.push_back(std::move(frame));
  }

  // What feeds an input of the group, and what an inner link comes from seen from outside.
  const auto outside = [&](const std::string& input) -> std::optional<Link> {
    for (const Link& link : graph.links)
      if (link.toNode == group && link.toSocket == input) return link;
    return std::nullopt;
  };
  const auto source = [&](const Link& link) -> std::optional<Link> {
    if (const auto it = renamed.find(link.fromNode); it != renamed.end())
      return Link{it->second, link.fromSocket, "", "", link.muted};
    auto from = outside(link.fromNode);
    if (from) from->muted = from->muted || link.muted;
    return from;
  };
  Graph done = result;
  done.links.clear();
  std::vector<Link> joined;  // from parts inside and outside, which need not fit
  const auto add = [&](std::optional<Link> from, const std::string& toNode, const std::string& toSocket,
                       bool muted) {
    if (!from) return;
    const Link link{from->fromNode, from->fromSocket, toNode, toSocket, from->muted || muted};
    if (link.fromNode == group || hasLink(done, link)) return;
    done.links.push_back(link);
    joined.push_back(link);
  };
  for (const Link& link : graph.links) {
    if (link.toNode == group) continue;
    if (link.fromNode != group) {
      if (!hasLink(done, link)) done.links.push_back(link);
      continue;
    }
    for (const Link& in : inner.links)
      if (in.toNode == link.fromSocket) add(source(in), link.toNode, link.toSocket, link.muted);
  }
  for (const Link& link : inner.links)
    if (const auto to = renamed.find(link.toNode); to != renamed.end())
      add(source(link), to->second, link.toSocket, false);
  for (const Link& link : joined) {
    const Graph without = disconnect(done, link);
    const auto& types = {link.fromNode, link.toNode};
    const bool known = std::all_of(types.begin(), types.end(), [&](const std::string& name) {
      const Node* end = findNode(done, name);
      return end && findNodeType(end->type);
    });
    if (known && linkRefusal(without, link)) done = without;
  }
  return done;
}

}  // namespace pileus::nodes
