#pragma once
// The document: a graph with its undo history, selection and file. One per window, on the UI thread.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "nodes/graph.h"

namespace pileus::nodes {

class Document {
 public:
  Document() : Document(Graph{}) {}
  explicit Document(Graph graph, std::filesystem::path path = {});

  const Graph& graph() const { return steps_[at_].graph; }
  const std::set<std::string>& selection() const { return selection_; }
  void select(std::set<std::string> names) { selection_ = std::move(names); }  ///< never an undo step

  /// A new step. Steps with the same non-empty mergeKey in a row become one (a drag); endMerge() closes it. A graph equal to the
  /// current one is no step.
  void edit(Graph graph, std::string label, std::string_view mergeKey = {});
  void endMerge() { mergeKey_.clear(); }

  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < steps_.size(); }
  std::string undoLabel() const, redoLabel() const;  ///< "" = none
  void undo();  ///< restores the selection as it was, less nodes that are gone
  void redo();

  const std::filesystem::path& path() const { return path_; }
  bool dirty() const;            ///< differs from what was saved or loaded
  void markSaved(std::filesystem::path path);
  std::uint64_t revision() const { return revision_; }  ///< changes with every change of graph()

 private:
  struct Step {
    Graph graph;
    std::string label;
    std::set<std::string> selectionBefore, selectionAfter;
  };
  std::vector<Step> steps_;
  std::size_t at_ = 0;
  std::set<std::string> selection_;
  std::string mergeKey_;
  std::filesystem::path path_;
  Graph saved_;
  std::uint64_t revision_ = 1;
};

}  // namespace pileus::nodes
