// shadow.transmittance_function: transmittance itself as a series.
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;

void describe(Describe<ShadowIn, ShadowOut>& d) {
  d.name("Transmittance Function Map")
      .category("Shadow")
      .keywords("tfm delalandre shadow transmittance series ordered baseline");
  d.help(
      "Marches each light ray in order and projects the transmittance itself on a series over plain distance "
      "(Delalandre et al. 2011). Read without an exponential, "
      "but volumes cannot be added one by one, and steep drops ring.");
  d.uses(UsesQuality);
  describeCasters(d);
  d.in("basis", &ShadowIn::spec, &ShadowSpec::basis)
      .choices({{"fourier", "Fourier", "As published: periodic, so it rings at both ends of the ray."},
                {"cosine", "Cosine", "No jump at the ends: the same memory with less ringing."}})
      .help("Functions transmittance is projected on.");
  d.in("coefficients", &ShadowIn::spec, &ShadowSpec::coefficients)
      .range(1, 31)
      .soft(3, 15)
      .help("Kept per texel.");
  describeResolution(d, &ShadowIn::spec, &ShadowSpec::resolution);
  d.in("storage", &ShadowIn::spec, &ShadowSpec::storage).help("Precision of the stored coefficients.");
  describeShadowed(d);
}

Result<ShadowOut> evaluate(const ShadowIn& in, EvalContext& ctx) {
  return shadowed(in, ctx, "Projecting transmittance");
}

}  // namespace

NodeType node_shadow_transmittance_function() {
  return makeNode<ShadowIn, ShadowOut>("shadow.transmittance_function", 1, describe, evaluate,
                                       ofKind(ShadowSpec::Kind::TransmittanceFunction));
}

}  // namespace pileus::nodes
