// Keys as text: copy and paste in the timeline. The text is that of nodes which hold nothing but the keys.
#include <algorithm>
#include <limits>

#include "nodes/file/serialize_json.h"

namespace pileus::nodes {

std::string copyKeysText(const Graph& graph, const std::set<KeyAt>& keys) {
  std::map<std::string, Node> held;
  for (const KeyAt& at : keys) {
    const AnimationKey* key = findKey(graph, at);
    if (!key) continue;
    Node& node = held[at.node];
    node.type = findNode(graph, at.node)->type;
    node.animated[at.param].keys.push_back(*key);  // the set is in the order of frames
  }
  Graph part;
  for (auto& [name, node] : held) part.nodes[name] = std::make_shared<const Node>(std::move(node));
  Json json = graphJson(part, false);
  json[kContent] = "keys";
  return writeJson(json);
}

Result<Graph> pasteKeysText(const Graph& graph, std::string_view text, double frame, const std::string& onto,
                            std::set<KeyAt>* pasted) {
  const auto loaded = parseGraph(text);
  if (!loaded || !loaded->graph.unknown.contains(kContent))
    return fail(Code::Input, "the clipboard holds no keys: copy some in the timeline first");
  for (const Fault& fault : loaded->faults)
    if (fault.error) return fail(Code::Input, "the keys on the clipboard are damaged: {}", faultText(fault));
  const auto& from = loaded->graph.nodes;
  double first = std::numeric_limits<double>::infinity();
  for (const auto& [name, node] : from)
    for (const auto& [param, animation] : node->animated)
      first = std::min(first, animation.keys.front().frame);
  if (!(first < std::numeric_limits<double>::infinity()))
    return fail(Code::Input, "the clipboard holds no keys that this version knows");
  Graph result = graph;
  std::set<KeyAt> landed;
  for (const auto& [name, node] : from)
    for (const auto& [param, animation] : node->animated)
      for (const AnimationKey& key : animation.keys) {
        const KeyAt to{from.size() == 1 && !onto.empty() ? onto : name, param, frame + key.frame - first};
        PILEUS_TRY(result, setKey(result, to.node, to.param, to.frame, key.value, key.interpolation));
        landed.insert(to);
      }
  if (pasted) *pasted = std::move(landed);
  return result;
}

}  // namespace pileus::nodes
