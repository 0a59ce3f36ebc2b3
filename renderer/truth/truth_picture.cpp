#include "renderer/truth/truth_picture.h"

#include <algorithm>

#include "renderer/image/metrics.h"
#include "renderer/truth/compare.h"

namespace pileus::truth {
namespace {

/// Paths for a sample of the picture, and at least.
constexpr int kPathsOfSample = 16, kLeastPaths = 64;

}  // namespace

int judgeSamples(const view::RenderScene& scene) {
  return std::max(kPathsOfSample * scene.options.samples, kLeastPaths);
}

AnyPass::AnyPass(const view::RenderScene& scene) {
  view::PathOptions paths;
  paths.bounces = claimedBounces(scene);
  if (scene.bounces)
    traced_ = std::make_unique<view::PathTracePass>(scene, paths);
  else
    marched_ = std::make_unique<view::VolumeRenderPass>(scene);
}

AnyPass::AnyPass(const view::RenderScene& scene, const view::PathOptions& options)
    : traced_(std::make_unique<view::PathTracePass>(scene, options)) {}

AnyPass truthPicture(const view::RenderScene& scene, TruthKind kind) {
  if (kind == TruthKind::Marched) return AnyPass(truthOf(scene));
  view::PathOptions paths;
  paths.bounces = claimedBounces(scene);
  paths.firstPath = kJudgePaths;
  view::RenderScene judge = scene;
  judge.options.samples = judgeSamples(scene);
  return AnyPass(judge, paths);
}

Result<std::optional<double>> judged(const image::Image& picture, const view::PathTracePass& judge) {
  if (judge.picture()->samples < 2) return std::optional<double>();
  PILEUS_TRY(const auto halves, judge.halves());
  // Nothing of the medium is in sight: nothing to measure.
  const auto scaled = image::scaledRelMse(picture, halves[0], halves[1]);
  return scaled ? std::optional(scaled->value) : std::nullopt;
}

}  // namespace pileus::truth
