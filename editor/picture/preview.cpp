#include "editor/picture/preview.h"

#include <algorithm>

#include "editor/picture/viewed_node.h"

#include "nodes/declare/value.h"
#include "renderer/view/picture.h"
#include "renderer/view/renderer.h"

namespace pileus::editor {
namespace {

constexpr double kBudgetMs = 30;
constexpr double kDraftBudgetMs = 60;  // a draft is worth a longer frame, of its target at least
constexpr double kCompilingMs = 400;   // a step this long waited for a driver that compiles programs

bool sameRequest(const PreviewRequest& a, const PreviewRequest& b) {
  return a.generation == b.generation && a.revision == b.revision && a.view == b.view && a.size == b.size &&
         a.freeCamera == b.freeCamera && a.folder == b.folder && a.frame == b.frame && a.layer == b.layer &&
         a.region == b.region && a.lights == b.lights && a.switches == b.switches;
}

bool makesPictures(const nodes::Node& node) {
  const nodes::NodeType* type = nodes::findNodeType(node.type);
  return type && (type->uses & nodes::UsesLayers);
}

}  // namespace

Preview::Preview(view::Renderer* renderer)
    : evaluator_(renderer), pace_(!renderer || renderer->device().software) {
  evaluator_.setLetGo([this] { return letGo(); });
}

/// The pictures shown become stills, without the scene that keeps shadow maps, unless they are what is
/// wanted.
bool Preview::letGo() {
  const nodes::SocketValue* value = shownImage(evaluator_, current_.graph, current_.view);
  const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  const auto still = [&](const std::shared_ptr<const view::Picture>& of) {
    Result<std::shared_ptr<const view::Picture>> made = view::stillOf(*of);
    return made ? *made : nullptr;
  };
  const auto pins = [&](const std::shared_ptr<const view::Picture>& p) {
    return p && p->scene && !(image && image->picture == p);
  };
  const bool same = whole_ == picture_, any = pins(picture_) || pins(whole_);
  if (pins(picture_)) picture_ = still(picture_);
  if (pins(whole_)) whole_ = same ? picture_ : still(whole_);
  return any;
}

bool Preview::wantsFrame() const {
  if (current_.view.empty()) return false;
  if (touched_ || (currentIsDraft_ && complete_)) return true;
  return !complete_ && !paused_ && !report_.waitingForJobs;
}

void Preview::begin(const PreviewRequest& wanted, bool draft) {
  if (wanted.view != current_.view) forgetPicture();
  current_ = wanted;
  draftPixels_ = pace_.pixels(), draftTexels_ = pace_.texels();
  stepsMs_ = 0;
  waited_ = false;
  around_ = {};
  if (!current_.region.whole() && whole_)
    around_ = Hasher().add("around").add(wholes_).add(whole_->fraction).key();
  skippedDraft_ = false;
  evaluations_.clear();
  for (const auto& [name, node] : current_.graph.nodes)
    evaluations_[name] = evaluator_.status(name).evaluations;
  currentIsDraft_ = draft;
  fresh_ = false;
  complete_ = false;
  report_ = {};
}

void Preview::step(const PreviewRequest& wanted) {
  const Stopwatch clock;
  const bool changed = fresh_ || !sameRequest(wanted, current_);
  if (frame_ && *frame_ != wanted.frame) touch();
  frame_ = wanted.frame;
  if (touched_ && !interacting()) touched_ = false;
  if (changed) {
    paused_ = false;
    // An unfinished draft is finished first, however long that takes: otherwise a steady drag or playback
    // would never show anything. What it took is learnt, and the next one is small enough.
    const bool finishFirst = currentIsDraft_ && !fresh_ && !complete_ && !report_.waitingForJobs &&
                             wanted.view == current_.view && wanted.generation == current_.generation;
    if (!finishFirst) {
      begin(wanted, !fast_ || fresh_);
      ours_ = false;
      skippedDraft_ = !currentIsDraft_;
    }
  } else if (currentIsDraft_ && complete_ && !interacting()) {
    begin(wanted, false);
  }
  lastStepMs_ = 0;
  if (current_.view.empty() || current_.size.x < 1 || current_.size.y < 1) {
    if (!complete_) ++answered_;
    complete_ = true;
    error_.clear();
    forgetPicture();
    return;
  }
  if (complete_ || ((paused_ || held_) && !currentIsDraft_)) return;

  nodes::EvalSettings settings;
  settings.size = current_.size;
  settings.quality = currentIsDraft_ ? nodes::Quality::Draft : nodes::Quality::Final;
  settings.freeCamera = current_.freeCamera;
  settings.folder = current_.folder;
  settings.budgetMs = currentIsDraft_ ? std::max(kDraftBudgetMs, current_.draftMs) : kBudgetMs;
  settings.frame = current_.frame;
  settings.layer = current_.layer;
  settings.region = current_.region;
  settings.extra.lights = settings.extra.backdrops = current_.lights;
  settings.draftPixels = draftPixels_;
  settings.draftTexels = draftTexels_;
  settings.seed = seed();
  settings.around = around_;
  const bool first = report_.fraction == 0;
  report_ = evaluator_.evaluate(current_.graph, {current_.view}, settings);
  complete_ = report_.complete;
  if (complete_) ++answered_;
  lastStepMs_ = clock.ms();
  stepsMs_ += lastStepMs_;
  waited_ = waited_ || report_.waitingForJobs || lastStepMs_ > settings.budgetMs + kCompilingMs;
  if (!currentIsDraft_ && complete_) fast_ = first && lastStepMs_ < kBudgetMs;
  if (!complete_ && skippedDraft_) {
    // It takes longer than the last one did. Its first tiles are not shown beside the old picture.
    begin(current_, true);
    return;
  }

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
  if (currentIsDraft_ && complete_ && error_.empty()) learnPace();
}

/// What a new picture shows where it is not made yet: the draft of itself, never what was there before; and
/// around a region the last whole one.
std::shared_ptr<const view::Picture> Preview::seed() const {
  if (!current_.region.whole() && whole_) return whole_;
  return ours_ ? picture_ : nullptr;
}

/// Only what this draft made anew counts: results at hand cost nothing.
void Preview::learnPace() {
  DraftTimes times{stepsMs_, 0, 0};
  for (const auto& [name, node] : current_.graph.nodes) {
    const nodes::NodeStatus& status = evaluator_.status(name);
    if (status.evaluations == evaluations_[name]) continue;
    (makesPictures(*node) ? times.picture : times.maps) += status.cpuMs;
  }
  if (times.picture <= 0 || !picture_) return;
  const double beside = std::min(picture_->besideMs, times.picture);
  times.picture -= beside, times.maps += beside;
  draftTimes_ = times;
  const dvec2 part = current_.region.max - current_.region.min;
  const double pixels = static_cast<double>(picture_->size.x) * picture_->size.y * part.x * part.y;
  if (!waited_) pace_.learn(times, static_cast<int>(pixels), current_.draftMs);
}

void Preview::takePicture(bool draft) {
  const nodes::SocketValue* value = shownImage(evaluator_, current_.graph, current_.view);
  const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  if (!image || !image->picture || !error_.empty()) return;
  // A draft is shown once it is whole: what it lacks would look like places without light. The final picture
  // began as its draft.
  if (draft && !complete_ && image->picture->samples < 1 && picture_ != image->picture) return;
  picture_ = image->picture;
  ours_ = true;
  draftShown_ = draft;
  if (draft || !current_.region.whole() || whole_ == picture_) return;
  whole_ = picture_;
  ++wholes_;
}

void Preview::watchFiles() {
  if (!complete_ || filesDueIn() != 0) return;
  filesAge_.restart();
  if (!evaluator_.filesChanged()) return;
  fresh_ = true;
  complete_ = false;
}

double Preview::filesDueIn() const {
  constexpr double kEverySeconds = 1;
  return evaluator_.readsFiles() ? std::max(0.0, kEverySeconds - filesAge_.ms() * 1e-3) : -1;
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
