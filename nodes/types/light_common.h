#pragma once
// What the light nodes share: colour, and the place of those that stand somewhere.
#include "nodes/declare/describe.h"

namespace pileus::nodes {

/// A colour, and that of a black body it may be multiplied by.
struct LightColor {
  Color color{vec3(1.0f)};
  bool useTemperature = false;
  double temperature = 6500;
  vec3 rgb() const { return useTemperature ? color.rgb * scene::temperatureColor(temperature) : color.rgb; }
};

/// `path` leads from In to the LightColor.
template <class In, class Out, class... Path>
void describeLightColor(Describe<In, Out>& d, const std::string& multiplied, Path... path) {
  d.in("color", path..., &LightColor::color)
      .range(0, 1e6)
      .soft(0, 1)
      .help("Multiplies the " + multiplied + "; linear, in the working space.");
  d.in("use_temperature", path..., &LightColor::useTemperature)
      .help("Multiplies the colour by that of a black body.");
  d.in("temperature", path..., &LightColor::temperature)
      .unit("K")
      .range(1667, 25000)
      .soft(2000, 12000)
      .help("Of the black body; 6500 is the working space's white. Only with 'Use temperature'.");
}

/// A light at one place: `In::local` of light.point and light.spot.
struct LocalLight {
  dvec3 position{0};
  double intensity = 100;
  LightColor color = {};
  double radius = 0;
  std::string group = {};

  scene::Light made(scene::LightKind kind) const {
    scene::Light light;
    light.kind = kind;
    light.position = position;
    light.emitted = color.rgb() * static_cast<float>(intensity);
    light.radius = radius;
    return light;
  }
};

/// What is given by both of them.
struct LocalLightOut {
  LightValue light;
};

template <class In>
void describePosition(Describe<In, LocalLightOut>& d) {
  d.in("position", &In::local, &LocalLight::position)
      .unit("m")
      .range(-1e7, 1e7)
      .soft(-20, 20)
      .help("Where it stands.");
}

template <class In>
void describeIntensity(Describe<In, LocalLightOut>& d, std::string help) {
  d.in("intensity", &In::local, &LocalLight::intensity)
      .unit("W/sr")
      .range(0, 1e12)
      .soft(0, 1000)
      .help(std::move(help));
  describeLightColor(d, "intensity", &In::local, &LocalLight::color);
}

template <class In>
void describeRadius(Describe<In, LocalLightOut>& d) {
  d.in("radius", &In::local, &LocalLight::radius)
      .unit("m")
      .range(0, 1e6)
      .soft(0, 1)
      .logarithmic()
      .help(
          "Closer than this the irradiance grows no further; 0: a true point. Shadows stay those of a "
          "point.");
  d.in("group", &In::local, &LocalLight::group)
      .forEditor()
      .help("Lights of one group are balanced together in the light mixer. Empty: it stands for itself.");
  d.out("light", &LocalLightOut::light).help("One light without a shadow.");
}

}  // namespace pileus::nodes
