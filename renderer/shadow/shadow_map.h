#pragma once
// A light's shadow: what a representation left behind for lookupTransmittance, or the volumes to march
// through. Of an environment only what it is to be made from (describedShadow()).
#include <cstdint>

#include "renderer/scene/solid.h"
#include "renderer/shadow/pseudometric_map.h"
#include "renderer/shadow/shadowed_light.h"

namespace pileus::shadow {

struct ShadowMap {
  enum class Kind { Extinction, TransmittanceFunction, Deep, RayMarch };
  Kind kind = Kind::Extinction;
  std::uint64_t number = 0;  ///< of this one, never 0 and no other's, as newMap() gives it
  // What it was made from: enough to make the truth beside it.
  scene::Light light;
  volume::InstanceList volumes;
  scene::SolidList solids;  ///< block the light at whatever is lit, exactly; no map holds them
  ShadowSpec spec;          ///< as asked for
  // Extinction, TransmittanceFunction
  Basis basis = Basis::Cosine;
  int coefficients = 8;
  Storage storage = Storage::Float;
  LightFrustum frustum;                           ///< Deep too
  std::shared_ptr<const PseudometricMap> metric;  ///< null: Euclidean
  std::shared_ptr<const ShadowBlock> block;
  std::shared_ptr<const ShadowBlock>
      horizon;  ///< (tau in all, x from there to the last exit) where the metric has a horizon
  // Deep
  std::shared_ptr<const DeepBlock> deep;
  // RayMarch
  double stepScale = 0.5;  ///< of a voxel

  std::size_t bytes() const;  ///< GPU memory of the map, its metric included
  /// Mean over the map's texels; 0 for RayMarch.
  double bytesPerTexel() const;
};

/// The shader's record; `metric` and `block` may lie anywhere in the store now (make records anew each time
/// they are bound). Lists of marched volumes and of solids are the caller's: items.yz (ray march) and
/// solids.xy stay 0. Its places are relative to `origin` (world, metres).
gpu::LightRecord makeRecord(const scene::Light& light, const ShadowMap* shadow,
                            const dvec3& origin = dvec3(0));

/// Variant constants for programs that look up these lights: METRIC_FLOATS, BASIS_FLOATS, STORES,
/// LIGHT_KINDS, WEIGHTS, HORIZON.
gl::Defines lookupDefines(std::span<const ShadowedLight> lights);

}  // namespace pileus::shadow
