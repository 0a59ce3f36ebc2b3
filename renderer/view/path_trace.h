#pragma once
// All orders of scattering without bias: a progressive path tracer by null collisions
// (shaders/view/path_trace.comp.glsl). GL thread.
#include <array>
#include <optional>

#include "renderer/base/enum_info.h"
#include "renderer/base/profile.h"
#include "renderer/gl/pace.h"
#include "renderer/residency/majorants.h"
#include "renderer/residency/region_run.h"
#include "renderer/view/environment_table.h"
#include "renderer/view/light_set.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

/// How the transmittance of shadow rays is estimated.
enum class ShadowEstimate {
  Series,  ///< a power series around what the light's map says, or a first estimate where it has none
  Ratio    ///< ratio tracking
};

constexpr auto enumInfo(ShadowEstimate*) {
  using E = ShadowEstimate;
  return std::array{EnumItem<E>{E::Series, "series", "Series",
                                "A power series around what the light's shadow map says, or around a first "
                                "estimate where it has none."},
                    EnumItem<E>{E::Ratio, "ratio", "Ratio Tracking",
                                "From null collision to null collision. Noisier; for cross-checks."}};
}

struct PathOptions {
  int bounces = -1;    ///< vertices that scatter behind the first; -1: no limit
  double seconds = 0;  ///< ends behind a whole sample; 0: no limit
  double noise = 0;    ///< ends where sqrt(mean variance of pixel means)/mean is below it; 0: no limit
  ShadowEstimate transmittance = ShadowEstimate::Series;
  ivec2 orders{0, 1 << 30};  ///< only what has scattered so often less one
  int firstPath = 0;  ///< number of the first sample's path: pictures whose paths differ are independent
  // For tests: what must not change a mean.
  double majorantScale = 1;
  double skyChoice = -1;  ///< factor of the environment's part in the choice of lights; < 0: its contrast
  bool alongRays = true;  ///< places are also chosen by how near they are to points and spots in the media
  double mapFactor = -1;  ///< instead of what maps say in the choice of lights; < 0: what they say
  double unshadowedShare = 0.2;  ///< of that choice by power alone
  int workPerDispatch = 0;       ///< > 0: fixed
};

/// Of all samples so far.
struct PathStatistics {
  int samples = 0;
  double mean = 0;           ///< over RGB of pixels with alpha above 0.01
  double standardError = 0;  ///< sqrt(mean variance of pixel means), of the same
  long violations = 0;       ///< collisions that were denser than their bound
  long endless = 0;          ///< paths that were cut off
};

class PathTracePass {
 public:
  PathTracePass(RenderScene scene, const PathOptions& options);
  /// Works for about `ms` milliseconds (at least one dispatch); the fraction done, 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// As VolumeRenderPass has it.
  void beginWith(std::shared_ptr<const Picture> seed) { seed_ = std::move(seed); }
  std::shared_ptr<const Picture> picture() const { return picture_; }
  /// To the finished picture.
  void addLayer(Picture::Named layer) { picture_->layers.push_back(std::move(layer)); }
  const residency::Residency& residency() const { return residency_; }
  /// Of whole samples; reads the picture back.
  PathStatistics statistics() const;
  /// What of them the noise limit asks for (no counts of violations), summed on the GPU.
  Result<PathStatistics> noise(const shadow::Gpu& gpu);
  /// Variances of pixel means, rgb and alpha.
  Result<std::shared_ptr<const Picture>> variance() const;
  /// Means of the even samples and of the odd ones, which are independent; of two samples at least.
  Result<std::array<image::Image, 2>> halves() const;
  /// Did the clock end it? Then it is another picture each time.
  bool endedByTime() const { return endedByTime_; }
  double takeGpuMs() { return run_.takeGpuMs(); }

 private:
  Result<void> start(const shadow::Gpu& gpu);
  Result<bool> dispatch(const shadow::Gpu& gpu);
  int roundEnd() const;
  Result<bool> enough(const shadow::Gpu& gpu);
  void finish();
  std::shared_ptr<const RenderScene> scene_;
  PathOptions options_;
  LightSet lights_;
  EnvironmentTable environment_;
  Backdrop backdrop_;
  residency::Majorants majorants_;
  std::uint64_t majorantsFor_ = ~std::uint64_t(0);
  residency::RegionRun run_;
  std::shared_ptr<Picture> picture_;
  std::shared_ptr<const Picture> seed_;
  gl::Texture deviations_, odd_;
  gl::Buffer states_{"path states"}, sums_{"path sums"};
  gl::Pace pace_{1, 1, 1};
  int dispatched_ = 0;  ///< of the region at work
  long violations_ = 0, endless_ = 0;
  residency::Residency residency_;
  double spentMs_ = 0;
  bool endedByTime_ = false, emission_ = false, done_ = false;
};

}  // namespace pileus::view
