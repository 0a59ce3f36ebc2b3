#pragma once
// Deep shadow map (Lokovic and Veach 2000): per texel a piecewise-linear transmittance, compressed under an
// error bound. Two marches: one counts the vertices of each texel, one writes them to their place.
#include <optional>

#include "renderer/gl/texture.h"
#include "renderer/shadow/ordered_march.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

/// What compression did.
struct DeepStatistics {
  std::size_t vertices = 0, rawVertices = 0;  ///< kept; before compression
  std::size_t texels = 0;
  std::size_t overBudget = 0;  ///< texels whose bound was raised to stay within the node budget
  double worstBound = 0;       ///< the largest bound used
  double compression() const { return vertices ? double(rawVertices) / double(vertices) : 1; }
};

class DeepShadowPass {
 public:
  /// Reads errorBound, nodeBudget, filter and resolution of the spec.
  DeepShadowPass(const ShadowSpec& spec, const scene::Light& light, const volume::InstanceList& volumes,
                 const scene::SolidList& solids, const LightFrustum& frustum);
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const Gpu& gpu, double ms);
  std::shared_ptr<const ShadowMap> map() const { return map_; }
  const DeepStatistics& statistics() const { return statistics_; }  ///< once the vertices are counted
  double takeGpuMs() { return pass_.takeGpuMs(); }

 private:
  Result<void> run(const Gpu& gpu, bool fill);
  bool overBudget() const;
  Result<void> place(const Gpu& gpu);
  MapPass pass_;
  std::shared_ptr<ShadowMap> map_;
  std::optional<OrderedMarch> march_;
  gl::Texture counts_;  ///< a layer for each face: one tall texture would soon be beyond what drivers hold
  DeepStatistics statistics_;
};

}  // namespace pileus::shadow
