#include "editor/preview.h"

#include "editor/viewed_node.h"

#include "renderer/view/picture.h"

namespace pileus::editor {
namespace {

constexpr double kBudgetMs = 30;
constexpr double kDraftBudgetMs = 60;     // a draft is worth a longer frame
constexpr double kDraftPatienceMs = 400;  // then a newer request replaces an unfinished draft

bool sameRequest(const PreviewRequest& a, const PreviewRequest& b) {
  return a.revision == b.revision && a.view == b.view && a.size == b.size && a.freeCamera == b.freeCamera &&
         a.folder == b.folder;
}

}  // namespace

bool Preview::wantsFrame() const {
  if (current_.view.empty()) return false;
  if (touched_ || (currentIsDraft_ && complete_)) return true;
  return !complete_ && !paused_ && !report_.waitingForJobs;
}

void Preview::begin(const PreviewRequest& wanted, bool draft) {
  if (wanted.view != current_.view) picture_.reset();
  current_ = wanted;
  currentIsDraft_ = draft;
  fresh_ = false;
  complete_ = false;
  report_ = {};
  draftAge_.restart();
}

void Preview::step(const PreviewRequest& wanted) {
  const Stopwatch clock;
  const bool changed = fresh_ || !sameRequest(wanted, current_);
  if (touched_ && !interacting()) touched_ = false;
  if (changed) {
    paused_ = false;
    // An unfinished draft is finished first, unless it takes too long: otherwise a steady drag would never
    // show anything.
    const bool finishFirst = currentIsDraft_ && !fresh_ && !complete_ && !report_.waitingForJobs &&
                             wanted.view == current_.view && draftAge_.ms() < kDraftPatienceMs;
    if (!finishFirst) begin(wanted, !fast_ || fresh_);
  } else if (currentIsDraft_ && complete_ && !interacting()) {
    begin(wanted, false);
  }
  lastStepMs_ = 0;
  if (current_.view.empty() || current_.size.x < 1 || current_.size.y < 1) {
    complete_ = true;
    error_.clear();
    picture_.reset();
    return;
  }
  if (complete_ || (paused_ && !currentIsDraft_)) return;

  nodes::EvalSettings settings;
  settings.size = current_.size;
  settings.quality = currentIsDraft_ ? nodes::Quality::Draft : nodes::Quality::Final;
  settings.freeCamera = current_.freeCamera;
  settings.folder = current_.folder;
  settings.budgetMs = currentIsDraft_ ? kDraftBudgetMs : kBudgetMs;
  const bool first = report_.fraction == 0;
  report_ = evaluator_.evaluate(current_.graph, {current_.view}, settings);
  complete_ = report_.complete;
  lastStepMs_ = clock.ms();
  if (!currentIsDraft_ && complete_) fast_ = first && lastStepMs_ < kBudgetMs;

  error_.clear();
  const nodes::NodeStatus& status = evaluator_.status(current_.view);
  if (status.state == nodes::NodeState::Failed || status.state == nodes::NodeState::Skipped) {
    error_ = status.error.message;
    // What failed upstream says more than that this was skipped.
    for (const auto& [name, node] : current_.graph.nodes)
      if (evaluator_.status(name).state == nodes::NodeState::Failed)
        error_ = evaluator_.status(name).error.message;
  }
  takePicture(currentIsDraft_);
}

void Preview::takePicture(bool draft) {
  const nodes::SocketValue* value = shownImage(evaluator_, current_.graph, current_.view);
  const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  if (!image || !image->picture || !error_.empty()) return;
  // A picture that has no full pass yet replaces only nothing at all.
  if (image->picture->samples < 1 && image->picture->fraction < 1 && picture_ && picture_ != image->picture)
    return;
  picture_ = image->picture;
  draftShown_ = draft;
}

std::string Preview::waitingFor() const {
  if (complete_) return {};
  for (const auto& [name, node] : current_.graph.nodes) {
    const nodes::NodeStatus& status = evaluator_.status(name);
    if (status.state == nodes::NodeState::Pending && !status.what.empty() &&
        !status.what.starts_with("Waiting for"))
      return status.what;
  }
  return {};
}

}  // namespace pileus::editor
