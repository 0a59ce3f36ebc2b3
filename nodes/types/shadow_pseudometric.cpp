// shadow.pseudometric: how far each light ray is through the media.
#include "nodes/types/passes.h"
#include "nodes/types/shadow_common.h"
#include "renderer/shadow/pseudometric_map.h"

namespace pileus::nodes {
namespace {

using shadow::MetricOptions;
using Pass = shadow::PseudometricPass;

struct Out {
  MetricValue metric;
};

void describe(Describe<MetricIn, Out>& d) {
  d.name("Pseudometric Map").category("Shadow").keywords("metric distance interval coverage gautron vaem");
  d.help(
      "Measures distance along each light ray only where media are, so that an extinction map spends its "
      "coefficients inside them "
      "and every gap costs nothing (Gautron et al. 2011, pass 1).");
  d.uses(UsesQuality);
  describeCasters(d, "The lights the maps look from; each gets a map of its own.");
  d.in("representation", &MetricIn::metric, &MetricOptions::metric)
      .help("How the coverage along a ray is stored.");
  d.in("intervals", &MetricIn::metric, &MetricOptions::intervals)
      .range(1, 8)
      .help(
          "Interval only: merged [enter, exit] pairs kept per texel. Exact while a ray crosses no more media "
          "than this.");
  d.in("coverage", &MetricIn::metric, &MetricOptions::coverage)
      .help("Interval only: what of a voxel grid counts as medium. Boxes and spheres are always exact.");
  d.in("coefficients", &MetricIn::metric, &MetricOptions::coefficients)
      .range(2, 16)
      .help("Fourier and cosine only: series coefficients kept per texel. The paper uses 4.");
  describeResolution(d, &MetricIn::metric, &MetricOptions::resolution);
  d.in("storage", &MetricIn::metric, &MetricOptions::storage).help("Precision of the stored values.");
  d.in("weighting", &MetricIn::metric, &MetricOptions::weighting)
      .help("Interval only: how much of the metric an interval gets for its length.");
  d.in("horizon", &MetricIn::metric, &MetricOptions::horizon)
      .unit("optical depth")
      .range(0, 1e4)
      .soft(0, 20)
      .help(
          "Interval only: behind this optical depth nothing is resolved, so that a dense cloud's lit side "
          "gets all the coefficients; the total behind it is kept. 0: no horizon.");
  d.in("compact", &MetricIn::metric, &MetricOptions::compact)
      .label("8-bit ends")
      .help(
          "Interval only: keeps interval ends in 8 bits, rounded outwards: a quarter or half of their "
          "memory, best spent on more coefficients. Too coarse where media are thinner than about a "
          "hundredth of the light's depth.");
  d.out("metric", &Out::metric).help("The map with its frustum, light and volumes: for Extinction Map.");
}

/// As the map is made: in a draft smaller, without what only intervals have.
MetricOptions optionsOf(const MetricIn& in, const EvalContext& ctx) {
  MetricOptions options = in.metric;
  options.resolution = draftResolution(options.resolution, ctx);
  if (options.metric != shadow::Metric::Interval)
    options.weighting = shadow::Weighting::None, options.horizon = 0, options.compact = false;
  return options;
}

/// What the suns get that stand for an environment.
std::shared_ptr<const shadow::PseudometricMap> described(const MetricIn& in, const EvalContext& ctx,
                                                         const scene::Light& environment) {
  auto map = std::make_shared<shadow::PseudometricMap>();
  map->options = optionsOf(in, ctx);
  map->light = environment;
  map->volumes = residency::canonical(in.volumes.items);
  return map;
}

Result<Out> evaluate(const MetricIn& in, EvalContext& ctx) {
  PILEUS_TRY(const std::vector<scene::Light> lights, lightsOf(in.light));
  const auto begin = [&](view::Renderer&, std::vector<std::unique_ptr<Pass>>& passes) -> Result<void> {
    const MetricOptions options = optionsOf(in, ctx);
    for (const scene::Light& light : lights)
      if (light.kind != scene::LightKind::Environment)
        passes.push_back(std::make_unique<Pass>(
            options, light, in.volumes.items, shadow::fitLight(light, in.volumes.items, options.resolution)));
    return {};
  };
  PILEUS_TRY(const auto* queue, runPasses<Pass>(ctx, begin));
  Out out;
  std::size_t bytes = 0;
  auto pass = queue->passes.begin();
  for (const scene::Light& light : lights) {
    const bool environment = light.kind == scene::LightKind::Environment;
    out.metric.items.push_back(environment ? described(in, ctx, light) : (*pass++)->map());
    bytes += out.metric.items.back()->bytes();
  }
  out.metric.solids = in.solids.items;
  ctx.reportGpu(0, bytes);
  if (queue->fraction < 1)
    ctx.pending(queue->fraction, "Measuring media");
  else
    warnOfThinMedia(lights, in.volumes.items, in.metric.resolution, ctx);
  return out;
}

}  // namespace

NodeType node_shadow_pseudometric() {
  return makeNode<MetricIn, Out>("shadow.pseudometric", 1, describe, evaluate);
}

}  // namespace pileus::nodes
