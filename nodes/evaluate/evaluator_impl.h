#pragma once
// What the evaluator keeps; for evaluator.cpp (the walk over what is wanted) and evaluator_visit.cpp (one
// node).
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nodes/evaluate/evaluator.h"
#include "nodes/evaluate/flatten.h"
#include "nodes/evaluate/node_inputs.h"
#include "nodes/evaluate/result_cache.h"
#include "renderer/base/profile.h"

namespace pileus::nodes {

/// What one evaluate() knows about a wanted node.
struct Run {
  Key key;                           ///< zero: not reached
  Values values;                     ///< null: none
  std::vector<Key> outputKeys;       ///< what dependants hash, one per output
  bool final = false;                ///< neither it nor anything upstream can still change
  bool draft = false;                ///< it or something upstream was made in a draft
  std::optional<SocketType> passed;  ///< a dot: the type of what it passes
};

inline bool isFailure(NodeState state) { return state == NodeState::Failed || state == NodeState::Skipped; }

struct Evaluator::Impl {
  view::Renderer* renderer;
  TypeLookup lookup;
  ResultCache cache;
  Asking asking;
  Graph whole;     ///< as last given
  FlatGraph flat;  ///< of it
  const Graph& graph = flat.graph;
  bool flattened = false;
  mutable std::map<std::string, NodeStatus> groupStatuses;   ///< summaries asked for since
  std::map<std::string, std::vector<const Link*>> incoming;  ///< active links of `graph` by target
  std::map<std::string, NodeStatus> statuses;
  std::map<std::string, Run> runs;
  std::map<std::string, Values> lastGood;
  std::map<std::string, std::any> lasting;  ///< EvalContext::lasting()

  std::function<bool()> letGo;

  // Of the request: the same targets and settings are the same one until it is answered.
  std::vector<std::string> targets;
  EvalSettings asked;
  bool answered = true;

  std::map<std::string, Key> files;  ///< read by nodes of the last evaluate(), as they were

  // Of the evaluate() in progress.
  const EvalSettings* settings = nullptr;
  const std::vector<std::string>* order = nullptr;  ///< of what is wanted, upstream first
  std::size_t at = 0;                               ///< in it
  bool marking = false, marked = false;             ///< nothing is worked out, only asked for; that was done
  Stopwatch clock;
  bool stepped = false;     ///< the one step that is always done was done
  bool workLeft = false;    ///< an unfinished node could go on at once
  std::size_t waiting = 0;  ///< unfinished nodes that wait for a job

  const NodeType* typeOf(const std::string& node) const {
    const Node* n = findNode(graph, node);
    if (!n) return nullptr;
    static const NodeType* const dot = findNodeType("dot");
    return n->type == "dot" ? dot : lookup(n->type);
  }
  /// What an output gives; a dot that nothing is linked to gives nothing.
  std::optional<SocketType> typeGiven(const NodeType& type, std::size_t output, const std::string& node) {
    if (type.outputs[output].any) return runs[node].passed;
    return type.outputs[output].type;
  }
  /// A group's socket is a dot in the flat graph.
  std::string socketNode(const std::string& node, std::string_view socket) const {
    return flat.groups.contains(node) ? node + "/" + std::string(socket) : node;
  }
  std::string socketName(const std::string& node, std::string_view socket, std::string_view dot) const {
    return std::string(flat.groups.contains(node) ? dot : socket);
  }
  const std::vector<const Link*>& linksInto(const std::string& node) const {
    static const std::vector<const Link*> none;
    const auto it = incoming.find(node);
    return it == incoming.end() ? none : it->second;
  }
  const Link* firstLink(const std::string& node, std::string_view socket) const {
    for (const Link* link : linksInto(node))
      if (link->toSocket == socket) return link;
    return nullptr;
  }

  /// True: it is another one.
  bool take(const Graph& given);
  void newRequest();
  void fresh(const std::string& name);
  void mark(std::size_t from);
  bool reclaim(std::size_t bytes);
  void visit(const std::string& name);
  void visitDot(const std::string& name);
  const NodeStatus& groupStatus(const std::string& group) const;
  std::optional<Error> gather(const std::string& name, const Node& node, const NodeType& type,
                              NodeInputs& in);
  void passThrough(const NodeType& type, const NodeInputs& in, Run& run);
  void step(const std::string& name, const NodeType& type, const NodeInputs& in, CachedResult& result,
            const Key& key);
  void publish(const std::string& name, const NodeType& type, const NodeInputs& in,
               const CachedResult& result);
  void failed(const std::string& name, NodeState state, Error error) {
    NodeStatus& status = statuses[name];
    status.state = state;
    status.error = std::move(error);
  }
};

}  // namespace pileus::nodes
