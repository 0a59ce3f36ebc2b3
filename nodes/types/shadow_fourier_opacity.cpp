// shadow.fourier_opacity: the classic series over the whole light ray.
#include "nodes/declare/describe.h"
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  int coefficients = 7;
  bool range = false;
  bool damping = false;
  int resolution = 1024;
  shadow::Storage storage = shadow::Storage::Half;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Fourier Opacity Map")
      .category("Shadow")
      .keywords("fom jansen bavoil shadow transmittance series baseline");
  d.help(
      "Projects extinction on a Fourier series over plain distance along each light ray (Jansen and Bavoil "
      "2010). Order-independent and cheap, but gaps between "
      "volumes use up the series: thin media ring. For comparison with the extinction map, which spends its "
      "coefficients inside media only.");
  d.uses(UsesQuality);
  d.in("volumes", &In::volumes).many().help("The media that cast shadows.");
  d.in("light", &In::light).required().help("The lights to shadow; each gets a map of its own.");
  d.in("solids", &In::solids).many().help("Opaque solids that block the light, exactly.");
  d.in("coefficients", &In::coefficients)
      .range(1, 31)
      .soft(3, 15)
      .help("Kept per texel: a0, a1, b1, a2, ... 3, 7, 11 and 15 fill one, two, three and four RGBA layers.");
  d.in("range", &In::range)
      .label("Near-far range")
      .help(
          "Spans the series from the first to the last medium of each texel instead of the whole frustum. "
          "One layer and one pass more.");
  d.in("damping", &In::damping)
      .help(
          "Lanczos factors on the coefficients: fewer rings where transmittance should be level, but a "
          "larger error.");
  d.in("resolution", &In::resolution)
      .unit("texels")
      .range(64, 4096)
      .logarithmic()
      .help("Texels along each edge of the map.");
  d.in("storage", &In::storage).help("Precision of the stored coefficients.");
  d.out("light", &Out::light).help("The lights with this shadow.");
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  shadow::ShadowSpec spec;
  spec.kind = shadow::ShadowSpec::Kind::FourierOpacity;
  spec.coefficients = in.coefficients;
  spec.range = in.range;
  spec.damping = in.damping;
  spec.resolution = in.resolution;
  spec.storage = in.storage;
  PILEUS_TRY(LightValue light,
             shadowLights(spec, in.light, in.volumes, in.solids, ctx, "Projecting extinction"));
  return Out{std::move(light)};
}

}  // namespace

NodeType node_shadow_fourier_opacity() {
  return makeNode<In, Out>("shadow.fourier_opacity", 1, describe, evaluate);
}

}  // namespace pileus::nodes
