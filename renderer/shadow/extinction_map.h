#pragma once
// The extinction map: optical depth projected on a small basis over the pseudometric (Gautron et al. 2011,
// pass 2). Without a metric it is a Fourier opacity map (Jansen and Bavoil 2010) or its cosine kin.
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

/// Errors (Input): splatting with a horizon, which needs a gather; cosines per interval with fewer
/// coefficients than the metric has intervals.
Result<void> checkOptions(const ExtinctionOptions& options, const MetricOptions& metric);

class ExtinctionPass {
 public:
  /// With a metric: its frustum, light and volumes. Errors of the first step: those of checkOptions().
  ExtinctionPass(const ExtinctionOptions& options, std::shared_ptr<const PseudometricMap> metric);
  /// Euclidean.
  ExtinctionPass(const ExtinctionOptions& options, const scene::Light& light,
                 const volume::InstanceList& volumes, const LightFrustum& frustum);
  /// Works for about `ms` milliseconds (at least one region or volume); the fraction done, 1 = finished.
  Result<double> step(const Gpu& gpu, double ms);
  /// Solids and the spec that the map remembers; they change nothing in it.
  void remember(const scene::SolidList& solids, const ShadowSpec& spec);
  std::shared_ptr<const ShadowMap> map() const { return map_; }
  const scene::Light& light() const { return map_->light; }
  double takeGpuMs() { return pass_.takeGpuMs(); }

 private:
  Result<void> allocate(const Gpu& gpu);
  gl::Defines defines() const;
  /// Volumes one dispatch may project on a texel; 0: all there are.
  int batch() const;
  Result<void> gather(const Gpu& gpu);
  Result<void> splat(const Gpu& gpu);
  Result<void> mark(const Gpu& gpu);
  bool splats() const { return options_.accumulation == Accumulation::Splat; }

  ExtinctionOptions options_;
  MapPass pass_;
  std::shared_ptr<ShadowMap> map_;
  gl::Buffer sums_{"extinction sums"};          ///< of a region's texels, between batches
  int splatted_ = 0;                            ///< volumes drawn so far
  gl::Pace rows_{1 << 20, 1 << 20, 1 << 20};    ///< of a volume that are drawn at once
  std::vector<residency::PixelBounds> bounds_;  ///< of all volumes on the map, for splatting
};

}  // namespace pileus::shadow
