#include "nodes/graph/graph_animation.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::nodes {
namespace {

constexpr double kFurthestFrame = 1e9;

using Keys = std::vector<AnimationKey>;

/// The first key at or after a frame.
Keys::iterator keyFrom(Keys& keys, double frame) {
  return std::lower_bound(keys.begin(), keys.end(), frame,
                          [](const AnimationKey& key, double f) { return key.frame < f; });
}
bool isAt(const Keys& keys, Keys::iterator it, double frame) {
  return it != keys.end() && it->frame == frame;
}

/// Replaces what is there.
void put(Keys& keys, AnimationKey key) {
  const auto it = keyFrom(keys, key.frame);
  if (isAt(keys, it, key.frame))
    *it = std::move(key);
  else
    keys.insert(it, std::move(key));
}

const ParamSpec* specOf(const Node& node, const std::string& param) {
  const NodeType* type = findNodeType(node.type);
  return type ? type->param(param) : nullptr;
}

void setConstant(Node& node, const std::string& param, const ParamValue& value) {
  node.animated.erase(param);
  const ParamSpec* spec = specOf(node, param);
  if (spec && value == spec->fallback)
    node.params.erase(param);
  else
    node.params[param] = value;
}

Result<void> checkFrame(double frame) {
  if (std::isfinite(frame) && std::abs(frame) <= kFurthestFrame) return {};
  return fail(Code::Arguments, "{} is no frame", formatNumber(frame));
}

/// "Group/Sun" is Sun in Group; no node's name has a slash in it.
struct Inside {
  std::string group, node;
  const Graph* graph = nullptr;
};
std::optional<Inside> inside(const Graph& graph, const std::string& path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const std::string group = path.substr(0, slash);
  const Graph* inner = groupGraph(graph, group);
  if (!inner) return std::nullopt;
  return Inside{group, path.substr(slash + 1), inner};
}

Graph withInner(const Graph& graph, const Inside& in, Graph inner) {
  Graph result = graph;
  changeNode(result, in.group,
             [&](Node& node) { node.group = std::make_shared<const Graph>(std::move(inner)); });
  return result;
}

}  // namespace

Result<Graph> setKey(const Graph& graph, const std::string& name, const std::string& param, double frame,
                     const ParamValue& value, Interpolation interpolation) {
  if (const auto in = inside(graph, name)) {
    PILEUS_TRY(Graph inner, setKey(*in->graph, in->node, param, frame, value, interpolation));
    return withInner(graph, *in, std::move(inner));
  }
  PILEUS_CHECK(checkFrame(frame));
  // The same checks and words as for a constant.
  PILEUS_TRY(const Graph constant, setParam(graph, name, param, value));
  const Node& set = *findNode(constant, name);
  if (constantOnly(specOf(set, param)->type))
    return fail(Code::Arguments, "{}.{} takes no keys", name, param);
  const ParamValue checked = paramValue(set, *specOf(set, param));
  Graph result = graph;
  changeNode(result, name, [&](Node& node) {
    node.params.erase(param);
    node.unknown.erase("params/" + param);
    put(node.animated[param].keys, {frame, checked, interpolation});
  });
  return result;
}

Graph removeKey(const Graph& graph, const std::string& name, const std::string& param, double frame) {
  if (const auto in = inside(graph, name))
    return withInner(graph, *in, removeKey(*in->graph, in->node, param, frame));
  Graph result = graph;
  changeNode(result, name, [&](Node& node) {
    const auto it = node.animated.find(param);
    if (it == node.animated.end()) return;
    Keys& keys = it->second.keys;
    const auto key = keyFrom(keys, frame);
    if (!isAt(keys, key, frame)) return;
    if (keys.size() == 1)
      setConstant(node, param, ParamValue(keys.front().value));
    else
      keys.erase(key);
  });
  return result;
}

const AnimationKey* findKey(const Graph& graph, const KeyAt& at) {
  if (const auto in = inside(graph, at.node)) return findKey(*in->graph, {in->node, at.param, at.frame});
  const Node* node = findNode(graph, at.node);
  const auto it = node ? node->animated.find(at.param) : decltype(node->animated.find(at.param)){};
  if (!node || it == node->animated.end()) return nullptr;
  for (const AnimationKey& key : it->second.keys)
    if (key.frame == at.frame) return &key;
  return nullptr;
}

