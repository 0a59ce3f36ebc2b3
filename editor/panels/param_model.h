#pragma once
// Edits of one parameter that the panel needs, as functions that return a new graph.
#include <optional>
#include <string>

#include "nodes/graph.h"

namespace pileus::editor::model {

using nodes::Graph;

/// A constant, or the key at `frame` of an animated parameter.
Result<Graph> setParamAt(const Graph& graph, const std::string& node, const nodes::ParamSpec& spec,
                         const nodes::ParamValue& value, int frame);
Result<Graph> setKey(const Graph& graph, const std::string& node, const nodes::ParamSpec& spec,
                     const nodes::ParamValue& value, int frame);
/// The last key leaves a constant.
Result<Graph> removeKey(const Graph& graph, const std::string& node, const nodes::ParamSpec& spec, int frame);
/// The value at `frame` becomes a constant.
Result<Graph> clearAnimation(const Graph& graph, const std::string& node, const nodes::ParamSpec& spec,
                             int frame);
Result<Graph> resetParams(const Graph& graph, const std::string& node);
Result<Graph> exposeParam(const Graph& graph, const std::string& node, const nodes::ParamSpec& spec, bool on);
bool canExpose(const nodes::ParamSpec& spec);

}  // namespace pileus::editor::model
