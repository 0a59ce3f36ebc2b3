#pragma once
// What a picture is compared with, and pictures of a scene by whichever renderer makes that. GL thread.
#include <array>
#include <memory>
#include <optional>

#include "renderer/base/enum_info.h"
#include "renderer/view/path_trace.h"
#include "renderer/view/volume_render.h"

namespace pileus::truth {

enum class TruthKind {
  Marched,  ///< the same renderer, every shadow marched: what is wrong with the shadows
  Judge     ///< unbiased paths with the bounces that the picture claims: what is wrong with the picture
};
constexpr auto enumInfo(TruthKind*) {
  using K = TruthKind;
  return std::array{
      EnumItem<K>{K::Marched, "marched", "Marched",
                  "The same picture with every shadow marched: what shadow maps do to it."},
      EnumItem<K>{K::Judge, "judge", "Judge",
                  "Unbiased paths with as many bounces as the picture claims to hold: all that is wrong with "
                  "it. Noisy at first."}};
}

/// Paths of pictures that are compared with one that may be made of paths itself: those share no noise.
inline constexpr int kJudgePaths = 1 << 28;

/// The bounces that a picture of the scene claims to hold, -1: all. Of paths as many as those had; of a march
/// all where it has a grid of scattered light, else 0.
inline int claimedBounces(const view::RenderScene& scene) {
  return scene.bounces.value_or(scene.options.scatter.kind == view::Scattering::Grid ? -1 : 0);
}

/// A picture by either renderer.
class AnyPass {
 public:
  /// As the scene says how it was made.
  explicit AnyPass(const view::RenderScene& scene);
  AnyPass(const view::RenderScene& scene, const view::PathOptions& options);
  Result<double> step(const shadow::Gpu& gpu, double ms) {
    return traced_ ? traced_->step(gpu, ms) : marched_->step(gpu, ms);
  }
  /// As VolumeRenderPass has it.
  std::shared_ptr<const view::Picture> picture() const {
    return traced_ ? traced_->picture() : marched_->picture();
  }
  /// Of paths; null: marched.
  const view::PathTracePass* paths() const { return traced_.get(); }

 private:
  std::unique_ptr<view::VolumeRenderPass> marched_;  ///< or
  std::unique_ptr<view::PathTracePass> traced_;
};

/// Samples of the judge of a scene's picture: many for one of the picture.
int judgeSamples(const view::RenderScene& scene);
/// The truth about a scene's picture.
AnyPass truthPicture(const view::RenderScene& scene, TruthKind kind);

/// `picture` against a judge of paths: scaled relMSE, from which the judge's noise is out; of fewer samples
/// than two nothing.
Result<std::optional<double>> judged(const image::Image& picture, const view::PathTracePass& judge);

}  // namespace pileus::truth