Result<Graph> moveKeys(const Graph& graph, const std::vector<KeyMove>& moves) {
  Graph result = graph;
  std::map<std::pair<std::string, std::string>, std::vector<const KeyMove*>> byParam;
  std::map<std::string, std::vector<KeyMove>> byGroup;
  for (const KeyMove& move : moves) {
    PILEUS_CHECK(checkFrame(move.to));
    if (const auto in = inside(graph, move.node))
      byGroup[in->group].push_back({in->node, move.param, move.from, move.to});
    else
      byParam[{move.node, move.param}].push_back(&move);
  }
  for (const auto& [group, list] : byGroup) {
    PILEUS_TRY(Graph inner, moveKeys(*groupGraph(graph, group), list));
    result = withInner(result, {group, {}, nullptr}, std::move(inner));
  }
  for (const auto& [where, list] : byParam)
    changeNode(result, where.first, [&](Node& node) {
      const auto it = node.animated.find(where.second);
      if (it == node.animated.end()) return;
      Keys& keys = it->second.keys;
      Keys taken;  // all are lifted before any lands
      for (const KeyMove* move : list) {
        const auto key = keyFrom(keys, move->from);
        if (!isAt(keys, key, move->from)) continue;
        taken.push_back(*key);
        taken.back().frame = move->to;
        keys.erase(key);
      }
      for (AnimationKey& key : taken) put(keys, std::move(key));
    });
  return result;
}

Graph setInterpolation(const Graph& graph, const std::string& name, const std::string& param, double frame,
                       Interpolation interpolation) {
  if (const auto in = inside(graph, name))
    return withInner(graph, *in, setInterpolation(*in->graph, in->node, param, frame, interpolation));
  Graph result = graph;
  changeNode(result, name, [&](Node& node) {
    const auto it = node.animated.find(param);
    if (it == node.animated.end()) return;
    const auto key = keyFrom(it->second.keys, frame);
    if (isAt(it->second.keys, key, frame)) key->interpolation = interpolation;
  });
  return result;
}

Graph clearAnimation(const Graph& graph, const std::string& name, const std::string& param, double frame) {
  if (const auto in = inside(graph, name))
    return withInner(graph, *in, clearAnimation(*in->graph, in->node, param, frame));
  Graph result = graph;
  changeNode(result, name, [&](Node& node) {
    if (const auto it = node.animated.find(param); it != node.animated.end())
      setConstant(node, param, valueAt(it->second, frame));
  });
  return result;
}

Result<Graph> setParamAt(const Graph& graph, const std::string& name, const std::string& param,
                         const ParamValue& value, double frame) {
  if (const auto in = inside(graph, name)) {
    PILEUS_TRY(Graph inner, setParamAt(*in->graph, in->node, param, value, frame));
    return withInner(graph, *in, std::move(inner));
  }
  const Node* node = findNode(graph, name);
  const auto animated = node ? node->animated.find(param) : decltype(node->animated.find(param)){};
  if (!node || animated == node->animated.end()) return setParam(graph, name, param, value);
  Interpolation interpolation = animated->second.keys.front().interpolation;
  for (const AnimationKey& key : animated->second.keys)
    if (key.frame <= frame) interpolation = key.interpolation;
  return setKey(graph, name, param, frame, value, interpolation);
}

std::vector<HeldValue> heldValues(const Node& node, const std::string& param) {
  std::vector<HeldValue> out;
  if (const auto keys = node.animated.find(param); keys != node.animated.end())
    for (const AnimationKey& key : keys->second.keys) out.push_back({key.value, key.frame});
  else if (const auto value = node.params.find(param); value != node.params.end())
    out.push_back({value->second, std::nullopt});
  return out;
}

Result<Graph> setFrameRange(const Graph& graph, ivec2 frames) {
  if (frames.x > frames.y) return fail(Code::Arguments, "the first frame comes after the last");
  Graph result = graph;
  result.settings.frames = frames;
  return result;
}

Result<Graph> setFps(const Graph& graph, double fps) {
  if (!(fps > 0) || fps > 1000)
    return fail(Code::Arguments, "{} is not a number above 0 and up to 1000", formatNumber(fps));
  Graph result = graph;
  result.settings.fps = fps;
  return result;
}

}  // namespace pileus::nodes
