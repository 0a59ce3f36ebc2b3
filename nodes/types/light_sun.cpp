// light.sun: a distant light.
#include "nodes/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  double azimuth = 30;
  double elevation = 40;
  double irradiance = 10;
  Color color{vec3(1.0f)};
  bool use_temperature = false;
  double temperature = 6500;
  double angle = 0;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Sun").category("Light").keywords("directional distant day key");
  d.help("A light so far away that its rays are parallel. Azimuth and elevation point towards it.");
  d.in("azimuth", &In::azimuth).unit("deg").range(-36000, 36000).soft(-180, 180).help("From +Z towards +X.");
  d.in("elevation", &In::elevation).unit("deg").range(-90, 90).help("Above the horizon; 90 is straight up.");
  d.in("irradiance", &In::irradiance)
      .unit("W/m^2")
      .range(0, 1e9)
      .soft(0, 50)
      .help("At normal incidence, before the colour.");
  d.in("color", &In::color)
      .range(0, 1e6)
      .soft(0, 1)
      .help("Multiplies the irradiance; linear, in the working space.");
  d.in("use_temperature", &In::use_temperature).help("Multiplies the colour by that of a black body.");
  d.in("temperature", &In::temperature)
      .unit("K")
      .range(1667, 25000)
      .soft(2000, 12000)
      .help("Of the black body; 6500 is the working space's white. Only with 'Use temperature'.");
  d.in("angle", &In::angle)
      .unit("deg")
      .range(0, 90)
      .soft(0, 5)
      .help("The disc's diameter; the real sun's is 0.53.");
  d.out("light", &Out::light).help("One light without a shadow.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  vec3 color = in.color.rgb;
  if (in.use_temperature) color *= scene::temperatureColor(in.temperature);
  LightWithShadow sun;
  sun.light.kind = scene::LightKind::Sun;
  sun.light.towards = scene::sunDirection(in.azimuth, in.elevation);
  sun.light.emitted = color * static_cast<float>(in.irradiance);
  sun.light.angle = in.angle;
  Out out;
  out.light.items.push_back(std::move(sun));
  return out;
}

}  // namespace

NodeType node_light_sun() { return makeNode<In, Out>("light.sun", 1, describe, evaluate); }

}  // namespace pileus::nodes
