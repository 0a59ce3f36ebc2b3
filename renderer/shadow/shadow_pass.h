#pragma once
// Builds any representation of one light's shadow in steps: what nodes, the shoot-out and the tuner call. GL
// thread.
#include <memory>
#include <optional>

#include "renderer/shadow/deep_shadow_map.h"
#include "renderer/shadow/gpu.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

class ShadowPass {
 public:
  /// Volumes and solids that cast; the frustum is fitted to the light and the volumes unless one is given.
  ShadowPass(const ShadowSpec& spec, const scene::Light& light, const volume::InstanceList& volumes,
             const scene::SolidList& solids = {}, const LightFrustum* frustum = nullptr);
  ~ShadowPass();
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const Gpu& gpu, double ms);
  /// Finished and immutable once step() said 1.
  std::shared_ptr<const ShadowMap> map() const;
  double takeGpuMs();
  /// What compression did; only for deep maps.
  std::optional<DeepStatistics> deepStatistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The same light's shadow by marching: the truth a map is compared with.
std::shared_ptr<const ShadowMap> marchedShadow(const scene::Light& light, const volume::InstanceList& volumes,
                                               const scene::SolidList& solids, double stepScale = 0.5);

/// What each sun that stands for an environment is to have: a shadow without a map, never looked up.
std::shared_ptr<const ShadowMap> describedShadow(const ShadowSpec& spec, const scene::Light& environment,
                                                 const volume::InstanceList& volumes,
                                                 const scene::SolidList& solids);

/// Builds to the end, for command lines and tests.
Result<std::shared_ptr<const ShadowMap>> buildShadow(const Gpu& gpu, const ShadowSpec& spec,
                                                     const scene::Light& light,
                                                     const volume::InstanceList& volumes,
                                                     const scene::SolidList& solids = {});

}  // namespace pileus::shadow
