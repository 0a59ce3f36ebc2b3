#include "renderer/truth/shadow_measure.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "renderer/base/profile.h"
#include "renderer/scene/environment_strata.h"

namespace pileus::truth {
namespace {

constexpr int kBuilds = 3;
constexpr double kOnceMs = 5000,
                 kTwiceMs = 500;  ///< a map that takes longer is built no more than once, or twice

}  // namespace

std::vector<Caster> casters(const view::RenderScene& scene) {
  std::vector<Caster> out;
  for (const shadow::ShadowedLight& l : scene.lights) {
    const bool environment = l.light.kind == scene::LightKind::Environment;
    out.push_back({int(out.size()), environment ? scene::mainSun(*l.light.environment) : l.light,
                   l.shadow ? l.shadow->volumes : scene.volumes, l.shadow ? l.shadow->solids : scene.solids});
  }
  return out;
}

std::unique_ptr<SampleJob> startSampling(std::vector<Caster> casters, const SampleOptions& options) {
  return std::make_unique<SampleJob>(
      [casters = std::move(casters), options](JobControl& control) -> Result<std::vector<ShadowSamples>> {
        std::vector<ShadowSamples> out;
        for (const Caster& c : casters) {
          auto samples = sampleShadow(c.source, c.volumes, options, control);
          if (!samples)
            return fail(samples.error().code, "light {}: {}", c.light + 1, samples.error().message);
          out.push_back(std::move(samples).value());
        }
        return out;
      });
}

Result<bool> takeSamples(std::unique_ptr<SampleJob>& job, std::vector<ShadowSamples>& samples, double ms) {
  const Stopwatch clock;
  while (!job->done()) {
    if (clock.ms() >= ms) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (!job->result()) return job->result().error();
  samples = *job->result();
  job.reset();
  return true;
}

MeasurePass::MeasurePass(const shadow::ShadowSpec& spec, const Caster& caster, const ShadowSamples& samples,
                         int dispatches)
    : caster_(caster), samples_(samples), dispatches_(dispatches) {
  measure_.light = caster.light;
  measure_.spec = spec;
  if (spec.kind == shadow::ShadowSpec::Kind::RayMarch) {
    map_ = shadow::marchedShadow(caster.source, caster.volumes, caster.solids, spec.stepScale);
    return;
  }
  startBuild();
}

void MeasurePass::startBuild() {
  pass_ =
      std::make_unique<shadow::ShadowPass>(measure_.spec, caster_.source, caster_.volumes, caster_.solids);
  thisBuildMs_ = 0;
}

Result<double> MeasurePass::step(const shadow::Gpu& gpu, double ms) {
  if (pass_) {
    glFinish();
    const Stopwatch clock;
    PILEUS_TRY(const double done, pass_->step(gpu, ms));
    glFinish();
    thisBuildMs_ += clock.ms();
    if (done < 1) return 0.8 * (builds_ + done) / kBuilds;
    map_ = pass_->map();
    pass_.reset();
    // The first build compiles what it needs and is not counted, unless it is the only one.
    measure_.buildMs = builds_ < 2 ? thisBuildMs_ : std::min(measure_.buildMs, thisBuildMs_);
    spentMs_ += thisBuildMs_;
    ++builds_;
    if (dispatches_ > 0 && builds_ < kBuilds && spentMs_ < (builds_ == 1 ? kOnceMs : kTwiceMs)) startBuild();
    return pass_ ? 0.8 * builds_ / kBuilds : 0.8;
  }
  PILEUS_TRY(const ProbeResult result, probe(gpu, *map_, samples_, dispatches_));
  measure_.error = result.error;
  measure_.nsPerLookup = result.nsPerLookup;
  measure_.bytes = map_->bytes();
  measure_.bytesPerTexel = map_->bytesPerTexel();
  return 1.0;
}

}  // namespace pileus::truth
