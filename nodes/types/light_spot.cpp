// light.spot: a cone of light.
#include "nodes/types/light_common.h"

namespace pileus::nodes {
namespace {

struct In {
  LocalLight local{.position = {0, 5, 0}};
  dvec3 target{0};
  double cone = 60;
  double softness = 0.2;
};

void describe(Describe<In, LocalLightOut>& d) {
  d.name("Spot Light").category("Light").keywords("cone beam stage lamp headlight projector local");
  d.help(
      "A light at one place that shines into a cone about the line to its target. Irradiance falls with the "
      "square "
      "of the distance.");
  describePosition(d);
  d.in("target", &In::target)
      .unit("m")
      .range(-1e7, 1e7)
      .soft(-20, 20)
      .help("What the middle of the cone meets.");
  describeIntensity(d,
                    "Radiant intensity along the axis, before the colour; it does not depend on the cone.");
  d.in("cone", &In::cone)
      .unit("deg")
      .range(0.1, 170)
      .soft(1, 120)
      .help("Full angle of the cone: nothing is lit outside it.");
  d.in("softness", &In::softness)
      .range(0, 1)
      .help("Part of the half angle over which the light fades out at the edge; 0 is a hard edge.");
  describeRadius(d);
}

Result<LocalLightOut> evaluate(const In& in, EvalContext&) {
  const dvec3 back = in.local.position - in.target;
  if (glm::length(back) < 1e-9) return fail(Code::Input, "target: is where the light is; move one of them");
  scene::Light light = in.local.made(scene::LightKind::Spot);
  light.towards = glm::normalize(back);
  light.cone = in.cone;
  light.softness = in.softness;
  return LocalLightOut{{{{light, nullptr}}}};
}

}  // namespace

NodeType node_light_spot() { return makeNode<In, LocalLightOut>("light.spot", 1, describe, evaluate); }

}  // namespace pileus::nodes
