#include "renderer/scene/black_body.h"

#include <cmath>

namespace pileus::scene {
namespace {

/// A bell with a width of its own on each side.
double lobe(double nm, double center, double left, double right) {
  const double t = (nm - center) / (nm < center ? left : right);
  return std::exp(-0.5 * t * t);
}

dvec3 matching(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

/// Radiance per nanometre [W/(m^2 sr nm)].
double planck(double nm, double kelvin) {
  constexpr double kFirst = 1.191042972e-16, kSecond = 1.438776877e-2;  // 2 h c^2 [W m^2], h c / k [m K]
  const double m = nm * 1e-9;
  return 1e-9 * kFirst / (m * m * m * m * m) / std::expm1(kSecond / (m * kelvin));
}

/// AP1 primaries, as in temperatureColor().
dvec3 acescg(const dvec3& xyz) {
  return {1.6410233797 * xyz.x - 0.3248032942 * xyz.y - 0.2364246952 * xyz.z,
          -0.6636628587 * xyz.x + 1.6153315917 * xyz.y + 0.0167563477 * xyz.z,
          0.0117218943 * xyz.x - 0.0082844420 * xyz.y + 0.9883948585 * xyz.z};
}

}  // namespace

dvec3 blackBodyXyz(double kelvin) {
  dvec3 sum(0);
  constexpr double kStep = 2;
  for (double nm = 360; nm <= 830; nm += kStep) sum += kStep * planck(nm, kelvin) * matching(nm);
  return sum;
}

dvec3 blackBodyColor(double kelvin, double reference) {
  const dvec3 xyz = blackBodyXyz(kelvin), white = blackBodyXyz(6500);
  const dvec3 color = glm::max(acescg(xyz) / acescg(white / white.y), dvec3(0));
  const double luminance = glm::dot(color, dvec3(0.2722287168, 0.6740817658, 0.0536895174));  // of AP1
  return luminance > 0 ? color / luminance * (xyz.y / blackBodyXyz(reference).y) : dvec3(0);
}

}  // namespace pileus::scene
