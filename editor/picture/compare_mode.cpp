#include "editor/picture/compare_mode.h"

#include <algorithm>
#include <cmath>

#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"
#include "renderer/base/profile.h"

namespace pileus::editor {
namespace {

/// A CPU marches some 10,000 pixels of truth while one waits, and some 1,000 before one notices; a GPU all of
/// them.
constexpr double kCoarsePixels = 10000, kDraftPixels = 1000;
/// A draft takes long steps and solves for scattered light on few cells.
constexpr double kDraftSteps = 2, kDraftResidual = 1e-2;
constexpr int kDraftCells = 16;
/// The refinement waits that long for a draft: a truth that takes more is made beside it.
constexpr double kDraftGoesFirstMs = 1500;
/// The small comparison runs beside the picture's refinement, the large one after it.
constexpr double kCoarseSamples = 1;

bool whole(const truth::ComparePass* pass, CompareOf of) {
  return pass && (of == CompareOf::Radiance ? pass->pictureWhole() : pass->shadowWhole());
}

view::RenderScene reduced(const Shown& shown, const view::RenderScene& scene, double wanted) {
  view::RenderScene out = scene;
  const double pixels = static_cast<double>(scene.options.size.x) * scene.options.size.y;
  const int by = shown.renderer.device().software
                     ? std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / wanted))))
                     : 2;
  out.options.size = glm::max(scene.options.size / by, ivec2(1));
  out.options.samples = static_cast<int>(kCoarseSamples);
  return out;
}

std::unique_ptr<truth::ComparePass> draftOf(const Shown& shown, const view::RenderScene& scene) {
  view::RenderScene draft = reduced(shown, scene, kDraftPixels);
  if (shown.renderer.device().software) draft.options.stepScale *= kDraftSteps;
  view::ScatterOptions& scatter = draft.options.scatter;
  scatter.cells = std::min(scatter.cells, kDraftCells);
  scatter.residual = std::max(scatter.residual, kDraftResidual);
  return std::make_unique<truth::ComparePass>(draft, shown.compare.kind, truth::CompareOrder::TruthFirst);
}

/// What a pass costs, in samples of pixels: two pictures and the shadows' error.
double units(const view::RenderScene& scene, truth::TruthKind kind) {
  const view::RenderOptions& o = scene.options;
  const double truth = kind == truth::TruthKind::Judge ? truth::judgeSamples(scene) : o.samples;
  return (truth + o.samples + 1) * o.size.x * o.size.y;
}

void forget(CompareMode& mode) {
  mode.scene.reset();
  mode.coarse.reset();
  mode.fine.reset();
  mode.error.clear();
  mode.workedMs = mode.workedUnits = 0;
}

void forgetDraft(CompareMode& mode) {
  mode.draftScene.reset();
  mode.draft.reset();
  mode.draftMs = 0;
}

/// 1, 2 or 5 times a power of ten, at least `value`.
double niceAbove(double value) {
  if (!(value > 0)) return 0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0, 10.0})
    if (step * decade >= value * 0.999) return step * decade;
  return 10 * decade;
}

void toggleLayout(Messages& messages, Shown& shown, CompareLayout layout) {
  CompareMode& mode = shown.compare;
  if (mode.on && mode.layout == layout) return toggleCompare(messages, shown);
  mode.layout = layout;
  if (!mode.on) toggleCompare(messages, shown);
}

bool comparable(const view::RenderScene& scene, truth::TruthKind kind) {
  return kind == truth::TruthKind::Judge || std::any_of(scene.lights.begin(), scene.lights.end(),
                                                        [](const auto& l) { return l.shadow != nullptr; });
}

}  // namespace

const truth::ComparePass* CompareMode::shown() const {
  if (whole(fine.get(), of)) return fine.get();
  if (whole(coarse.get(), of)) return coarse.get();
  return draftScene == scene && whole(draft.get(), of) ? draft.get() : nullptr;
}

const truth::ComparePass* CompareMode::shownTruth() const {
  if (const truth::ComparePass* pass = shown()) return pass;
  return of == CompareOf::Radiance && draft && draft->truthWhole() ? draft.get() : nullptr;
}

const truth::ComparePass* CompareMode::measured() const {
  if (fine && fine->pictureWhole() && fine->shadowWhole()) return fine.get();
  return coarse && coarse->pictureWhole() ? coarse.get() : nullptr;
}

