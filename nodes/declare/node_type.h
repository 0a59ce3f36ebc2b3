#pragma once
// A node type: the one declaration that the interface, files, docs, command line and tests read. Built by
// makeNode (describe.h).
#include <any>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "nodes/declare/param_value.h"
#include "nodes/declare/uses.h"
#include "renderer/base/result.h"

namespace pileus::nodes {

class EvalContext;

/// What a curve's or ramp's 0 .. 1 stands for: densities of the volumes at an input, between two parameters.
struct DataRange {
  std::string input, lowest, highest;  ///< ids; a highest of 0 is the largest density there is
  std::string what = "density";        ///< the densities are
};

struct Choice {
  std::string id, label, help;
};

struct ParamSpec {
  std::string id, label, help;
  std::string unit;  ///< "m", "deg", "1/m", "W/m^2", "stops" or ""
  ParamType type = ParamType::Float;
  ParamValue fallback;              ///< the default, from the struct
  double softMin = 0, softMax = 0;  ///< dragging stops here; equal: none
  double hardMin = 0, hardMax = 0;  ///< typing and files stop here; always set for Int, Float, Vector, Color,
                                    ///< Ramp (its channels)
  bool logarithmic = false;         ///< drag in ratios
  std::vector<Choice> choices;      ///< Enum
  std::vector<std::string> fileKinds;  ///< File: "vdb", "exr"; none: any
  bool writes = false;     ///< File: an output, not an input (does not enter the content key with its stamp)
  DataRange data;          ///< Curve, Ramp
  bool socket = false;     ///< an input socket without being exposed
  bool forEditor = false;  ///< read by the editor alone: what the node gives does not depend on it
  std::function<void(void* in, const ParamValue&)> set;  ///< of an In of the type
  std::function<ParamValue(const void* in)> get;
};

struct SocketSpec {
  std::string id, label, help;
  SocketType type = SocketType::Volume;
  bool many = false;      ///< takes many links, in order; their lists are joined
  bool required = false;  ///< inputs: evaluation fails naming it when nothing is linked
  bool any = false;       ///< passes every type (a dot); `type` is not used
  std::function<void(void* in, const SocketValue&)> assign;  ///< inputs; called once per link, in order
  std::function<SocketValue(const void* out)> read;          ///< outputs
};

struct NodeType {
  std::string id;   ///< "shadow.extinction"
  int version = 1;  ///< bump when the same inputs give another result
  std::string label, category, help, keywords;
  std::vector<SocketSpec> inputs, outputs;
  std::vector<ParamSpec> params;
  unsigned uses = UsesNothing;
  std::any defaults;      ///< the In that a node begins with: for those who know that struct
  bool isOutput = false;  ///< a sink that is evaluated because it exists (output.*)
  /// Link values by input index (a list per input), parameters by index; returns one value per output.
  std::function<Result<std::vector<SocketValue>>(std::span<const std::vector<SocketValue>> inputs,
                                                 std::span<const ParamValue> params, EvalContext&)>
      evaluate;

  const ParamSpec* param(std::string_view id) const;
  int paramIndex(std::string_view id) const;  ///< -1: none
  int inputIndex(std::string_view id) const;
  int outputIndex(std::string_view id) const;
};

/// Checks type, choice and hard range and converts (an int for a Float, a number for a Color); the error says
/// what is allowed but not which node: the caller prefixes "Node.param: ".
Result<ParamValue> checkedParam(const ParamSpec& spec, const ParamValue& value);
/// The conversion alone, without range and choice.
Result<ParamValue> convertedParam(const ParamSpec& spec, const ParamValue& value);
/// From command-line text ("0.5", "1 2 3" or "1,2,3", "true", an enum id, a path).
Result<ParamValue> parseParam(const ParamSpec& spec, std::string_view text);
/// For people: "0.5", "1 2 3", "cosine".
std::string formatParam(const ParamSpec& spec, const ParamValue& value);
/// Shortest text that reads back to the same number; "0" for -0.
std::string formatNumber(double value);

/// May a value of `from` be linked to an input of `to`? Equal types, or Number to Vector or Color.
bool convertible(SocketType from, SocketType to);

/// Every node type, in menu order (types/list.inc).
std::span<const NodeType> allNodeTypes();
const NodeType* findNodeType(std::string_view id);

}  // namespace pileus::nodes
