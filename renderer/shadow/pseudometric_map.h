#pragma once
// The pseudometric map: per light texel, how far x along the ray is through the media (Gautron et al. 2011,
// pass 1).
#include "renderer/shadow/map_pass.h"
#include "renderer/shadow/representation.h"

namespace pileus::shadow {

/// Finished and immutable. Carries what an extinction map needs beside it. Of an environment only says what
/// is to be made for each sun that stands for it: there is no block.
struct PseudometricMap {
  MetricOptions options;
  LightFrustum frustum;
  scene::Light light;
  volume::InstanceList volumes;
  std::shared_ptr<const ShadowBlock> block;    ///< null for Metric::None and environments
  std::shared_ptr<const ShadowBlock> weights;  ///< null without weighting
  std::size_t bytes() const { return (block ? block->bytes() : 0) + (weights ? weights->bytes() : 0); }
};

/// Metric values (floats) per texel: 2 K interval ends or n coefficients, rounded up to whole RGBA layers.
int metricFloats(const MetricOptions& options);

/// Builds a map in steps.
class PseudometricPass {
 public:
  PseudometricPass(const MetricOptions& options, const scene::Light& light,
                   const volume::InstanceList& volumes, const LightFrustum& frustum);
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const Gpu& gpu, double ms);
  std::shared_ptr<const PseudometricMap> map() const { return map_; }
  double takeGpuMs() { return pass_.takeGpuMs(); }

 private:
  Result<void> allocate(const Gpu& gpu);
  Result<void> dispatchIntervals(const Gpu& gpu);
  std::shared_ptr<PseudometricMap> map_;
  MapPass pass_;
};

}  // namespace pileus::shadow
