// shadow.fourier_opacity: the classic series over the whole light ray.
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;

void describe(Describe<ShadowIn, ShadowOut>& d) {
  d.name("Fourier Opacity Map")
      .category("Shadow")
      .keywords("fom jansen bavoil shadow transmittance series baseline");
  d.help(
      "Projects extinction on a Fourier series over plain distance along each light ray (Jansen and Bavoil "
      "2010). Order-independent and cheap, but gaps between "
      "volumes use up the series: thin media ring. For comparison with the extinction map, which spends its "
      "coefficients inside media only.");
  d.uses(UsesQuality);
  describeCasters(d);
  d.in("coefficients", &ShadowIn::spec, &ShadowSpec::coefficients)
      .range(1, 31)
      .soft(3, 15)
      .help("Kept per texel: a0, a1, b1, a2, ... 3, 7, 11 and 15 fill one, two, three and four RGBA layers.");
  d.in("range", &ShadowIn::spec, &ShadowSpec::range)
      .label("Near-far range")
      .help(
          "Spans the series from the first to the last medium of each texel instead of the whole frustum. "
          "One layer and one pass more.");
  describeDamping(d, &ShadowIn::spec, &ShadowSpec::damping);
  describeResolution(d, &ShadowIn::spec, &ShadowSpec::resolution);
  d.in("storage", &ShadowIn::spec, &ShadowSpec::storage).help("Precision of the stored coefficients.");
  describeShadowed(d);
}

Result<ShadowOut> evaluate(const ShadowIn& in, EvalContext& ctx) {
  return shadowed(in, ctx, "Projecting extinction");
}

}  // namespace

NodeType node_shadow_fourier_opacity() {
  return makeNode<ShadowIn, ShadowOut>("shadow.fourier_opacity", 1, describe, evaluate,
                                       ofKind(ShadowSpec::Kind::FourierOpacity));
}

}  // namespace pileus::nodes
