// light.point: a small light that shines evenly in all directions.
#include "nodes/types/light_common.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 position{0, 2, 0};
  double intensity = 100;
  Color color{vec3(1.0f)};
  bool use_temperature = false;
  double temperature = 6500;
  double radius = 0.01;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Point Light").category("Light").keywords("lamp bulb omni local flash lightning");
  d.help(
      "A light at one place that shines evenly in all directions; it may stand inside a volume. Irradiance "
      "falls "
      "with the square of the distance.");
  d.in("position", &In::position).unit("m").range(-1e7, 1e7).soft(-20, 20).help("Where it stands.");
  d.in("intensity", &In::intensity)
      .unit("W/sr")
      .range(0, 1e12)
      .soft(0, 1000)
      .help("Radiant intensity before the colour: at distance r the irradiance is intensity / r^2.");
  describeLightColor(d, "intensity");
  d.in("radius", &In::radius)
      .unit("m")
      .range(1e-4, 1e6)
      .soft(0.001, 1)
      .logarithmic()
      .help("Closer than this the irradiance grows no further. Shadows stay those of a point.");
  d.out("light", &Out::light).help("One light without a shadow.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  scene::Light light;
  light.kind = scene::LightKind::Point;
  light.position = in.position;
  light.emitted = lightColor(in) * static_cast<float>(in.intensity);
  light.radius = in.radius;
  return Out{{{{light, nullptr}}}};
}

}  // namespace

NodeType node_light_point() { return makeNode<In, Out>("light.point", 1, describe, evaluate); }

}  // namespace pileus::nodes