void followPicture(Shown& shown) {
  CompareMode& mode = shown.compare;
  const auto& picture = shown.preview.picture();
  if (!mode.on || !picture || !picture->scene) return forget(mode), forgetDraft(mode);
  if (mode.kind != mode.against) forget(mode), forgetDraft(mode);
  mode.kind = mode.against;
  if (picture->scene == mode.scene) return;
  if (shown.preview.draft()) {
    // A draft has maps of its own, which say nothing about the final ones; but its truth is the same.
    if (picture->scene == mode.draftScene) return;
    forget(mode);
    forgetDraft(mode);
    mode.draftScene = picture->scene;
    if (comparable(*picture->scene, mode.kind)) mode.draft = draftOf(shown, *picture->scene);
    return;
  }
  // What comes behind its draft keeps that one's truth until it has one itself.
  const bool behindDraft = mode.draft && !mode.scene;
  forget(mode);
  mode.scene = picture->scene;
  if (!behindDraft) forgetDraft(mode);
  if (!comparable(*mode.scene, mode.kind)) {
    mode.error = "No light of this picture has a shadow to compare.";
    return;
  }
  mode.coarse = std::make_unique<truth::ComparePass>(reduced(shown, *mode.scene, kCoarsePixels), mode.kind);
  if (mode.draft) return;
  mode.draftScene = mode.scene;
  mode.draft = draftOf(shown, *mode.scene);
}

namespace {

/// The draft until it has something to show; then the small one; once the picture is finished the large one.
truth::ComparePass* passToStep(const Shown& shown) {
  const CompareMode& mode = shown.compare;
  if (mode.draft && !whole(mode.draft.get(), mode.of) && !whole(mode.coarse.get(), mode.of) &&
      (mode.of == CompareOf::Radiance || mode.draftScene == mode.scene))
    return mode.draft.get();
  if (!mode.coarse) return nullptr;
  if (mode.coarse->fraction() < 1) return mode.coarse.get();
  return mode.fine && mode.fine->fraction() < 1 ? mode.fine.get() : nullptr;
}

bool fineIsDue(const Shown& shown) {
  const CompareMode& mode = shown.compare;
  return mode.coarse && mode.coarse->fraction() >= 1 && !mode.fine && shown.preview.settled();
}

}  // namespace

bool compareWantsFrame(const Shown& shown) {
  const CompareMode& mode = shown.compare;
  if (!mode.on || !mode.error.empty() || shown.preview.paused() || shown.preview.interacting()) return false;
  if (fineIsDue(shown)) return true;
  const truth::ComparePass* pass = passToStep(shown);
  return pass && (pass != mode.fine.get() || shown.preview.settled());
}

bool compareGoesFirst(const Shown& shown) {
  const CompareMode& mode = shown.compare;
  return (shown.preview.refining() || shown.preview.settled()) && compareWantsFrame(shown) &&
         !mode.shownTruth() && passToStep(shown) == mode.draft.get() && mode.draftMs < kDraftGoesFirstMs;
}

void stepCompare(Messages& messages, Shown& shown, double ms) {
  CompareMode& mode = shown.compare;
  if (!compareWantsFrame(shown)) return;
  if (fineIsDue(shown)) mode.fine = std::make_unique<truth::ComparePass>(*mode.scene, mode.kind);
  truth::ComparePass& pass = *passToStep(shown);
  const Stopwatch clock;
  const double before = pass.fraction();
  if (const Result<double> done = pass.step(shown.renderer.gpu(), ms); !done) {
    mode.error = done.error().message;
    messages.error("Cannot compare: " + mode.error);
    return;
  }
  if (&pass == mode.draft.get()) {
    mode.draftMs += clock.ms();
  } else {
    mode.workedMs += clock.ms();
    mode.workedUnits += (pass.fraction() - before) * units(pass.scene(), mode.kind);
  }
  if (mode.autoScale)
    if (const truth::ComparePass* m = mode.measured())
      if (const double nice = niceAbove(m->figures().radiance.p95); nice > 0) mode.radianceScale = nice;
}

double compareFraction(const CompareMode& mode) {
  if (!mode.coarse) return 0;
  const double small = units(mode.coarse->scene(), mode.kind), large = units(*mode.scene, mode.kind);
  return (small * mode.coarse->fraction() + large * (mode.fine ? mode.fine->fraction() : 0)) /
         (small + large);
}

double compareSecondsLeft(const CompareMode& mode) {
  if (!mode.coarse || mode.workedUnits <= 0) return -1;
  const double all = units(mode.coarse->scene(), mode.kind) + units(*mode.scene, mode.kind);
  return 1e-3 * mode.workedMs / mode.workedUnits * (1 - compareFraction(mode)) * all;
}

void toggleCompare(Messages& messages, Shown& shown) {
  shown.compare.on = !shown.compare.on;
  const bool judge = shown.compare.against == truth::TruthKind::Judge;
  messages.note(!shown.compare.on ? "Comparison ended"
                : judge           ? "Comparing with unbiased paths"
                                  : "Comparing with marched shadows");
}

void toggleWipe(Messages& messages, Shown& shown) { toggleLayout(messages, shown, CompareLayout::Wipe); }
void toggleError(Messages& messages, Shown& shown) { toggleLayout(messages, shown, CompareLayout::Error); }

}  // namespace pileus::editor
