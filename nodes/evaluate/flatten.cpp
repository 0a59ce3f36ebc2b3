#include "nodes/evaluate/flatten.h"

#include <algorithm>

#include "nodes/graph/graph_groups.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

NodePtr dotNode() {
  static const NodePtr node = [] {
    Node dot;
    dot.type = "dot";
    return std::make_shared<const Node>(std::move(dot));
  }();
  return node;
}

class Flattener {
 public:
  void add(const Graph& graph, const std::string& prefix, std::size_t depth) {
    std::map<std::string_view, const Graph*> groups;  // taken apart here
    for (const auto& [name, node] : graph.nodes) {
      if (node->disabled) continue;
      const std::string path = prefix + name;
      if (node->type == "group" && (!node->group || depth >= kDeepestGroup)) {
        out.faults.emplace(
            path, node->group ? fail(Code::Input, "{}: groups are nested deeper than {}", path, kDeepestGroup)
                              : fail(Code::Input, "{}: the group holds no graph", path));
        out.graph.nodes.emplace(path, node);
      } else if (node->group) {
        groups.emplace(name, node->group.get());
        out.groups.insert(path);
        if (node->bypass)
          pass(graph, name, path + "/");
        else
          add(*node->group, path + "/", depth + 1);
      } else {
        out.graph.nodes.emplace(path, passesThrough(node->type) ? dotNode() : node);
      }
    }
    for (const Link& link : graph.links) {
      if (link.muted || disabled(graph, link.fromNode) || disabled(graph, link.toNode)) continue;
      Link flat{prefix + link.fromNode, link.fromSocket, prefix + link.toNode, link.toSocket, false};
      if (const auto it = groups.find(link.fromNode); it != groups.end()) {
        if (disabled(*it->second, link.fromSocket)) continue;
        flat.fromNode += "/" + link.fromSocket;
        flat.fromSocket = "out";
      }
      if (const auto it = groups.find(link.toNode); it != groups.end()) {
        if (disabled(*it->second, link.toSocket)) continue;
        flat.toNode += "/" + link.toSocket;
        flat.toSocket = "in";
      }
      out.graph.links.push_back(std::move(flat));
    }
  }

  FlatGraph out;

 private:
  static bool disabled(const Graph& graph, const std::string& name) {
    const Node* node = findNode(graph, name);
    return node && node->disabled;
  }

  /// A bypassed group: its sockets alone, the first output fed by the first input of its type.
  void pass(const Graph& graph, const std::string& name, const std::string& prefix) {
    const SocketTable table(graph);
    const auto inputs = table.inputs(name), outputs = table.outputs(name);
    for (const auto* sockets : {&inputs, &outputs})
      for (const SocketInfo& s : *sockets) out.graph.nodes.emplace(prefix + s.id, dotNode());
    if (outputs.empty()) return;
    const SocketInfo& output = outputs.front();
    const auto input = std::find_if(inputs.begin(), inputs.end(), [&](const SocketInfo& s) {
      return s.any == output.any && (s.any || s.type == output.type);
    });
    if (input != inputs.end())
      out.graph.links.push_back({prefix + input->id, "out", prefix + output.id, "in", false});
  }
};

}  // namespace

FlatGraph flatten(const Graph& root) {
  Flattener flattener;
  flattener.out.graph.settings = root.settings;
  flattener.add(root, "", 0);
  return std::move(flattener.out);
}

}  // namespace pileus::nodes
