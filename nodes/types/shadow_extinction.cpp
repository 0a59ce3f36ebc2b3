// shadow.extinction: extinction along each light ray, projected on a small basis.
#include "nodes/describe.h"
#include "nodes/shadow_common.h"
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
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Extinction Map").category("Shadow").keywords("shadow transmittance coefficients fourier cosine opacity vaem gautron");
  d.help("Projects optical depth along each light ray, as a function of the pseudometric, into a small basis; its integral gives the "
         "transmittance at any point of the ray. Order-independent and rebuilt whenever anything changes. Without a metric the map is "
         "Euclidean: plain distance along the ray.");
  d.uses(UsesQuality);
  d.in("metric", &In::metric).help("A pseudometric map; brings its light, volumes and frustum with it.");
  d.in("volumes", &In::volumes).many().help("The media that cast shadows, where no metric is linked.");
  d.in("light", &In::light).help("The light, where no metric is linked.");
  d.in("solids", &In::solids).many().help("Opaque solids that cut the light rays off, where no metric is linked.");
  d.in("basis", &In::basis).help("Functions extinction is projected on.");
  d.in("coefficients", &In::coefficients).range(1, 32).help("Basis functions kept per texel. The paper uses 8.");
  d.in("resolution", &In::resolution).unit("texels").range(0, 4096).help("Texels along each edge of the map. 0: the metric's, or 1024 without one.");
  d.in("storage", &In::storage).help("Precision of the stored coefficients.");
  d.out("light", &Out::light).help("The light with this shadow.");
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  PILEUS_TRY(view::Renderer * renderer, gpuOf(ctx));
  auto& pass = ctx.state<std::unique_ptr<shadow::ExtinctionPass>>();
  if (!pass) {
    if (in.resolution != 0 && in.resolution < 64) return fail(Code::Input, "resolution: {} is neither 0 nor within 64..4096", in.resolution);
    shadow::ExtinctionOptions options{in.basis, in.coefficients, in.resolution, in.storage};
    if (const auto& metric = in.metric.map) {
      if (!in.volumes.items.empty() && volume::contentKey(residency::canonical(in.volumes.items)) != volume::contentKey(metric->volumes))
        return fail(Code::Input, "volumes: differ from the metric's; link the same volumes or none");
      if (!in.light.items.empty() && (in.light.items.size() != 1 || !(in.light.items.front().light == metric->light)))
        return fail(Code::Input, "light: differs from the metric's; link the same light or none");
      // In a draft the metric's own resolution is already the draft's.
      options.resolution = options.resolution == 0 ? metric->options.resolution : draftResolution(options.resolution, ctx);
      pass = std::make_unique<shadow::ExtinctionPass>(options, metric);
    } else {
      if (in.light.items.empty()) return fail(Code::Input, "light: nothing is linked; link a metric, or a light and volumes");
      PILEUS_TRY(const scene::Light light, singleLight(in.light));
      options.resolution = draftResolution(options.resolution == 0 ? 1024 : options.resolution, ctx);
      pass = std::make_unique<shadow::ExtinctionPass>(options, light, in.volumes.items, shadow::fitLight(light, in.volumes.items, options.resolution));
    }
  }
  PILEUS_TRY(const double fraction, pass->step(renderer->gpu(), ctx.msLeft()));
  ctx.reportGpu(pass->takeGpuMs(), pass->map()->block ? pass->map()->block->bytes() : 0);
  if (fraction < 1) ctx.pending(fraction, "Projecting extinction");
  return Out{{{{pass->light(), pass->map()}}}};
}

}  // namespace

NodeType node_shadow_extinction() { return makeNode<In, Out>("shadow.extinction", 1, describe, evaluate); }

}  // namespace pileus::nodes
