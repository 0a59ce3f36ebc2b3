#pragma once
// Single scattering and emission through any number of overlapping volumes, and opaque solids, under any
// number of shadowed lights; progressive over regions and samples.
#include "renderer/view/camera_march.h"
#include "renderer/view/environment_table.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"
#include "renderer/view/scatter_solve.h"

namespace pileus::view {

class VolumeRenderPass {
 public:
  explicit VolumeRenderPass(RenderScene scene);
  VolumeRenderPass(const RenderOptions& options, const volume::InstanceList& volumes,
                   std::vector<shadow::ShadowedLight> lights)
      : VolumeRenderPass(RenderScene{options, volumes, std::move(lights), {}}) {}
  /// Cuts every march into dispatches of so many loop iterations a pixel, needed or not (or
  /// residency::MarchBudget::kNever); before the first step.
  void pauseAfter(int iterations) { pauseAfter_ = iterations; }
  int dispatches() const { return march_.run.dispatches(); }
  /// Where solutions of scattered light are kept beyond the pass; before the first step.
  void keepScatterIn(std::shared_ptr<ScatterCache> cache) { scatterCache_ = std::move(cache); }
  /// Of the picture; null: there is none, or not yet.
  std::shared_ptr<const ScatterField> scatterField() const { return scatter_ ? scatter_->field() : nullptr; }
  /// What the texels of regions still to come hold, stretched to the picture; before the first step.
  void beginWith(std::shared_ptr<const Picture> seed) { seed_ = std::move(seed); }
  /// Works for about `ms` milliseconds (at least one region, or one dispatch of it where it takes several);
  /// the fraction done, 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Null until the first region is drawn; the same object from then on, its texels improving until step()
  /// said 1.
  std::shared_ptr<const Picture> picture() const { return picture_; }
  /// To the finished picture.
  void addLayer(Picture::Named layer) { picture_->layers.push_back(std::move(layer)); }
  /// What the brick pool could hold, as of the last step.
  const residency::Residency& residency() const { return residency_; }
  double takeGpuMs() { return march_.run.takeGpuMs() + (scatter_ ? scatter_->takeGpuMs() : 0); }

 private:
  Result<void> start(const shadow::Gpu& gpu);
  /// True when the region is drawn, false where it has to go on.
  Result<bool> dispatch(const shadow::Gpu& gpu);
  std::shared_ptr<const RenderScene> scene_;
  LightSet lights_;
  std::shared_ptr<Picture> picture_;
  std::shared_ptr<const Picture> seed_;
  CameraMarch march_;
  residency::MarchBudget budget_;
  residency::Residency residency_;
  int pauseAfter_ = 0;
  bool emission_ = false;  ///< counts, and there is some
  Backdrop backdrop_;
  std::shared_ptr<ScatterCache> scatterCache_;
  std::unique_ptr<ScatterSolve> scatter_;
};

}  // namespace pileus::view
