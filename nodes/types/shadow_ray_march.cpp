// shadow.ray_march: brute force, the comparison.
#include "nodes/declare/describe.h"
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  double step_scale = 0.5;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Ray-Marched Shadow").category("Shadow").keywords("brute force reference truth march");
  d.help(
      "Marches from every lit point through the media to the light: no map and no approximation beyond the "
      "step, but the cost of a "
      "second march at every step of the first. The truth the maps are compared with.");
  d.in("volumes", &In::volumes).many().help("The media that cast shadows.");
  d.in("light", &In::light).required().help("The lights to shadow.");
  d.in("solids", &In::solids).many().help("Opaque solids that block the light.");
  d.in("step_scale", &In::step_scale)
      .unit("voxels")
      .range(0.05, 16)
      .soft(0.25, 4)
      .logarithmic()
      .help(
          "Step of the march in voxels. 0.5 is converged: halving it again changes transmittance by less "
          "than 0.2 %.");
  d.out("light", &Out::light).help("The lights with this shadow.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  PILEUS_TRY(const std::vector<scene::Light> lights, lightsOf(in.light));
  Out out;
  for (const scene::Light& light : lights)
    out.light.items.push_back(
        {light, shadow::marchedShadow(light, in.volumes.items, in.solids.items, in.step_scale)});
  return out;
}

}  // namespace

NodeType node_shadow_ray_march() { return makeNode<In, Out>("shadow.ray_march", 1, describe, evaluate); }

}  // namespace pileus::nodes
