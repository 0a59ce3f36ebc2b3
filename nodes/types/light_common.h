#pragma once
// What the light nodes share: their colour. For `In` with color, use_temperature and temperature.
#include "nodes/declare/describe.h"

namespace pileus::nodes {

template <class In, class Out>
void describeLightColor(Describe<In, Out>& d, const std::string& multiplied) {
  d.in("color", &In::color)
      .range(0, 1e6)
      .soft(0, 1)
      .help("Multiplies the " + multiplied + "; linear, in the working space.");
  d.in("use_temperature", &In::use_temperature).help("Multiplies the colour by that of a black body.");
  d.in("temperature", &In::temperature)
      .unit("K")
      .range(1667, 25000)
      .soft(2000, 12000)
      .help("Of the black body; 6500 is the working space's white. Only with 'Use temperature'.");
}

template <class In>
vec3 lightColor(const In& in) {
  return in.use_temperature ? in.color.rgb * scene::temperatureColor(in.temperature) : in.color.rgb;
}

}  // namespace pileus::nodes
