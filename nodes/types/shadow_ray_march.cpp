// shadow.ray_march: brute force, the comparison.
#include "nodes/types/shadow_common.h"
#include "renderer/shadow/shadow_pass.h"

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;

void describe(Describe<ShadowIn, ShadowOut>& d) {
  d.name("Ray-Marched Shadow").category("Shadow").keywords("brute force reference truth march");
  d.help(
      "Marches from every lit point through the media to the light: no map and no approximation beyond the "
      "step, but the cost of a "
      "second march at every step of the first. The truth the maps are compared with.");
  describeCasters(d, "The lights to shadow.", "Opaque solids that block the light.");
  d.in("step_scale", &ShadowIn::spec, &ShadowSpec::stepScale)
      .unit("voxels")
      .range(0.05, 16)
      .soft(0.25, 4)
      .logarithmic()
      .help(
          "Step of the march in voxels. 0.5 is converged: halving it again changes transmittance by less "
          "than 0.2 %.");
  describeShadowed(d);
}

Result<ShadowOut> evaluate(const ShadowIn& in, EvalContext&) {
  PILEUS_TRY(const std::vector<scene::Light> lights, lightsOf(in.light));
  ShadowOut out;
  for (const scene::Light& light : lights)
    out.light.items.push_back(
        {light, shadow::marchedShadow(light, in.volumes.items, in.solids.items, in.spec.stepScale)});
  return out;
}

}  // namespace

NodeType node_shadow_ray_march() {
  return makeNode<ShadowIn, ShadowOut>("shadow.ray_march", 1, describe, evaluate,
                                       ofKind(ShadowSpec::Kind::RayMarch));
}

}  // namespace pileus::nodes
