// Parts of a graph as text: copy and paste across files.
#include "nodes/file/serialize_json.h"
#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {

std::string copyText(const Graph& graph, const std::set<std::string>& names,
                     const std::filesystem::path& folder) {
  Graph part;
  for (const std::string& name : names)
    if (const auto it = graph.nodes.find(name); it != graph.nodes.end()) part.nodes.insert(*it);
  for (const Link& link : graph.links)
    if (part.nodes.contains(link.fromNode) && part.nodes.contains(link.toNode)) part.links.push_back(link);
  if (!folder.empty()) part = withRelativePaths(part, folder, "/");
  return writeJson(graphJson(part, false));
}

namespace {

/// The nodes of `part`, which are some, and the links between them.
Graph joined(const Graph& graph, const Graph& part, dvec2 at, std::set<std::string>* pasted) {
  dvec2 low = part.nodes.begin()->second->at, high = low;
  for (const auto& [name, node] : part.nodes) {
    low = glm::min(low, node->at);
    high = glm::max(high, node->at);
  }
  const dvec2 by = at - 0.5 * (low + high);
  Graph result = graph;
  std::map<std::string, std::string> names;
  if (pasted) pasted->clear();
  for (const auto& [name, node] : part.nodes) {
    Node copy = *node;
    copy.at += by;
    const std::string& free = names[name] = freeName(result, name);
    result.nodes.emplace(free, std::make_shared<const Node>(std::move(copy)));
    if (pasted) pasted->insert(free);
  }
  for (Link link : part.links) {
    link.fromNode = names[link.fromNode];
    link.toNode = names[link.toNode];
    // What a damaged text links wrongly is left out; between unknown types anything may be right.
    const SocketTable table(result);
    const auto input = table.input(link.toNode, link.toSocket);
    const bool known = findNodeType(findNode(result, link.fromNode)->type) &&
                       findNodeType(findNode(result, link.toNode)->type);
    const auto taken = [&](const Link& l) { return sameInput(l, link); };
    if (known && (!input || table.refusal(link))) continue;
    if (input && !input->many && std::any_of(result.links.begin(), result.links.end(), taken)) continue;
    result.links.push_back(std::move(link));
  }
  return result;
}

}  // namespace

Result<Graph> pasteText(const Graph& graph, std::string_view text, dvec2 at, std::set<std::string>* pasted) {
  const auto loaded = parseGraph(text);
  if (!loaded) return fail(Code::Input, "the clipboard holds no Pileus nodes ({})", loaded.error().message);
  const Graph& part = loaded->graph;
  if (part.unknown.contains(kContent))
    return fail(Code::Input, "the clipboard holds keys, not nodes: paste them over the timeline");
  if (part.nodes.empty()) return fail(Code::Input, "the clipboard holds no Pileus nodes");
  return joined(graph, part, at, pasted);
}

Result<Graph> mergeGraph(const Graph& graph, const std::filesystem::path& file,
                         const std::filesystem::path& folder, dvec2 at, std::set<std::string>* pasted) {
  PILEUS_TRY(const Loaded loaded, loadGraph(file));
  if (loaded.graph.nodes.empty()) return fail(Code::Input, "{}: holds no nodes", file.string());
  std::error_code ec;
  const auto from = std::filesystem::absolute(file, ec).lexically_normal().parent_path();
  return joined(graph, withRelativePaths(loaded.graph, from, folder.empty() ? "/" : folder), at, pasted);
}

}  // namespace pileus::nodes
