#pragma once
// One representation of one light's shadow, built and judged in steps: what comparisons and searches repeat.
// GL thread.
#include <memory>
#include <vector>

#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/shadow_probe.h"
#include "renderer/view/render_scene.h"

namespace pileus::truth {

/// A light and what throws its shadow.
struct Caster {
  int light = 0;                 ///< index in the scene's lights
  scene::Light source;           ///< of an environment its main sun
  volume::InstanceList volumes;  ///< of its shadow where it has one, else the scene's
  scene::SolidList solids;
};
std::vector<Caster> casters(const view::RenderScene& scene);

/// Samples of each caster, in their order, taken in the background. The Error names the light by its number,
/// from 1.
using SampleJob = Job<std::vector<ShadowSamples>>;
std::unique_ptr<SampleJob> startSampling(std::vector<Caster> casters, const SampleOptions& options);

/// Waits for about `ms` milliseconds; true: the samples are taken over, and the job is gone. Its Error
/// otherwise.
Result<bool> takeSamples(std::unique_ptr<SampleJob>& job, std::vector<ShadowSamples>& samples, double ms);

struct ShadowMeasure {
  int light = 0;
  shadow::ShadowSpec spec;
  ShadowError error;
  double buildMs = 0;  ///< waited for, and programs compiled before; the fastest of those that were timed
  double nsPerLookup = 0;
  std::size_t bytes = 0;
  double bytesPerTexel = 0;
};

/// `samples` outlives it.
class MeasurePass {
 public:
  /// `dispatches` as in probe(). 0: lookups are not timed, and the map is built once, perhaps with the
  /// compilation of its programs.
  MeasurePass(const shadow::ShadowSpec& spec, const Caster& caster, const ShadowSamples& samples,
              int dispatches);
  /// Builds for about `ms` milliseconds; the last step looks up all samples at once, up to about 0.3 s on a
  /// CPU. The fraction done.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Once step() said 1.
  const ShadowMeasure& measure() const { return measure_; }
  std::shared_ptr<const shadow::ShadowMap> map() const { return map_; }

 private:
  void startBuild();
  const Caster& caster_;
  const ShadowSamples& samples_;
  int dispatches_;
  ShadowMeasure measure_;
  int builds_ = 0;
  double thisBuildMs_ = 0, spentMs_ = 0;  ///< spent: of all
  std::unique_ptr<shadow::ShadowPass> pass_;
  std::shared_ptr<const shadow::ShadowMap> map_;
};

}  // namespace pileus::truth
