#pragma once
// The lights of a picture, sample by sample: environments are a few suns each, others for every sample, so
// that the mean over the samples converges to the whole of their light. GL thread.
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/shadow/shadow_pass.h"

namespace pileus::view {

/// The middles (scene::draftLights) that were made last, for the next picture under the same environments.
struct KeptSuns {
  /// What they stand for: each environment, and what it said of its shadow.
  std::vector<std::pair<std::shared_ptr<const scene::Environment>, std::shared_ptr<const shadow::ShadowMap>>>
      of;
  std::vector<shadow::ShadowedLight> lights;  ///< of these alone, in their order
};

/// False: there were none.
inline bool letGo(KeptSuns& kept) { return !std::exchange(kept, {}).lights.empty(); }

class SampledLights {
 public:
  /// `byChannel`: each light three times, red, green and blue, each through media as they are to it (a shadow
  /// knows one optical depth).
  explicit SampledLights(const std::vector<shadow::ShadowedLight>& lights, bool byChannel = false);
  /// Where the middles are found and left; null: nowhere.
  void keep(std::shared_ptr<KeptSuns> kept) { kept_ = std::move(kept); }

  /// Are there environments?
  bool vary() const;
  /// Makes the lights of a set (scene::environmentLights; none: the middles) for about `ms` milliseconds, at
  /// least a step: their shadows are made as each environment's describes, one after the other. Those of
  /// another set go before. The fraction done; once it is 1 lights() are those.
  Result<double> make(const shadow::Gpu& gpu, std::optional<unsigned> set, double ms);
  /// Suns, points and spots, in the order of the lights (and channels) they stand for.
  const std::vector<shadow::ShadowedLight>& lights() const { return lights_; }
  /// Of the maps that were made here.
  std::size_t bytes() const;
  double ms() const { return ms_; }  ///< that making them took, of all sets
  double takeGpuMs() { return std::exchange(gpuMs_, 0.0); }

 private:
  struct Planned {
    scene::Light light;
    std::shared_ptr<const shadow::ShadowMap> shadow;  ///< its own, or with `made` what to make
    bool made = false;
  };
  void plan(std::optional<unsigned> set);
  KeptSuns kept() const;  ///< of lights_
  bool takeKept();
  Result<bool> makeNext(const shadow::Gpu& gpu, double ms);

  struct Asked {
    shadow::ShadowedLight light;
    vec3 mask{1};       ///< of what it sends
    bool made = false;  ///< its shadow only says how it is made
  };
  std::vector<Asked> all_;
  std::vector<std::shared_ptr<const scene::EnvironmentStrata>> strata_;  ///< of each; null: no environment
  std::shared_ptr<KeptSuns> kept_;
  std::optional<std::optional<unsigned>> set_;  ///< that is planned; none: nothing yet
  std::vector<Planned> planned_;
  std::vector<shadow::ShadowedLight> lights_;
  std::unique_ptr<shadow::ShadowPass> pass_;
  double part_ = 0;  ///< of the map at work
  double gpuMs_ = 0, ms_ = 0;
};

}  // namespace pileus::view
