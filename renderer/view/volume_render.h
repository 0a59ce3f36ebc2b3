#pragma once
// Single scattering and emission through any number of overlapping volumes, and opaque solids, under any
// number of shadowed lights; progressive over regions and samples.
#include "renderer/gl/gpu_timer.h"
#include "renderer/gl/region_cursor.h"
#include "renderer/residency/tile_lists.h"
#include "renderer/residency/volume_set.h"
#include "renderer/shadow/gpu.h"
#include "renderer/view/light_set.h"
#include "renderer/view/march_budget.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

class VolumeRenderPass {
 public:
  explicit VolumeRenderPass(RenderScene scene);
  VolumeRenderPass(const RenderOptions& options, const volume::InstanceList& volumes,
                   std::vector<shadow::ShadowedLight> lights)
      : VolumeRenderPass(RenderScene{options, volumes, std::move(lights), {}}) {}
  /// Cuts every march into dispatches of so many loop iterations a pixel, needed or not (or
  /// MarchBudget::kNever); before the first step.
  void pauseAfter(int iterations) { pauseAfter_ = iterations; }
  int dispatches() const { return dispatches_; }
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
  double takeGpuMs() { return timer_.takeMs(); }

 private:
  void start(const shadow::Gpu& gpu);
  /// True when the region is drawn, false where it has to go on.
  Result<bool> dispatch(const shadow::Gpu& gpu);
  std::shared_ptr<const RenderScene> scene_;
  LightSet lights_;
  std::shared_ptr<Picture> picture_;
  std::shared_ptr<const Picture> seed_;
  residency::VolumeSet set_;
  residency::Residency residency_;
  residency::TileLists tiles_;
  gl::RegionCursor cursor_;
  MarchBudget budget_;
  int pauseAfter_ = 0, dispatches_ = 0;
  bool emission_ = false;  ///< counts, and there is some
  gl::GpuTimer timer_;
};

}  // namespace pileus::view
