#pragma once
// Content-key evaluation: a node whose key is cached costs nothing. Lives on the GL thread.
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "nodes/declare/eval_settings.h"
#include "nodes/graph/graph.h"
#include "renderer/base/hash.h"

namespace pileus::view {
class Renderer;  // renderer/view/renderer.h
}

namespace pileus::nodes {

enum class NodeState { Idle, Ready, Partial, Pending, Failed, Skipped };

struct NodeStatus {
  NodeState state = NodeState::Idle;
  Error error;  ///< Failed: message begins with the node's name; Skipped: names the failed node upstream
  std::vector<std::string> warnings, notes;
  double fraction = 1;          ///< Partial, Pending
  std::string what;             ///< Pending: "Baking cloud"
  double cpuMs = 0, gpuMs = 0;  ///< of all calls for the current key
  std::size_t bytes = 0;
  std::uint64_t evaluations = 0;  ///< calls of evaluate() ever made for this node name
};

/// What one evaluate() left.
struct EvalReport {
  bool complete = false;  ///< every target is Ready, Failed or Skipped
  bool failed = false;
  double fraction = 0;  ///< rough progress of all that is wanted
  bool waitingForJobs =
      false;  ///< nothing could be done on this thread: wait (a job notifier will call) instead of spinning
};

/// Finds a node type by id; null: unknown.
using TypeLookup = std::function<const NodeType*(std::string_view id)>;

class Evaluator {
 public:
  /// `renderer` may be null (model tests), or outlives this; `lookup` replaces the registry there.
  explicit Evaluator(view::Renderer* renderer, TypeLookup lookup = findNodeType);
  ~Evaluator();

  /// Groups are flattened first (flatten.h): nodes inside go by their path, "Group/Node"; a group as a target
  /// wants all its outputs. Disabled nodes are not there. Brings `targets` (node names) up to date as far as
  /// the budget allows; call again until complete. Bypassed nodes pass the first input of the first output's
  /// type. Nodes not upstream of a target become Idle. A node downstream of a Pending one is Pending too
  /// ("Waiting for NAME"); one that is finished with a Partial input is Partial. With an infinite budget only
  /// final values flow on.
  EvalReport evaluate(const Graph& graph, const std::vector<std::string>& targets,
                      const EvalSettings& settings);

  /// As left by the last evaluate(). Of a group: its worst node's state, the first error, sums of times and
  /// memory.
  const NodeStatus& status(const std::string& node) const;
  /// Output value of the last evaluate(), for its own key; null if it has none yet.
  const SocketValue* output(const std::string& node, std::string_view socket) const;
  /// Value that arrives at an input by its (first) link: what output.view shows. Null if none.
  const SocketValue* input(const std::string& node, std::string_view socket) const;
  /// The newest usable value, also of an earlier key while the current one is still pending: what a viewport
  /// keeps showing. Null if there never was one; forgotten when the node leaves the graph.
  const SocketValue* lastGood(const std::string& node, std::string_view socket) const;
  /// The same for what arrives at an input by its first link.
  const SocketValue* lastGoodInput(const std::string& node, std::string_view socket) const;
  /// This evaluation's content key of a node; zero Key if it was not reached.
  Key key(const std::string& node) const;

  /// Are files that the last evaluate() read for any node other ones now, or gone? Looks at the disk.
  bool filesChanged() const;
  /// Did it read any?
  bool readsFiles() const;

  /// Memory of kept results, what they share counted once, above which old unused ones are dropped; those of
  /// the request in progress and of the last finished one never are. 0, for sequences: the results of one
  /// request go before those of the next are made, but for what both need.
  void setCacheLimit(std::size_t bytes);
  /// Memory of all that is kept, by the same count.
  std::size_t keptBytes() const;
  /// Asked where a shadow map does not fit though no old result is kept any more: true where somebody else
  /// let go of pictures or maps.
  void setLetGo(std::function<bool()> others);
  /// Another graph is to come, in which names mean other nodes: lastGood() knows none of them any more.
  void forgetNames();
  void clear();  ///< drops everything (context lost)

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pileus::nodes
