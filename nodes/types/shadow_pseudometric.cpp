// shadow.pseudometric: how far each light ray is through the media.
#include "nodes/declare/describe.h"
#include "nodes/types/shadow_common.h"
#include "renderer/shadow/pseudometric_map.h"
#include "renderer/view/renderer.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  shadow::Metric representation = shadow::Metric::Interval;
  shadow::Coverage coverage = shadow::Coverage::Bricks;
  int intervals = 4;
  int coefficients = 4;
  int resolution = 1024;
  shadow::Storage storage = shadow::Storage::Float;
  shadow::Weighting weighting = shadow::Weighting::Root;
  double horizon = shadow::kUsualHorizon;
  bool compact = false;
};

struct Out {
  MetricValue metric;
};

void describe(Describe<In, Out>& d) {
  d.name("Pseudometric Map").category("Shadow").keywords("metric distance interval coverage gautron vaem");
  d.help(
      "Measures distance along each light ray only where media are, so that an extinction map spends its "
      "coefficients inside them "
      "and every gap costs nothing (Gautron et al. 2011, pass 1).");
  d.uses(UsesQuality);
  d.in("volumes", &In::volumes).many().help("The media that cast shadows.");
  d.in("light", &In::light).required().help("The lights the maps look from; each gets a map of its own.");
  d.in("solids", &In::solids).many().help("Opaque solids that block the light, exactly.");
  d.in("representation", &In::representation).help("How the coverage along a ray is stored.");
  d.in("intervals", &In::intervals)
      .range(1, 8)
      .help(
          "Interval only: merged [enter, exit] pairs kept per texel. Exact while a ray crosses no more media "
          "than this.");
  d.in("coverage", &In::coverage)
      .help("Interval only: what of a voxel grid counts as medium. Boxes and spheres are always exact.");
  d.in("coefficients", &In::coefficients)
      .range(2, 16)
      .help("Fourier and cosine only: series coefficients kept per texel. The paper uses 4.");
  d.in("resolution", &In::resolution)
      .unit("texels")
      .range(64, 4096)
      .logarithmic()
      .help("Texels along each edge of the map.");
  d.in("storage", &In::storage).help("Precision of the stored values.");
  d.in("weighting", &In::weighting)
      .help("Interval only: how much of the metric an interval gets for its length.");
  d.in("horizon", &In::horizon)
      .unit("optical depth")
      .range(0, 1e4)
      .soft(0, 20)
      .help(
          "Interval only: behind this optical depth nothing is resolved, so that a dense cloud's lit side "
          "gets all the coefficients; the total behind it is kept. 0: no horizon.");
  d.in("compact", &In::compact)
      .label("8-bit ends")
      .help(
          "Interval only: keeps interval ends in 8 bits, rounded outwards: a quarter or half of their "
          "memory, best spent on more coefficients. Too coarse where media are thinner than about a "
          "hundredth of the light's depth.");
  d.out("metric", &Out::metric).help("The map with its frustum, light and volumes: for Extinction Map.");
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  PILEUS_TRY(const std::vector<scene::Light> lights, lightsOf(in.light));
  PILEUS_TRY(view::Renderer * renderer, gpuOf(ctx));
  auto& queue = ctx.state<PassQueue<shadow::PseudometricPass>>();
  if (queue.passes.empty()) {
    shadow::MetricOptions options{in.representation, in.intervals,
                                  in.coefficients,   draftResolution(in.resolution, ctx),
                                  in.storage,        in.coverage};
    if (in.representation == shadow::Metric::Interval)
      options.weighting = in.weighting, options.horizon = in.horizon, options.compact = in.compact;
    for (const scene::Light& light : lights)
      queue.passes.push_back(std::make_unique<shadow::PseudometricPass>(
          options, light, in.volumes.items, shadow::fitLight(light, in.volumes.items, options.resolution)));
  }
  double gpuMs = 0;
  PILEUS_TRY(const double fraction, queue.run(renderer->gpu(), ctx, gpuMs));
  Out out;
  std::size_t bytes = 0;
  for (const auto& pass : queue.passes) {
    bytes += pass->map()->bytes();
    out.metric.items.push_back(pass->map());
  }
  out.metric.solids = in.solids.items;
  ctx.reportGpu(gpuMs, bytes);
  if (fraction < 1) ctx.pending(fraction, "Measuring media");
  return out;
}

}  // namespace

NodeType node_shadow_pseudometric() {
  return makeNode<In, Out>("shadow.pseudometric", 1, describe, evaluate);
}

}  // namespace pileus::nodes
