#pragma once
// Single scattering through any number of overlapping volumes under any number of shadowed lights, progressive over regions and samples.
#include "renderer/scene/camera.h"
#include "renderer/shadow/shadow_map.h"
#include "renderer/view/picture.h"

namespace pileus::view {

struct RenderOptions {
  ivec2 size{1280, 720};
  int samples = 16;
  double stepScale = 1;   ///< of the finest detail or pixel footprint
  scene::Camera camera;
};

class VolumeRenderPass {
 public:
  VolumeRenderPass(const RenderOptions& options, const volume::InstanceList& volumes, std::vector<shadow::ShadowedLight> lights);
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
  RenderOptions options_;
  volume::InstanceList all_;                  ///< drawn volumes first, then those only shadows march through
  std::size_t drawn_ = 0;
  std::vector<shadow::ShadowedLight> lights_;
  std::vector<ivec2> marched_;                ///< per light: first and count in shadowItems
  std::vector<int> shadowItems_;
  std::shared_ptr<Picture> picture_;
  residency::VolumeSet set_;
  residency::Residency residency_;
  residency::TileLists tiles_;
  gl::Buffer records_{"light records"}, items_{"shadow items"};
  gl::RegionCursor cursor_;
  gl::GpuTimer timer_;
};

}  // namespace pileus::view
