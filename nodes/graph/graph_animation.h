#pragma once
// Edits of keyframes. Values are checked as setParam checks them; errors name node and parameter. A node may
// be one in a group, by its path: "Group/Sun".
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

/// Adds a key, or replaces the one at this frame. The first key makes the parameter animated.
Result<Graph> setKey(const Graph& graph, const std::string& node, const std::string& param, double frame,
                     const ParamValue& value, Interpolation interpolation = Interpolation::Smooth);
/// Without its last key a parameter is constant at that key's value. No key there: nothing changes.
Graph removeKey(const Graph& graph, const std::string& node, const std::string& param, double frame);

struct KeyAt {
  std::string node, param;
  double frame = 0;
  auto operator<=>(const KeyAt&) const = default;
};
/// Null: there is none.
const AnimationKey* findKey(const Graph& graph, const KeyAt& at);

struct KeyMove {
  std::string node, param;
  double from = 0, to = 0;
};
/// All at once: keys may pass or change places with each other; keys they land on are replaced.
Result<Graph> moveKeys(const Graph& graph, const std::vector<KeyMove>& moves);
Graph setInterpolation(const Graph& graph, const std::string& node, const std::string& param, double frame,
                       Interpolation interpolation);
/// Constant from now on, at the value it has at `frame`.
Graph clearAnimation(const Graph& graph, const std::string& node, const std::string& param, double frame);
/// setParam, but an animated parameter gets a key at `frame`, interpolated as the key before it.
Result<Graph> setParamAt(const Graph& graph, const std::string& node, const std::string& param,
                         const ParamValue& value, double frame);

/// A value that a node gives one of its parameters; frame: of the key that holds it, none: it is constant.
struct HeldValue {
  ParamValue value;
  std::optional<double> frame;
};
/// Those of its keys, or the one; none: the default counts.
std::vector<HeldValue> heldValues(const Node& node, const std::string& param);

Result<Graph> setFrameRange(const Graph& graph, ivec2 frames);
Result<Graph> setFps(const Graph& graph, double fps);

}  // namespace pileus::nodes
