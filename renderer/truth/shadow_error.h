#pragma once
// The error of shadow maps where a picture looks: at every sample of its camera rays, transmittance by the
// map minus transmittance by a march. GL thread.
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/texture.h"
#include "renderer/view/camera_march.h"
#include "renderer/view/sampled_lights.h"

namespace pileus::truth {

/// How often which |dT| occurred, in the bins of shared/compare.h. The GPU counts in 32 bits, a region at a
/// time; the sums here do not overflow.
class ErrorHistogram {
 public:
  void add(std::span<const unsigned> bins);
  /// |dT| that a share q of all does not exceed; 0 for none, and where it is below the first bin. At most
  /// `maximum`.
  double quantile(double q, double maximum) const;

 private:
  std::vector<std::uint64_t> bins_;
};

class ShadowErrorPass {
 public:
  static constexpr int kPairs = MAX_LIGHTS / 2;  ///< of lights, as many as one dispatch may hold
  /// `truth` is the same scene with marched shadows (truthOf). Lights without a shadow have no part in it; of
  /// environments the middles have (view::SampledLights). A dispatch takes `pairs` of them.
  ShadowErrorPass(const view::RenderScene& scene, const view::RenderScene& truth, int pairs = kPairs);
  /// Cuts every march into dispatches of so many loop iterations a pixel, needed or not (or
  /// residency::MarchBudget::kNever); before the first step.
  void pauseAfter(int iterations) { pauseAfter_ = iterations; }
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  double fraction() const { return fraction_; }

  // Of what is done so far.
  double samples() const { return samples_; }
  double mean() const { return samples_ > 0 ? sum_ / samples_ : 0; }  ///< of |dT|, every sample alike
  double maximum() const { return maximum_; }
  /// |dT| that a share q of the samples does not exceed; to 1.4 %, 0 below 1e-6.
  double quantile(double q) const { return histogram_.quantile(q, maximum_); }
  double leak() const {
    return seen_ > 0 ? leak_ / seen_ : 0;
  }  ///< mean of the pixels' max(dT, 0), each counted by what is seen
  double dark() const { return seen_ > 0 ? dark_ / seen_ : 0; }

  /// RGBA32F, as in truth/shadow_error.comp.glsl; no texture before the first region.
  const gl::Texture& errors() const { return errors_; }
  const gl::Texture& transmittances() const { return transmittances_; }

 private:
  /// The pairs, once all their maps are there: true.
  Result<bool> pairUp(const shadow::Gpu& gpu, double ms);
  Result<void> start(const gl::DeviceInfo& device);
  Result<void> draw(const shadow::Gpu& gpu, view::LightSet& lights, residency::MarchBudget& budget,
                    ivec2 from, ivec2 to);
  Result<void> collect(ivec2 from, ivec2 to);
  Result<void> clearBins();
  view::RenderOptions options_;
  volume::InstanceList volumes_;
  scene::SolidList solids_;
  view::SampledLights mapped_, truth_;
  int pairsAtOnce_;
  std::vector<view::LightSet> groups_;           ///< pairs of lights, each a dispatch
  std::vector<residency::MarchBudget> budgets_;  ///< of each group
  int pauseAfter_ = 0;
  view::CameraMarch march_;
  gl::Texture errors_, transmittances_;
  gl::Buffer bins_{"error bins"};  ///< of the region at work
  ErrorHistogram histogram_;
  ivec2 next_{0};          ///< first pixel of the next region
  std::size_t group_ = 0;  ///< first one whose part of that region is missing
  int width_ = 16;         ///< of a region: grows and shrinks with the time one takes
  double fraction_ = 0;
  double sum_ = 0, samples_ = 0, maximum_ = 0, leak_ = 0, dark_ = 0, seen_ = 0;
};

}  // namespace pileus::truth
