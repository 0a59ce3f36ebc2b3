#pragma once
// The sky of the Earth and the sun seen through it, as lights. Linear ACEScg, 6500 K is white. Any thread.

#include "renderer/scene/atmosphere.h"
#include "renderer/scene/environment.h"

namespace pileus::scene {

struct Sky {
  double elevation = 40;   ///< of the sun's middle, degrees; -90 .. 90. Without refraction
  double irradiance = 10;  ///< luminance of the sun's irradiance above the air [W/m^2]; the sky in proportion
  double height = 1000;    ///< where it is seen [m above the sea]; 0 .. kAirTop

  bool operator==(const Sky&) const = default;
};

/// Radiance of sky and ground, without the sun's disc. The sun stands over the middle of the map: turn it by
/// the sun's azimuth. Twice as fast as it could be, for it is the same on both sides.
EnvironmentMap skyMap(const Atmosphere& atmosphere, const Sky& sky, ivec2 size = {256, 128},
                      Atmosphere::Orders orders = Atmosphere::Orders::All);

/// Of the whole sun above the air [W/m^2].
dvec3 sunAbove(double irradiance);
/// What of that arrives at a height [m above the sea], by colour; the sun's middle at `elevation` degrees.
/// The Earth covers its disc evenly. Smooth; 0 once it has set.
dvec3 sunTransmittance(const Air& air, double height, double elevation);
}  // namespace pileus::scene
