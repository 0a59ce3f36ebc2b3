// shadow.extinction: extinction along each light ray, projected on a small basis.
#include "nodes/declare/describe.h"
#include "nodes/types/shadow_common.h"
#include "renderer/shadow/extinction_map.h"
#include "renderer/view/renderer.h"

namespace pileus::nodes {
namespace {

struct In {
  MetricValue metric;
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  shadow::Basis basis = shadow::Basis::Cosine;
  int coefficients = 8;
  int resolution = 0;
  shadow::Storage storage = shadow::Storage::Float;
  shadow::Accumulation accumulation = shadow::Accumulation::Gather;
  bool damping = false;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
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
  d.in("metric", &In::metric)
      .help("Pseudometric maps; they bring their lights, volumes, solids and frusta with them.");
  d.in("volumes", &In::volumes).many().help("The media that cast shadows, where no metric is linked.");
  d.in("light", &In::light).help("The lights, where no metric is linked; each gets a map of its own.");
  d.in("solids", &In::solids)
      .many()
      .help("Opaque solids that block the light, exactly, where no metric is linked.");
  d.in("basis", &In::basis).help("Functions extinction is projected on.");
  d.in("coefficients", &In::coefficients)
      .range(1, 32)
      .help("Basis functions kept per texel. The paper uses 8.");
  d.in("resolution", &In::resolution)
      .unit("texels")
      .range(0, 4096)
      .help("Texels along each edge of the map. 0: the metric's, or 1024 without one.");
  d.in("storage", &In::storage).help("Precision of the stored coefficients.");
  d.in("accumulation", &In::accumulation)
      .help("How the volumes of a texel are added up. A horizon of the metric needs gathering.");
  d.in("damping", &In::damping)
      .help(
          "Lanczos factors on the coefficients: fewer rings where transmittance should be level, but a "
          "larger error.");
  d.out("light", &Out::light).help("The lights with this shadow.");
}

/// What is wired beside a metric must be what the metric holds.
Result<void> checkAgainstMetric(const In& in) {
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

Result<void> begin(const In& in, EvalContext& ctx, PassQueue<shadow::ExtinctionPass>& queue) {
  if (in.resolution != 0 && in.resolution < 64)
    return fail(Code::Input, "resolution: {} is neither 0 nor within 64..4096", in.resolution);
  shadow::ExtinctionOptions options{in.basis,   in.coefficients, in.resolution,
                                    in.storage, in.accumulation, in.damping};
  shadow::ShadowSpec spec;
  if (!in.metric.items.empty()) {
    PILEUS_CHECK(checkAgainstMetric(in));
    for (const auto& metric : in.metric.items) {
      // In a draft the metric's own resolution is already the draft's.
      options.resolution =
          in.resolution == 0 ? metric->options.resolution : draftResolution(in.resolution, ctx);
      spec.metric = metric->options, spec.extinction = options;
      queue.passes.push_back(std::make_unique<shadow::ExtinctionPass>(options, metric));
      queue.passes.back()->remember(in.metric.solids, spec);
    }
    return {};
  }
  if (in.light.items.empty())
    return fail(Code::Input, "light: nothing is linked; link a metric, or a light and volumes");
  options.resolution = draftResolution(options.resolution == 0 ? 1024 : options.resolution, ctx);
  spec.metric.metric = shadow::Metric::None, spec.extinction = options;
  for (const LightWithShadow& l : in.light.items) {
    queue.passes.push_back(std::make_unique<shadow::ExtinctionPass>(
        options, l.light, in.volumes.items, shadow::fitLight(l.light, in.volumes.items, options.resolution)));
    queue.passes.back()->remember(in.solids.items, spec);
  }
  return {};
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  PILEUS_TRY(view::Renderer * renderer, gpuOf(ctx));
  auto& queue = ctx.state<PassQueue<shadow::ExtinctionPass>>();
  if (queue.passes.empty()) PILEUS_CHECK(begin(in, ctx, queue));
  double gpuMs = 0;
  PILEUS_TRY(const double fraction, queue.run(renderer->gpu(), ctx, gpuMs));
  Out out;
  std::size_t bytes = 0;
  for (const auto& pass : queue.passes) {
    const auto& map = pass->map();
    bytes += (map->block ? map->block->bytes() : 0) + (map->horizon ? map->horizon->bytes() : 0);
    out.light.items.push_back({pass->light(), map});
  }
  ctx.reportGpu(gpuMs, bytes);
  if (fraction < 1) ctx.pending(fraction, "Projecting extinction");
  return out;
}

}  // namespace

NodeType node_shadow_extinction() { return makeNode<In, Out>("shadow.extinction", 1, describe, evaluate); }

}  // namespace pileus::nodes
