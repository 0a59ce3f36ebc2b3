#pragma once
// What the evaluator gathers before it calls a node: link values, parameters and the content key made from
// them.
#include <map>
#include <set>
#include <string>
#include <vector>

#include "nodes/declare/eval_settings.h"
#include "nodes/declare/value.h"
#include "nodes/graph/graph.h"
#include "renderer/base/hash.h"

namespace pileus::nodes {

struct NodeInputs {
  std::vector<std::vector<SocketValue>> links;  ///< by input, in link order
  std::vector<std::vector<Key>> keys;           ///< of those values
  std::set<int> linked;                         ///< inputs with an active link
  std::map<int, SocketValue> linkedParams;      ///< by parameter: what a link gives instead of the constant
  std::map<int, const Link*> paramLinks;        ///< and that link
  std::vector<ParamValue> params;               ///< by parameter: checked, files absolute
  std::vector<Key> stamps;                      ///< of the input files among them
  std::vector<std::string> files;               ///< and these
  std::vector<std::string> warnings;
  std::string waitingFor;  ///< a node upstream that has no value to go on with; "" = none
  bool final = true;       ///< no partial value among the links
  bool draft = false;      ///< something made in a draft is among them
};

/// Fills params and stamps. An error names node and key and what is allowed.
std::optional<Error> resolveParams(const std::string& name, const Node& node, const NodeType& type,
                                   const EvalSettings& settings, NodeInputs& in);

/// hash(type, version, parameters, keys of linked outputs, and of the context what the type declares to use).
/// The free camera counts only where no camera is linked.
Key contentKey(const NodeType& type, const NodeInputs& in, const EvalSettings& settings);

/// Number to Vector or Color where that is what the input takes; else the value itself.
SocketValue convertedValue(const SocketValue& value, SocketType to);
/// Lists joined; of other values the last.
SocketValue joinedValue(const std::vector<SocketValue>& values);

}  // namespace pileus::nodes
