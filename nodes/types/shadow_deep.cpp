// shadow.deep: compressed piecewise-linear transmittance.
#include "nodes/declare/describe.h"
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  double error_bound = 0.01;
  int node_budget = 64;
  int filter = 1;
  int resolution = 1024;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Deep Shadow Map")
      .category("Shadow")
      .keywords("dsm lokovic veach deep visibility compressed piecewise linear baseline");
  d.help(
      "Keeps the transmittance of each light ray as a piecewise-linear function, compressed so that it never "
      "errs by more than a bound (Lokovic and Veach 2000). Its memory "
      "depends on the scene; it is built in two ordered marches and read by a binary search in four texels.");
  d.uses(UsesQuality);
  d.in("volumes", &In::volumes).many().help("The media that cast shadows.");
  d.in("light", &In::light).required().help("The lights to shadow; each gets a map of its own.");
  d.in("solids", &In::solids).many().help("Opaque solids that block the light, exactly.");
  d.in("error_bound", &In::error_bound)
      .range(0, 0.5)
      .soft(0.001, 0.1)
      .logarithmic()
      .help("Largest error of transmittance the compression may make. 0 keeps every step of the march.");
  d.in("node_budget", &In::node_budget)
      .unit("vertices")
      .range(2, 4096)
      .soft(8, 256)
      .logarithmic()
      .help("Vertices a texel may keep; one that needs more gets a larger bound, and the node says so.");
  d.in("filter", &In::filter)
      .unit("rays")
      .range(1, 4)
      .help(
          "Light rays along each edge of a texel that are averaged before compression: 2 means 4 rays. "
          "Prefiltered maps do not alias.");
  d.in("resolution", &In::resolution)
      .unit("texels")
      .range(64, 4096)
      .logarithmic()
      .help("Texels along each edge of the map.");
  d.out("light", &Out::light).help("The lights with this shadow.");
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  shadow::ShadowSpec spec;
  spec.kind = shadow::ShadowSpec::Kind::Deep;
  spec.errorBound = in.error_bound;
  spec.nodeBudget = in.node_budget;
  spec.filter = in.filter;
  spec.resolution = in.resolution;
  PILEUS_TRY(LightValue light,
             shadowLights(spec, in.light, in.volumes, in.solids, ctx, "Compressing transmittance"));
  return Out{std::move(light)};
}

}  // namespace

NodeType node_shadow_deep() { return makeNode<In, Out>("shadow.deep", 1, describe, evaluate); }

}  // namespace pileus::nodes
