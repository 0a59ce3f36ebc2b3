// shadow.deep: compressed piecewise-linear transmittance.
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;

void describe(Describe<ShadowIn, ShadowOut>& d) {
  d.name("Deep Shadow Map")
      .category("Shadow")
      .keywords("dsm lokovic veach deep visibility compressed piecewise linear baseline");
  d.help(
      "Keeps the transmittance of each light ray as a piecewise-linear function, compressed so that it never "
      "errs by more than a bound (Lokovic and Veach 2000). Its memory "
      "depends on the scene; it is built in two ordered marches and read by a binary search in four texels.");
  d.uses(UsesQuality);
  describeCasters(d);
  d.in("error_bound", &ShadowIn::spec, &ShadowSpec::errorBound)
      .range(0, 0.5)
      .soft(0.001, 0.1)
      .logarithmic()
      .help("Largest error of transmittance the compression may make. 0 keeps every step of the march.");
  d.in("node_budget", &ShadowIn::spec, &ShadowSpec::nodeBudget)
      .unit("vertices")
      .range(2, 4096)
      .soft(8, 256)
      .logarithmic()
      .help("Vertices a texel may keep; one that needs more gets a larger bound, and the node says so.");
  d.in("filter", &ShadowIn::spec, &ShadowSpec::filter)
      .unit("rays")
      .range(1, 4)
      .help(
          "Light rays along each edge of a texel that are averaged before compression: 2 means 4 rays. "
          "Prefiltered maps do not alias.");
  describeResolution(d, &ShadowIn::spec, &ShadowSpec::resolution);
  describeShadowed(d);
}

Result<ShadowOut> evaluate(const ShadowIn& in, EvalContext& ctx) {
  return shadowed(in, ctx, "Compressing transmittance");
}

}  // namespace

NodeType node_shadow_deep() {
  return makeNode<ShadowIn, ShadowOut>("shadow.deep", 1, describe, evaluate, ofKind(ShadowSpec::Kind::Deep));
}

}  // namespace pileus::nodes
