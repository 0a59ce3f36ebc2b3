// shadow.extinction: extinction along each light ray, projected on a small basis.
#include <optional>

#include "nodes/types/passes.h"
#include "nodes/types/shadow_common.h"
#include "renderer/shadow/extinction_map.h"
#include "renderer/shadow/shadow_pass.h"

namespace pileus::nodes {
namespace {

using shadow::ExtinctionOptions;
using shadow::ShadowSpec;

/// The map of one light; of an environment, what its suns get.
struct Pass {
  std::optional<shadow::ExtinctionPass> made;
  std::shared_ptr<const shadow::ShadowMap> described;

  Pass(const ExtinctionOptions& options, std::shared_ptr<const shadow::PseudometricMap> metric,
       const scene::SolidList& solids, const ShadowSpec& spec) {
    if (metric->light.kind == scene::LightKind::Environment) {
      described = shadow::describedShadow(spec, metric->light, metric->volumes, solids);
      return;
    }
    made.emplace(options, std::move(metric));
    made->remember(solids, spec);
  }
  Pass(const scene::Light& light, const volume::InstanceList& volumes, const scene::SolidList& solids,
       const ShadowSpec& spec) {
    if (light.kind == scene::LightKind::Environment) {
      described = shadow::describedShadow(spec, light, volumes, solids);
      return;
    }
    const ExtinctionOptions& options = spec.extinction;
    made.emplace(options, light, volumes, shadow::fitLight(light, volumes, options.resolution));
    made->remember(solids, spec);
  }
  Result<double> step(const shadow::Gpu& gpu, double ms) {
    return made ? made->step(gpu, ms) : Result<double>(1.0);
  }
  std::shared_ptr<const shadow::ShadowMap> map() const { return made ? made->map() : described; }
  double takeGpuMs() { return made ? made->takeGpuMs() : 0; }
};

ShadowIn defaults() {
  ShadowIn in = ofKind(ShadowSpec::Kind::Extinction);
  in.spec.extinction.resolution = 0;
  in.spec.extinction.coefficients = 32;
  in.spec.extinction.storage = shadow::Storage::Half;
  return in;
}

void describe(Describe<ShadowIn, ShadowOut>& d) {
  const auto options = &ShadowSpec::extinction;
  d.name("Extinction Map")
      .category("Shadow")
      .keywords("shadow transmittance coefficients fourier cosine opacity vaem gautron");
  d.help(
      "Projects optical depth along each light ray, as a function of the pseudometric, into a small basis; "
      "its integral gives the "
      "transmittance at any point of the ray. Order-independent and rebuilt whenever anything changes. "
      "Without a metric the map is "
      "Euclidean: plain distance along the ray.");
  d.uses(UsesQuality);
  d.in("metric", &ShadowIn::metric)
      .help("Pseudometric maps; they bring their lights, volumes, solids and frusta with them.");
  d.in("volumes", &ShadowIn::volumes).many().help("The media that cast shadows, where no metric is linked.");
  d.in("light", &ShadowIn::light).help("The lights, where no metric is linked; each gets a map of its own.");
  d.in("solids", &ShadowIn::solids)
      .many()
      .help("Opaque solids that block the light, exactly, where no metric is linked.");
  d.in("basis", &ShadowIn::spec, options, &ExtinctionOptions::basis)
      .help("Functions extinction is projected on.");
  d.in("coefficients", &ShadowIn::spec, options, &ExtinctionOptions::coefficients)
      .range(1, 32)
      .help("Basis functions kept per texel. The paper uses 8.");
  d.in("resolution", &ShadowIn::spec, options, &ExtinctionOptions::resolution)
      .unit("texels")
      .range(0, 4096)
      .help("Texels along each edge of the map. 0: the metric's, or 1024 without one.");
  d.in("storage", &ShadowIn::spec, options, &ExtinctionOptions::storage)
      .help("Precision of the stored coefficients.");
  d.in("accumulation", &ShadowIn::spec, options, &ExtinctionOptions::accumulation)
      .help("How the volumes of a texel are added up. A horizon of the metric needs gathering.");
  describeDamping(d, &ShadowIn::spec, options, &ExtinctionOptions::damping);
  describeShadowed(d);
}

/// What is wired beside a metric must be what the metric holds.
Result<void> checkAgainstMetric(const ShadowIn& in) {
  const auto& metrics = in.metric.items;
  if (!in.volumes.items.empty() && volume::contentKey(residency::canonical(in.volumes.items)) !=
                                       volume::contentKey(metrics.front()->volumes))
    return fail(Code::Input, "volumes: differ from the metric's; link the same volumes or none");
  bool same = in.light.items.size() == metrics.size();
  for (std::size_t i = 0; same && i < metrics.size(); ++i)
    same = in.light.items[i].light == metrics[i]->light;
  if (!in.light.items.empty() && !same)
    return fail(Code::Input, "light: differs from the metric's; link the same light or none");
  if (!in.solids.items.empty() && in.solids.items != in.metric.solids)
    return fail(Code::Input, "solids: differ from the metric's; link the same solids or none");
  return {};
}

Result<void> begin(const ShadowIn& in, const EvalContext& ctx, std::vector<std::unique_ptr<Pass>>& passes) {
  ExtinctionOptions options = in.spec.extinction;
  const int wanted = options.resolution;
  if (wanted != 0 && wanted < 64)
    return fail(Code::Input, "resolution: {} is neither 0 nor within 64..4096", wanted);
  ShadowSpec spec = in.spec;
  if (!in.metric.items.empty()) {
    PILEUS_CHECK(checkAgainstMetric(in));
    for (const auto& metric : in.metric.items) {
      // In a draft the metric's own resolution is already the draft's.
      options.resolution = wanted == 0 ? metric->options.resolution : draftResolution(wanted, ctx);
      spec.metric = metric->options, spec.extinction = options;
      PILEUS_CHECK(shadow::checkOptions(options, metric->options));
      passes.push_back(std::make_unique<Pass>(options, metric, in.metric.solids, spec));
    }
    return {};
  }
  if (in.light.items.empty())
    return fail(Code::Input, "light: nothing is linked; link a metric, or a light and volumes");
  options.resolution = draftResolution(wanted == 0 ? 1024 : wanted, ctx);
  spec.metric.metric = shadow::Metric::None, spec.extinction = options;
  for (const LightWithShadow& l : in.light.items)
    passes.push_back(std::make_unique<Pass>(l.light, in.volumes.items, in.solids.items, spec));
  return {};
}

Result<ShadowOut> evaluate(const ShadowIn& in, EvalContext& ctx) {
  PILEUS_TRY(const auto* queue,
             runPasses<Pass>(ctx, [&](view::Renderer&, auto& passes) { return begin(in, ctx, passes); }));
  ShadowOut out;
  std::size_t bytes = 0;
  for (const auto& pass : queue->passes) {
    const auto& map = pass->map();
    bytes += (map->block ? map->block->bytes() : 0) + (map->horizon ? map->horizon->bytes() : 0);
    out.light.items.push_back({map->light, map});
  }
  ctx.reportGpu(0, bytes);
  if (queue->fraction < 1) ctx.pending(queue->fraction, "Projecting extinction");
  return out;
}

}  // namespace

NodeType node_shadow_extinction() {
  return makeNode<ShadowIn, ShadowOut>("shadow.extinction", 1, describe, evaluate, defaults());
}

}  // namespace pileus::nodes
