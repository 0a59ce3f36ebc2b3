#pragma once
// The document: a graph with its undo history, selection and file. One per window, on the UI thread. What is
// edited is the graph of the current scope: the whole, or a group that was entered.
#include <deque>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

class Document {
 public:
  Document() : Document(Graph{}) {}
  explicit Document(Graph graph, std::filesystem::path path = {});

  /// Of the current scope, with the document's settings.
  const Graph& graph() const { return scope_.empty() ? root() : inner_; }
  /// The whole: what is evaluated, saved and compared.
  const Graph& root() const { return steps_[at_].graph; }

  /// Names of the groups from the root to graph(); empty at the root.
  const std::vector<std::string>& scope() const { return scope_; }
  bool enter(const std::string& group);           ///< of graph(); false: there is none. Never an undo step
  void leave(std::size_t levels = 1);             ///< selects the group that was left
  void setScope(std::vector<std::string> scope);  ///< as far as it exists
  /// "Group/Node": a node of graph() by its path, as the evaluator knows it.
  std::string scopedName(const std::string& name) const;

  const std::set<std::string>& selection() const { return selection_; }  ///< nodes of graph()
  void select(std::set<std::string> names);  ///< those that are nodes of graph(); never an undo step

  /// A new step: `graph` takes the place of graph() (settings are the document's in every scope). Steps with
  /// the same non-empty mergeKey in a row become one (a drag); endMerge() closes it. A graph equal to the
  /// current one is no step. False, and nothing is changed, where groups would be nested deeper than
  /// kDeepestGroup (graph_groups.h).
  bool edit(Graph graph, std::string label, std::string_view mergeKey = {});
  /// The same for the whole, whatever the scope.
  bool editRoot(Graph root, std::string label, std::string_view mergeKey = {});
  void endMerge() { mergeKey_.clear(); }

  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < steps_.size(); }
  std::string undoLabel() const, redoLabel() const;  ///< "" = none
  void undo();  ///< restores selection and scope as they were, less what is gone
  void redo();
  /// The oldest steps are forgotten beyond these: 20,000 steps, or about 256 MiB where at least 100 are left.
  static constexpr std::size_t kMostSteps = 20000, kMostBytes = std::size_t(256) << 20, kLeastSteps = 100;
  std::size_t steps() const { return steps_.size() - 1; }

  const std::filesystem::path& path() const { return path_; }
  bool dirty() const;  ///< differs from what was saved or loaded
  void markSaved(std::filesystem::path path);
  std::uint64_t revision() const { return revision_; }  ///< changes with every change of root()
  std::uint64_t graphRevision() const {
    return graphRevision_;
  }  ///< and this one with every change of graph(), the scope's included

 private:
  struct Step {
    Graph graph;
    std::string label;
    std::vector<std::string> scope;  ///< it was made in
    std::set<std::string> selectionBefore, selectionAfter;
    std::size_t bytes = 0;
  };
  void changed();  ///< after steps_[at_] or the scope: what follows from them
  void forgetOld();

  std::deque<Step> steps_;
  std::size_t at_ = 0;
  std::size_t bytes_ = 0;  ///< of all steps, roughly
  std::vector<std::string> scope_;
  Graph inner_;  ///< graph() where there is a scope
  std::set<std::string> selection_;
  std::string mergeKey_;
  std::filesystem::path path_;
  Graph saved_;
  std::uint64_t revision_ = 1, graphRevision_ = 1;
};

}  // namespace pileus::nodes
