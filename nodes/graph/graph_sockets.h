#pragma once
// What the sockets of a node are: one description for canvas, search, checks and files, whether they are
// declared by its type, an exposed parameter, a dot's, a group's or only known from links.
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

struct SocketInfo {
  std::string id, label, help;
  SocketType type = SocketType::Number;  ///< of an `any` socket a guess for its colour
  bool many = false, required = false;
  bool known = true;   ///< false: of an unknown node type, inferred from links
  bool any = false;    ///< takes or gives anything: nothing linked to it has decided its type yet
  bool param = false;  ///< an input that is a parameter: without a link its constant counts
};

/// Declared inputs, then exposed parameters in the order of the type; for a group one for each of its inputs.
std::vector<SocketInfo> inputsOf(const Graph& graph, const std::string& node);
std::vector<SocketInfo> outputsOf(const Graph& graph, const std::string& node);

/// Is this parameter an input socket of the node?
bool isSocket(const Node& node, const ParamSpec& spec);
/// Is it a type whose values pass through unchanged (dot, group.input, group.output)?
bool passesThrough(std::string_view type);

/// The same for many nodes of one graph: finds their links once. The graph must outlive it.
class SocketTable {
 public:
  explicit SocketTable(const Graph& graph);

  std::vector<SocketInfo> inputs(const std::string& node) const;
  std::vector<SocketInfo> outputs(const std::string& node) const;
  std::optional<SocketInfo> input(const std::string& node, std::string_view socket) const;
  std::optional<SocketInfo> output(const std::string& node, std::string_view socket) const;
  /// linkRefusal (graph.h), but a cycle is found in one walk from `link.toNode`.
  std::optional<std::string> refusal(const Link& link) const;

  const std::vector<const Link*>& into(const std::string& node) const;
  const std::vector<const Link*>& outOf(const std::string& node) const;

 private:
  friend struct TypeTracer;
  const Graph* graph_;
  std::map<std::string, std::vector<const Link*>, std::less<>> into_, outOf_;
};

}  // namespace pileus::nodes
