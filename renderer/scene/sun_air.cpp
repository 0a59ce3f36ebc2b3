#include "renderer/scene/sun_air.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "renderer/scene/sky.h"

namespace pileus::scene {

SunAir sunAir(const Air& air, double elevation, double altitude) {
  SunAir out{altitude, std::vector<vec3>(kSunHeights)};
  tbb::parallel_for(0, kSunHeights, [&](int i) {
    const double t = double(i) / (kSunHeights - 1);
    out.passes[std::size_t(i)] = vec3(sunTransmittance(air, kAirTop * t * t, elevation));
  });
  return out;
}

vec3 sunThrough(const SunAir& air, double height) {
  const double above = std::clamp((height + air.altitude) / kAirTop, 0.0, 1.0);
  const double at = std::sqrt(above) * (kSunHeights - 1);
  const int i = std::min(int(at), kSunHeights - 2);
  return glm::mix(air.passes[std::size_t(i)], air.passes[std::size_t(i) + 1], float(at - i));
}

bool sunIsUp(const SunAir& air) {
  return std::any_of(air.passes.begin(), air.passes.end(),
                     [](const vec3& t) { return t.r > 0 || t.g > 0 || t.b > 0; });
}

}  // namespace pileus::scene
