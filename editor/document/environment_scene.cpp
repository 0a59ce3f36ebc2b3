#include "editor/document/environment_scene.h"

#include "editor/document/daylight.h"
#include "editor/document/vdb_scene.h"

namespace pileus::editor {
namespace {

using nodes::Graph;

std::string firstRender(const Graph& graph) {
  for (const auto& [name, node] : graph.nodes)
    if (node->type == "render.volume" || node->type == "render.path_trace") return name;
  return {};
}

/// The name that the node got, which is the only new one.
Result<std::string> add(Graph& graph, const char* type, const dvec2& at, const std::string& name) {
  PILEUS_TRY(Graph next, nodes::addNode(graph, type, at, name));
  std::string added;
  for (const auto& [each, node] : next.nodes)
    if (!graph.nodes.contains(each)) added = each;
  graph = std::move(next);
  return added;
}

Result<void> link(Graph& graph, const std::string& from, const char* out, const std::string& to,
                  const char* in) {
  PILEUS_TRY(graph, nodes::connect(graph, {from, out, to, in}));
  return {};
}

/// What is linked there goes to another input, too.
Result<void> linkLike(Graph& graph, const std::string& from, const char* input, const std::string& to) {
  const std::vector<nodes::Link> links = graph.links;
  for (const nodes::Link& l : links)
    if (l.toNode == from && l.toSocket == input && !l.muted) {
      PILEUS_TRY(graph, nodes::connect(graph, {l.fromNode, l.fromSocket, to, input}));
    }
  return {};
}

}  // namespace

Result<EnvironmentScene> addEnvironment(const Graph& graph, const std::filesystem::path& file) {
  EnvironmentScene out{graph, {}};
  Graph& g = out.graph;
  const std::string render = firstRender(graph);
  dvec2 at(0);
  if (!render.empty()) {
    at = graph.nodes.at(render)->at + dvec2(-780, 0);
    for (const auto& [name, node] : graph.nodes) at.y = std::max(at.y, node->at.y + 260);
  }
  PILEUS_TRY(out.node, add(g, "light.environment", at, nodeNameOf(file)));
  PILEUS_TRY(g, nodes::setParam(g, out.node, "file", file.string()));
  if (render.empty()) return out;
  if (graph.nodes.at(render)->type == "render.path_trace") {
    PILEUS_CHECK(link(g, out.node, "light", render, "lights"));
    return out;
  }
  PILEUS_TRY(const std::string metric,
             add(g, "shadow.pseudometric", at + dvec2(260, 0), out.node + " Metric"));
  PILEUS_TRY(const std::string map, add(g, "shadow.extinction", at + dvec2(520, 0), out.node + " Shadow"));
  PILEUS_TRY(g, nodes::setParam(g, metric, "resolution", kWideLightTexels));
  PILEUS_CHECK(linkLike(g, render, "volumes", metric));
  PILEUS_CHECK(linkLike(g, render, "solids", metric));
  PILEUS_CHECK(link(g, out.node, "light", metric, "light"));
  PILEUS_CHECK(link(g, metric, "metric", map, "metric"));
  PILEUS_CHECK(link(g, map, "light", render, "lights"));
  return out;
}

}  // namespace pileus::editor
