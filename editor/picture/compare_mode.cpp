#include "editor/picture/compare_mode.h"

#include <algorithm>
#include <cmath>

#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"

namespace pileus::editor {
namespace {

/// A CPU marches some 10,000 pixels of truth while one waits; a GPU all of them.
constexpr double kCoarsePixels = 10000;
/// The small comparison runs beside the picture's refinement, the large one after it.
constexpr double kCoarseSamples = 1;

bool whole(const truth::ComparePass* pass, CompareOf of) {
  return pass && (of == CompareOf::Radiance ? pass->pictureWhole() : pass->shadowWhole());
}

view::RenderScene reduced(const Shown& shown, const view::RenderScene& scene) {
  view::RenderScene out = scene;
  const double pixels = static_cast<double>(scene.options.size.x) * scene.options.size.y;
  const int by = shown.renderer.device().software
                     ? std::max(2, static_cast<int>(std::lround(std::sqrt(pixels / kCoarsePixels))))
                     : 2;
  out.options.size = glm::max(scene.options.size / by, ivec2(1));
  out.options.samples = static_cast<int>(kCoarseSamples);
  return out;
}

void forget(CompareMode& mode) {
  mode.scene.reset();
  mode.coarse.reset();
  mode.fine.reset();
  mode.error.clear();
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

bool hasShadow(const view::RenderScene& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const auto& l) { return l.shadow != nullptr; });
}

}  // namespace

const truth::ComparePass* CompareMode::shown() const {
  if (whole(fine.get(), of)) return fine.get();
  return whole(coarse.get(), of) ? coarse.get() : nullptr;
}

const truth::ComparePass* CompareMode::measured() const {
  if (fine && fine->pictureWhole() && fine->shadowWhole()) return fine.get();
  return coarse && coarse->pictureWhole() ? coarse.get() : nullptr;
}

void followPicture(Shown& shown) {
  CompareMode& mode = shown.compare;
  const auto& picture = shown.preview.picture();
  if (!mode.on || !picture || !picture->scene) return forget(mode);
  // A draft has maps of its own, which say nothing about the final ones.
  if (shown.preview.draft() || picture->scene == mode.scene) return;
  forget(mode);
  mode.scene = picture->scene;
  if (!hasShadow(*mode.scene)) {
    mode.error = "No light of this picture has a shadow to compare.";
    return;
  }
  mode.coarse = std::make_unique<truth::ComparePass>(reduced(shown, *mode.scene));
}

bool compareWantsFrame(const Shown& shown) {
  const CompareMode& mode = shown.compare;
  if (!mode.on || !mode.error.empty() || !mode.coarse || shown.preview.draft() || shown.preview.paused())
    return false;
  if (mode.coarse->fraction() < 1) return true;
  return shown.preview.settled() && (!mode.fine || mode.fine->fraction() < 1);
}

void stepCompare(Messages& messages, Shown& shown, double ms) {
  CompareMode& mode = shown.compare;
  if (!compareWantsFrame(shown)) return;
  const bool small = mode.coarse->fraction() < 1;
  if (!small && !mode.fine) mode.fine = std::make_unique<truth::ComparePass>(*mode.scene);
  truth::ComparePass& pass = small ? *mode.coarse : *mode.fine;
  if (const Result<double> done = pass.step(shown.renderer.gpu(), ms); !done) {
    mode.error = done.error().message;
    messages.error("Cannot compare: " + mode.error);
    return;
  }
  if (mode.autoScale)
    if (const truth::ComparePass* m = mode.measured())
      if (const double nice = niceAbove(m->figures().radiance.p95); nice > 0) mode.radianceScale = nice;
}

double compareFraction(const CompareMode& mode) {
  if (!mode.coarse) return 0;
  return 0.1 * mode.coarse->fraction() + 0.9 * (mode.fine ? mode.fine->fraction() : 0);
}

void toggleCompare(Messages& messages, Shown& shown) {
  shown.compare.on = !shown.compare.on;
  messages.note(shown.compare.on ? "Comparing with marched shadows" : "Comparison ended");
}

void toggleWipe(Messages& messages, Shown& shown) { toggleLayout(messages, shown, CompareLayout::Wipe); }
void toggleError(Messages& messages, Shown& shown) { toggleLayout(messages, shown, CompareLayout::Error); }

}  // namespace pileus::editor
