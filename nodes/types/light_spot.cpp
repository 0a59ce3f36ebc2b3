// light.spot: a cone of light.
#include "nodes/types/light_common.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 position{0, 5, 0};
  dvec3 target{0};
  double intensity = 100;
  Color color{vec3(1.0f)};
  bool use_temperature = false;
  double temperature = 6500;
  double cone = 60;
  double softness = 0.2;
  double radius = 0.01;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Spot Light").category("Light").keywords("cone beam stage lamp headlight projector local");
  d.help(
      "A light at one place that shines into a cone about the line to its target. Irradiance falls with the "
      "square "
      "of the distance.");
  d.in("position", &In::position).unit("m").range(-1e7, 1e7).soft(-20, 20).help("Where it stands.");
  d.in("target", &In::target)
      .unit("m")
      .range(-1e7, 1e7)
      .soft(-20, 20)
      .help("What the middle of the cone meets.");
  d.in("intensity", &In::intensity)
      .unit("W/sr")
      .range(0, 1e12)
      .soft(0, 1000)
      .help("Radiant intensity along the axis, before the colour; it does not depend on the cone.");
  describeLightColor(d, "intensity");
  d.in("cone", &In::cone)
      .unit("deg")
      .range(0.1, 170)
      .soft(1, 120)
      .help("Full angle of the cone: nothing is lit outside it.");
  d.in("softness", &In::softness)
      .range(0, 1)
      .help("Part of the half angle over which the light fades out at the edge; 0 is a hard edge.");
  d.in("radius", &In::radius)
      .unit("m")
      .range(1e-4, 1e6)
      .soft(0.001, 1)
      .logarithmic()
      .help("Closer than this the irradiance grows no further. Shadows stay those of a point.");
  d.out("light", &Out::light).help("One light without a shadow.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  const dvec3 back = in.position - in.target;
  if (glm::length(back) < 1e-9) return fail(Code::Input, "target: is where the light is; move one of them");
  scene::Light light;
  light.kind = scene::LightKind::Spot;
  light.position = in.position;
  light.towards = glm::normalize(back);
  light.emitted = lightColor(in) * static_cast<float>(in.intensity);
  light.cone = in.cone;
  light.softness = in.softness;
  light.radius = in.radius;
  return Out{{{{light, nullptr}}}};
}

}  // namespace

NodeType node_light_spot() { return makeNode<In, Out>("light.spot", 1, describe, evaluate); }

}  // namespace pileus::nodes
