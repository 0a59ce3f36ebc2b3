#pragma once
// A light's shadow: what a representation left behind for lookupTau, or the volumes to march through.
#include "renderer/shadow/pseudometric_map.h"
#include "renderer/shadow/shadowed_light.h"

namespace pileus::shadow {

struct ShadowMap {
  enum class Kind { Extinction, RayMarch };
  Kind kind = Kind::Extinction;
  // Extinction
  Basis basis = Basis::Cosine;
  int coefficients = 8;
  Storage storage = Storage::Float;
  LightFrustum frustum;
  std::shared_ptr<const PseudometricMap> metric;  ///< null: Euclidean
  std::shared_ptr<const ShadowBlock> block;
  // RayMarch
  volume::InstanceList volumes;
  double stepScale = 0.5;   ///< of a voxel

  std::size_t bytes() const;  ///< GPU memory of the map, its metric included
};

/// The shader's record; `metric` and `block` may lie anywhere in the store now (make records anew each time they are bound).
gpu::LightRecord makeRecord(const scene::Light& light, const ShadowMap* shadow);

/// Variant constants for programs that look up these lights: METRIC_FLOATS, BASIS_FLOATS, STORES, LIGHT_KINDS.
gl::Defines lookupDefines(std::span<const ShadowedLight> lights);

}  // namespace pileus::shadow
