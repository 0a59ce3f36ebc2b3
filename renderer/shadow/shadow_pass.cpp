#include "renderer/shadow/shadow_pass.h"

#include <optional>

#include "renderer/shadow/deep_shadow_map.h"
#include "renderer/shadow/extinction_map.h"
#include "renderer/shadow/new_map.h"
#include "renderer/shadow/transmittance_map.h"

namespace pileus::shadow {
namespace {

/// The two passes a spec with a metric or a near-far range takes.
struct TwoPasses {
  MetricOptions metric;
  ExtinctionOptions extinction;
};

TwoPasses passesOf(const ShadowSpec& spec) {
  if (spec.kind == ShadowSpec::Kind::Extinction) return {spec.metric, spec.extinction};
  // A Fourier opacity map is the Euclidean extinction map; one interval from the nearest to the farthest
  // medium is its near-far range.
  TwoPasses out;
  out.metric.metric = spec.range ? Metric::Interval : Metric::None;
  out.metric.intervals = 1;
  out.metric.resolution = spec.resolution;
  out.metric.storage = spec.storage;
  out.extinction = {Basis::Fourier, spec.coefficients,    spec.resolution,
                    spec.storage,   Accumulation::Gather, spec.damping};
  return out;
}

}  // namespace

struct ShadowPass::Impl {
  ShadowSpec spec;
  scene::Light light;
  volume::InstanceList volumes;
  scene::SolidList solids;
  LightFrustum frustum;
  std::optional<PseudometricPass> metric;
  std::optional<ExtinctionPass> extinction;
  std::optional<TransmittancePass> transmittance;
  std::optional<DeepShadowPass> deep;
  std::shared_ptr<const ShadowMap> marched;

  Result<double> stepTwo(const Gpu& gpu, double ms) {
    const TwoPasses two = passesOf(spec);
    double share = 0;
    if (two.metric.metric != Metric::None) {
      share = 0.4;
      if (!metric) metric.emplace(two.metric, light, volumes, frustum);
      if (!extinction) {
        PILEUS_TRY(const double done, metric->step(gpu, ms));
        if (done < 1) return share * done;
      }
    }
    if (!extinction) {
      if (metric)
        extinction.emplace(two.extinction, metric->map());
      else
        extinction.emplace(two.extinction, light, volumes, frustum);
      extinction->remember(solids, spec);
    }
    PILEUS_TRY(const double done, extinction->step(gpu, ms));
    return share + (1 - share) * done;
  }
};

ShadowPass::ShadowPass(const ShadowSpec& spec, const scene::Light& light, const volume::InstanceList& volumes,
                       const scene::SolidList& solids, const LightFrustum* frustum)
    : impl_(std::make_unique<Impl>()) {
  impl_->spec = spec;
  impl_->light = light;
  impl_->volumes = volumes;
  impl_->solids = solids;
  if (spec.kind == ShadowSpec::Kind::RayMarch)
    impl_->marched = marchedShadow(light, volumes, solids, spec.stepScale);
  else
    impl_->frustum = frustum ? *frustum : fitLight(light, volumes, resolutionOf(spec));
}

ShadowPass::~ShadowPass() = default;

Result<double> ShadowPass::step(const Gpu& gpu, double ms) {
  Impl& i = *impl_;
  switch (i.spec.kind) {
    case ShadowSpec::Kind::Extinction:
    case ShadowSpec::Kind::FourierOpacity:
      return i.stepTwo(gpu, ms);
    case ShadowSpec::Kind::TransmittanceFunction:
      if (!i.transmittance) i.transmittance.emplace(i.spec, i.light, i.volumes, i.solids, i.frustum);
      return i.transmittance->step(gpu, ms);
    case ShadowSpec::Kind::Deep:
      if (!i.deep) i.deep.emplace(i.spec, i.light, i.volumes, i.solids, i.frustum);
      return i.deep->step(gpu, ms);
    case ShadowSpec::Kind::RayMarch:
      break;
  }
  return 1.0;
}

std::shared_ptr<const ShadowMap> ShadowPass::map() const {
  if (impl_->marched) return impl_->marched;
  if (impl_->deep) return impl_->deep->map();
  if (impl_->transmittance) return impl_->transmittance->map();
  return impl_->extinction ? impl_->extinction->map() : nullptr;
}

double ShadowPass::takeGpuMs() {
  double ms = 0;
  if (impl_->metric) ms += impl_->metric->takeGpuMs();
  if (impl_->extinction) ms += impl_->extinction->takeGpuMs();
  if (impl_->transmittance) ms += impl_->transmittance->takeGpuMs();
  if (impl_->deep) ms += impl_->deep->takeGpuMs();
  return ms;
}

std::optional<DeepStatistics> ShadowPass::deepStatistics() const {
  if (!impl_->deep) return std::nullopt;
  return impl_->deep->statistics();
}

std::shared_ptr<const ShadowMap> marchedShadow(const scene::Light& light, const volume::InstanceList& volumes,
                                               const scene::SolidList& solids, double stepScale) {
  ShadowSpec spec;
  spec.kind = ShadowSpec::Kind::RayMarch;
  spec.stepScale = stepScale;
  auto map = newMap(ShadowMap::Kind::RayMarch, spec, light, volumes, solids);
  map->stepScale = stepScale;
  return map;
}

std::shared_ptr<const ShadowMap> describedShadow(const ShadowSpec& spec, const scene::Light& environment,
                                                 const volume::InstanceList& volumes,
                                                 const scene::SolidList& solids) {
  using Kind = ShadowSpec::Kind;
  if (spec.kind == Kind::RayMarch) return marchedShadow(environment, volumes, solids, spec.stepScale);
  const auto kind = spec.kind == Kind::TransmittanceFunction ? ShadowMap::Kind::TransmittanceFunction
                    : spec.kind == Kind::Deep                ? ShadowMap::Kind::Deep
                                                             : ShadowMap::Kind::Extinction;
  return newMap(kind, spec, environment, volumes, solids);
}

Result<std::shared_ptr<const ShadowMap>> buildShadow(const Gpu& gpu, const ShadowSpec& spec,
                                                     const scene::Light& light,
                                                     const volume::InstanceList& volumes,
                                                     const scene::SolidList& solids) {
  ShadowPass pass(spec, light, volumes, solids);
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, 1e12));
  }
  return pass.map();
}

}  // namespace pileus::shadow
