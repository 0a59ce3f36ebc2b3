// light.sun: a distant light.
#include "nodes/types/light_common.h"

namespace pileus::nodes {
namespace {

struct In {
  double azimuth = 30;
  double elevation = 40;
  double irradiance = 10;
  LightColor color;
  double angle = 0;
  int disc_samples = 8;
  std::string group;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Sun").category("Light").keywords("directional distant day key soft");
  d.help("A light so far away that its rays are parallel. Azimuth and elevation point towards it.");
  d.in("azimuth", &In::azimuth).unit("deg").range(-36000, 36000).soft(-180, 180).help("From +Z towards +X.");
  d.in("elevation", &In::elevation).unit("deg").range(-90, 90).help("Above the horizon; 90 is straight up.");
  d.in("irradiance", &In::irradiance)
      .unit("W/m^2")
      .range(0, 1e9)
      .soft(0, 50)
      .help("At normal incidence, before the colour.");
  describeLightColor(d, "irradiance", &In::color);
  d.in("angle", &In::angle)
      .unit("deg")
      .range(0, 90)
      .soft(0, 5)
      .help("The disc's diameter; the real sun's is 0.53. Above 0 shadows have soft edges.");
  d.in("disc_samples", &In::disc_samples)
      .range(1, 32)
      .help(
          "Suns that stand for the disc where 'Angle' is above 0, each with a shadow of its own: steps of "
          "the "
          "penumbra.");
  d.in("group", &In::group)
      .forEditor()
      .help("Lights of one group are balanced together in the light mixer. Empty: it stands for itself.");
  d.out("light", &Out::light).help("One sun without a shadow, or as many as stand for its disc.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  scene::Light sun;
  sun.kind = scene::LightKind::Sun;
  sun.towards = scene::sunDirection(in.azimuth, in.elevation);
  sun.emitted = in.color.rgb() * static_cast<float>(in.irradiance);
  sun.angle = in.angle;
  Out out;
  for (const scene::Light& part : scene::splitDisc(sun, in.disc_samples))
    out.light.items.push_back({part, nullptr});
  return out;
}

}  // namespace

NodeType node_light_sun() { return makeNode<In, Out>("light.sun", 2, describe, evaluate); }

}  // namespace pileus::nodes
