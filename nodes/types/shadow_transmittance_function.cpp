// shadow.transmittance_function: transmittance itself as a series.
#include "nodes/declare/describe.h"
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

enum class SeriesBasis { Fourier, Cosine };
constexpr auto enumInfo(SeriesBasis*) {
  using B = SeriesBasis;
  return std::array{
      EnumItem<B>{B::Fourier, "fourier", "Fourier",
                  "As published: periodic, so it rings at both ends of the ray."},
      EnumItem<B>{B::Cosine, "cosine", "Cosine", "No jump at the ends: the same memory with less ringing."}};
}

struct In {
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  SeriesBasis basis = SeriesBasis::Fourier;
  int coefficients = 7;
  int resolution = 1024;
  shadow::Storage storage = shadow::Storage::Half;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Transmittance Function Map")
      .category("Shadow")
      .keywords("tfm delalandre shadow transmittance series ordered baseline");
  d.help(
      "Marches each light ray in order and projects the transmittance itself on a series over plain distance "
      "(Delalandre et al. 2011). Read without an exponential, "
      "but volumes cannot be added one by one, and steep drops ring.");
  d.uses(UsesQuality);
  d.in("volumes", &In::volumes).many().help("The media that cast shadows.");
  d.in("light", &In::light).required().help("The lights to shadow; each gets a map of its own.");
  d.in("solids", &In::solids).many().help("Opaque solids that block the light, exactly.");
  d.in("basis", &In::basis).help("Functions transmittance is projected on.");
  d.in("coefficients", &In::coefficients).range(1, 31).soft(3, 15).help("Kept per texel.");
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
  spec.kind = shadow::ShadowSpec::Kind::TransmittanceFunction;
  spec.basis = in.basis == SeriesBasis::Cosine ? shadow::Basis::Cosine : shadow::Basis::Fourier;
  spec.coefficients = in.coefficients;
  spec.resolution = in.resolution;
  spec.storage = in.storage;
  PILEUS_TRY(LightValue light,
             shadowLights(spec, in.light, in.volumes, in.solids, ctx, "Projecting transmittance"));
  return Out{std::move(light)};
}

}  // namespace

NodeType node_shadow_transmittance_function() {
  return makeNode<In, Out>("shadow.transmittance_function", 1, describe, evaluate);
}

}  // namespace pileus::nodes
