#include "renderer/scene/light.h"

namespace pileus::scene {
namespace {

/// CIE xy of the Planckian locus.
dvec2 planckianXy(double k) {
  const double t = 1e3 / k, t2 = t * t, t3 = t2 * t;
  const double x = k < 4000 ? -0.2661239 * t3 - 0.2343589 * t2 + 0.8776956 * t + 0.179910
                            : -3.0258469 * t3 + 2.1070379 * t2 + 0.2226347 * t + 0.240390;
  const double x2 = x * x, x3 = x2 * x;
  const double y = k < 2222   ? -1.1063814 * x3 - 1.34811020 * x2 + 2.18555832 * x - 0.20219683
                   : k < 4000 ? -0.9549476 * x3 - 1.37418593 * x2 + 2.09137015 * x - 0.16748867
                              : 3.0817580 * x3 - 5.87338670 * x2 + 3.75112997 * x - 0.37001483;
  return {x, y};
}

/// ACEScg (AP1) from XYZ; rows of the inverse primary matrix of SMPTE ST 2065 / S-2014-004.
dvec3 acescg(dvec2 xy) {
  const dvec3 xyz(xy.x / xy.y, 1.0, (1 - xy.x - xy.y) / xy.y);
  return {1.6410233797 * xyz.x - 0.3248032942 * xyz.y - 0.2364246952 * xyz.z,
          -0.6636628587 * xyz.x + 1.6153315917 * xyz.y + 0.0167563477 * xyz.z,
          0.0117218943 * xyz.x - 0.0082844420 * xyz.y + 0.9883948585 * xyz.z};
}

}  // namespace

dvec3 sunDirection(double azimuth, double elevation) {
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

vec3 temperatureColor(double kelvin) {
  const dvec3 white = acescg(planckianXy(6500.0));
  dvec3 c = glm::max(acescg(planckianXy(glm::clamp(kelvin, 1667.0, 25000.0))) / white, dvec3(0.0));
  c /= glm::dot(c, dvec3(0.2722287168, 0.6740817658, 0.0536895174));  // AP1 luminance
  return vec3(c);
}

}  // namespace pileus::scene
