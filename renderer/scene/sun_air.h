#pragma once
// What the air lets through of a sun, by the height of whatever it lights. Immutable; any thread.
#include <vector>

#include "renderer/scene/air.h"

namespace pileus::scene {

/// Heights rise with the square of their index, from the sea to the top of the air: there the Earth's shadow
/// goes up evenly as the sun sinks.
inline constexpr int kSunHeights = 512;

struct SunAir {
  double altitude = 0;       ///< of the scene's height 0 [m above the sea]
  std::vector<vec3> passes;  ///< transmittance by colour at kSunHeights heights, 0 .. 1; the Earth covers the
                             ///< sun where it has set

  bool operator==(const SunAir&) const = default;
};

/// Of a sun whose middle stands at `elevation` degrees, everywhere: the scene is small beside the Earth.
SunAir sunAir(const Air& air, double elevation, double altitude);

/// At a height of the scene, between the entries. Twin of airPasses in lib/light_transmittance.glsl.
vec3 sunThrough(const SunAir& air, double height);

/// Can it be seen from anywhere in the air?
bool sunIsUp(const SunAir& air);

}  // namespace pileus::scene
