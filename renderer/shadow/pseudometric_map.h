#pragma once
// The pseudometric map: per light texel, how far x along the ray is through the media (Gautron et al. 2011, pass 1).
#include "renderer/gl/gpu_timer.h"
#include "renderer/gl/region_cursor.h"
#include "renderer/residency/tile_lists.h"
#include "renderer/residency/volume_set.h"
#include "renderer/shadow/gpu.h"
#include "renderer/shadow/light_frustum.h"
#include "renderer/shadow/representation.h"

namespace pileus::shadow {

struct MetricOptions {
  Metric metric = Metric::Interval;
  int intervals = 4;        ///< Interval: 1..8
  int coefficients = 4;     ///< series: 2..16
  int resolution = 1024;    ///< texels along an edge
  Storage storage = Storage::Float;
  Coverage coverage = Coverage::Bricks;  ///< Interval only
};

/// Finished and immutable. Carries what an extinction map needs beside it.
struct PseudometricMap {
  MetricOptions options;
  LightFrustum frustum;
  scene::Light light;
  volume::InstanceList volumes;
  std::shared_ptr<const ShadowBlock> block;  ///< null for Metric::None
};

/// Metric values (floats) per texel: 2 K interval ends or n coefficients, rounded up to whole RGBA layers.
int metricFloats(const MetricOptions& options);

/// Builds a map in steps.
class PseudometricPass {
 public:
  PseudometricPass(const MetricOptions& options, const scene::Light& light, const volume::InstanceList& volumes, const LightFrustum& frustum);
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const Gpu& gpu, double ms);
  std::shared_ptr<const PseudometricMap> map() const { return map_; }
  double takeGpuMs() { return timer_.takeMs(); }

 private:
  Result<void> dispatchIntervals(const Gpu& gpu);
  Result<void> drawFaces(const Gpu& gpu);
  std::shared_ptr<PseudometricMap> map_;
  residency::VolumeSet set_;
  residency::TileLists tiles_;
  gl::Buffer record_{"light record"};
  gl::RegionCursor cursor_;
  gl::GpuTimer timer_;
  bool ready_ = false;
};

/// Map texels each instance of `set` may touch, for tile lists.
std::vector<residency::PixelBounds> mapBounds(const volume::InstanceList& instances, const LightFrustum& frustum, int resolution);

}  // namespace pileus::shadow
