#pragma once
// Single scattering through any number of overlapping volumes, and opaque solids, under any number of shadowed lights; progressive over
// regions and samples.
#include "renderer/gl/gpu_timer.h"
#include "renderer/gl/region_cursor.h"
#include "renderer/residency/tile_lists.h"
#include "renderer/residency/volume_set.h"
#include "renderer/shadow/gpu.h"
#include "renderer/view/light_set.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

class VolumeRenderPass {
 public:
  explicit VolumeRenderPass(RenderScene scene);
  VolumeRenderPass(const RenderOptions& options, const volume::InstanceList& volumes, std::vector<shadow::ShadowedLight> lights)
      : VolumeRenderPass(RenderScene{options, volumes, std::move(lights), {}}) {}
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Null until the first region is drawn; the same object from then on, its texels improving until step() said 1.
  std::shared_ptr<const Picture> picture() const { return picture_; }
  /// What the brick pool could hold, as of the last step.
  const residency::Residency& residency() const { return residency_; }
  double takeGpuMs() { return timer_.takeMs(); }

 private:
  void start(const shadow::Gpu& gpu);
  Result<void> dispatch(const shadow::Gpu& gpu);
  std::shared_ptr<const RenderScene> scene_;
  LightSet lights_;
  std::shared_ptr<Picture> picture_;
  residency::VolumeSet set_;
  residency::Residency residency_;
  residency::TileLists tiles_;
  gl::RegionCursor cursor_;
  gl::GpuTimer timer_;
};

}  // namespace pileus::view
