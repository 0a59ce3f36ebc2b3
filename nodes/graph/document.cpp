#include "nodes/graph/document.h"

#include <algorithm>

#include "nodes/graph/graph_groups.h"

namespace pileus::nodes {
namespace {

std::set<std::string> existing(const Graph& graph, std::set<std::string> names) {
  std::erase_if(names, [&](const std::string& name) { return !graph.nodes.contains(name); });
  return names;
}

/// What keeping a graph beside its predecessor costs, roughly: its lists are its own, most nodes are shared.
std::size_t cost(const Graph& graph) {
  return 1024 + 160 * graph.nodes.size() + 200 * graph.links.size() + 160 * graph.frames.size();
}

}  // namespace

Document::Document(Graph graph, std::filesystem::path path) : path_(std::move(path)), saved_(graph) {
  steps_.push_back({std::move(graph), "", {}, {}, {}, 0});
}

void Document::select(std::set<std::string> names) { selection_ = existing(graph(), std::move(names)); }

bool Document::edit(Graph graph, std::string label, std::string_view mergeKey) {
  if (scope_.empty()) return editRoot(std::move(graph), std::move(label), mergeKey);
  Settings settings = std::exchange(graph.settings, {});
  auto root = withGraphAt(this->root(), scope_, std::move(graph));
  if (!root) return false;  // never: the scope exists
  root->settings = std::move(settings);
  return editRoot(std::move(*root), std::move(label), mergeKey);
}

bool Document::editRoot(Graph graph, std::string label, std::string_view mergeKey) {
  if (graph == root()) return true;
  if (groupDepth(graph) > kDeepestGroup) return false;
  const bool merges = !mergeKey.empty() && mergeKey == mergeKey_ && at_ > 0 && steps_[at_].scope == scope_;
  while (steps_.size() > at_ + 1) {
    bytes_ -= steps_.back().bytes;
    steps_.pop_back();
  }
  // A merged step of a group keeps what the group's graph costs as well.
  const std::size_t bytes = cost(graph) + (scope_.empty() ? 0 : cost(inner_));
  if (merges) {
    steps_[at_].graph = std::move(graph);
    if (steps_[at_].graph == steps_[at_ - 1].graph) {  // dragged back to where it began: no step at all
      bytes_ -= steps_.back().bytes;
      steps_.pop_back();
      --at_;
      mergeKey_.clear();
    }
  } else {
    steps_.push_back({std::move(graph), std::move(label), scope_, selection_, {}, bytes});
    bytes_ += bytes;
    ++at_;
    mergeKey_ = mergeKey;
  }
  ++revision_;
  forgetOld();
  changed();
  return true;
}

void Document::forgetOld() {
  while (steps() > kMostSteps || (steps() > kLeastSteps && bytes_ > kMostBytes)) {
    steps_.pop_front();
    bytes_ -= steps_.front().bytes;  // it is where the history begins now: no step itself
    steps_.front().bytes = 0;
    --at_;
  }
}

void Document::changed() {
  while (!scope_.empty() && !graphAt(root(), scope_)) scope_.pop_back();
  if (scope_.empty()) {
    inner_ = {};
  } else {
    inner_ = *graphAt(root(), scope_);
    inner_.settings = root().settings;
  }
  selection_ = existing(graph(), std::move(selection_));
  ++graphRevision_;
}

bool Document::enter(const std::string& group) {
  if (!groupGraph(graph(), group)) return false;
  scope_.push_back(group);
  selection_.clear();
  mergeKey_.clear();
  changed();
  return true;
}

void Document::leave(std::size_t levels) {
  if (scope_.empty() || levels == 0) return;
  std::string left;
  for (; levels > 0 && !scope_.empty(); --levels) {
    left = scope_.back();
    scope_.pop_back();
  }
  selection_ = {left};
  mergeKey_.clear();
  changed();
}

void Document::setScope(std::vector<std::string> scope) {
  if (scope == scope_) return;
  scope_ = std::move(scope);
  selection_.clear();
  mergeKey_.clear();
  changed();
}

std::string Document::scopedName(const std::string& name) const {
  std::string path;
  for (const std::string& group : scope_) path += group + "/";
  return path + name;
}

std::string Document::undoLabel() const { return canUndo() ? steps_[at_].label : ""; }
std::string Document::redoLabel() const { return canRedo() ? steps_[at_ + 1].label : ""; }

void Document::undo() {
  if (!canUndo()) return;
  Step& step = steps_[at_];
  if (scope_ == step.scope) step.selectionAfter = selection_;
  --at_;
  scope_ = step.scope;
  selection_ = step.selectionBefore;
  mergeKey_.clear();
  ++revision_;
  changed();
}

void Document::redo() {
  if (!canRedo()) return;
  ++at_;
  scope_ = steps_[at_].scope;
  selection_ = steps_[at_].selectionAfter;
  mergeKey_.clear();
  ++revision_;
  changed();
}

bool Document::dirty() const { return !(root() == saved_); }

void Document::markSaved(std::filesystem::path path) {
  path_ = std::move(path);
  saved_ = root();
  mergeKey_.clear();
}

}  // namespace pileus::nodes
