#pragma once
// The extinction map: optical depth projected on a small basis over the pseudometric (Gautron et al. 2011, pass 2).
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

struct ExtinctionOptions {
  Basis basis = Basis::Cosine;
  int coefficients = 8;     ///< 1..32
  int resolution = 1024;
  Storage storage = Storage::Float;
};

class ExtinctionPass {
 public:
  /// With a metric: its frustum, light and volumes.
  ExtinctionPass(const ExtinctionOptions& options, std::shared_ptr<const PseudometricMap> metric);
  /// Euclidean.
  ExtinctionPass(const ExtinctionOptions& options, const scene::Light& light, const volume::InstanceList& volumes, const LightFrustum& frustum);
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const Gpu& gpu, double ms);
  std::shared_ptr<const ShadowMap> map() const { return map_; }
  const scene::Light& light() const { return light_; }
  double takeGpuMs() { return timer_.takeMs(); }

 private:
  Result<void> dispatch(const Gpu& gpu);
  ExtinctionOptions options_;
  std::shared_ptr<ShadowMap> map_;
  scene::Light light_;
  volume::InstanceList volumes_;
  residency::VolumeSet set_;
  residency::TileLists tiles_;
  gl::Buffer record_{"light record"};
  gl::RegionCursor cursor_;
  gl::GpuTimer timer_;
  bool ready_ = false;
};

}  // namespace pileus::shadow
