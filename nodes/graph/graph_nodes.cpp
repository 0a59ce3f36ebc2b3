// Edits of selections of nodes.
#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_edits.h"

namespace pileus::nodes {
namespace {

std::set<std::string> reached(const Graph& graph, const std::set<std::string>& names, bool up) {
  std::multimap<std::string_view, std::string_view> next;
  for (const Link& l : graph.links)
    up ? next.emplace(l.toNode, l.fromNode) : next.emplace(l.fromNode, l.toNode);
  std::set<std::string> found;
  std::vector<std::string> open;
  for (const std::string& name : names)
    if (graph.nodes.contains(name) && found.insert(name).second) open.push_back(name);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [first, last] = next.equal_range(open[i]);
    for (auto it = first; it != last; ++it)
      if (found.emplace(it->second).second) open.emplace_back(it->second);
  }
  return found;
}

}  // namespace

Graph extractNodes(const Graph& graph, const std::set<std::string>& names) {
  Graph result = removeNodes(graph, names, true);
  for (const std::string& name : names)
    if (const auto it = graph.nodes.find(name); it != graph.nodes.end()) result.nodes.insert(*it);
  for (const Link& link : graph.links)
    if (names.contains(link.fromNode) && names.contains(link.toNode)) result.links.push_back(link);
  return result;
}

Graph duplicateNodes(const Graph& graph, const std::set<std::string>& names, bool keepInputs, dvec2 by,
                     std::set<std::string>* newNames) {
  Graph result = graph;
  std::map<std::string, std::string> copies;
  if (newNames) newNames->clear();
  for (const std::string& name : names) {
    const auto it = graph.nodes.find(name);
    if (it == graph.nodes.end()) continue;
    Node copy = *it->second;
    copy.at += by;
    const std::string& free = copies[name] = freeName(result, name);
    result.nodes.emplace(free, std::make_shared<const Node>(std::move(copy)));
    if (newNames) newNames->insert(free);
  }
  for (const Link& link : graph.links) {
    const auto to = copies.find(link.toNode);
    if (to == copies.end()) continue;
    const auto from = copies.find(link.fromNode);
    if (from == copies.end() && !keepInputs) continue;
    result.links.push_back({from == copies.end() ? link.fromNode : from->second, link.fromSocket, to->second,
                            link.toSocket, link.muted});
  }
  return result;
}

Graph disableNodes(const Graph& graph, const std::set<std::string>& names, bool disabled) {
  Graph result = graph;
  for (const std::string& name : names)
    changeNode(result, name, [&](Node& node) { node.disabled = disabled; });
  return result;
}

Graph resetParams(const Graph& graph, const std::string& name) {
  Graph result = graph;
  changeNode(result, name, [&](Node& node) {
    node.params.clear();
    node.animated.clear();
    std::erase_if(node.unknown, [](const auto& entry) { return entry.first.starts_with("params/"); });
  });
  return result;
}

Graph setColor(const Graph& graph, const std::set<std::string>& names, const std::string& color) {
  Graph result = graph;
  for (const std::string& name : names) changeNode(result, name, [&](Node& node) { node.color = color; });
  return result;
}

Graph setLabel(const Graph& graph, const std::string& name, const std::string& label) {
  Graph result = graph;
  changeNode(result, name, [&](Node& node) { node.label = label; });
  return result;
}

std::set<std::string> upstreamOf(const Graph& graph, const std::set<std::string>& names) {
  return reached(graph, names, true);
}
std::set<std::string> downstreamOf(const Graph& graph, const std::set<std::string>& names) {
  return reached(graph, names, false);
}

}  // namespace pileus::nodes
