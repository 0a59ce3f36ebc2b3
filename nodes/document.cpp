#include "nodes/document.h"

#include <algorithm>

namespace pileus::nodes {
namespace {

std::set<std::string> existing(const Graph& graph, std::set<std::string> names) {
  std::erase_if(names, [&](const std::string& name) { return !graph.nodes.contains(name); });
  return names;
}

}  // namespace

Document::Document(Graph graph, std::filesystem::path path) : path_(std::move(path)), saved_(graph) {
  steps_.push_back({std::move(graph), "", {}, {}});
}

void Document::edit(Graph graph, std::string label, std::string_view mergeKey) {
  if (graph == steps_[at_].graph) return;
  const bool merges = !mergeKey.empty() && mergeKey == mergeKey_ && at_ > 0;
  steps_.resize(at_ + 1);
  if (merges) {
    steps_[at_].graph = std::move(graph);
    if (steps_[at_].graph == steps_[at_ - 1].graph) {  // dragged back to where it began: no step at all
      steps_.pop_back();
      --at_;
      mergeKey_.clear();
    }
  } else {
    steps_.push_back({std::move(graph), std::move(label), selection_, {}});
    ++at_;
    mergeKey_ = mergeKey;
  }
  selection_ = existing(steps_[at_].graph, std::move(selection_));
  ++revision_;
}

std::string Document::undoLabel() const { return canUndo() ? steps_[at_].label : ""; }
std::string Document::redoLabel() const { return canRedo() ? steps_[at_ + 1].label : ""; }

void Document::undo() {
  if (!canUndo()) return;
  steps_[at_].selectionAfter = selection_;
  const auto before = steps_[at_].selectionBefore;
  --at_;
  selection_ = existing(graph(), before);
  mergeKey_.clear();
  ++revision_;
}

void Document::redo() {
  if (!canRedo()) return;
  ++at_;
  selection_ = existing(graph(), steps_[at_].selectionAfter);
  mergeKey_.clear();
  ++revision_;
}

bool Document::dirty() const { return !(graph() == saved_); }

void Document::markSaved(std::filesystem::path path) {
  path_ = std::move(path);
  saved_ = graph();
  mergeKey_.clear();
}

}  // namespace pileus::nodes
