#pragma once
// Transmittance function map (Delalandre et al. 2011): T along each light ray, marched in order and projected
// on a basis over plain distance. Needs no exponential to read, but rings at both ends of a periodic basis
// and cannot be added up from volumes.
#include <optional>

#include "renderer/shadow/ordered_march.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

class TransmittancePass {
 public:
  /// Reads basis, coefficients, resolution and storage of the spec.
  TransmittancePass(const ShadowSpec& spec, const scene::Light& light, const volume::InstanceList& volumes,
                    const scene::SolidList& solids, const LightFrustum& frustum);
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const Gpu& gpu, double ms);
  std::shared_ptr<const ShadowMap> map() const { return map_; }
  double takeGpuMs() { return pass_.takeGpuMs(); }

 private:
  MapPass pass_;
  std::shared_ptr<ShadowMap> map_;
  std::optional<OrderedMarch> march_;
};

}  // namespace pileus::shadow
