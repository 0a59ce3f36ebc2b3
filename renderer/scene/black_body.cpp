#include "renderer/scene/black_body.h"

#include <array>
#include <cmath>

#include "renderer/scene/acescg.h"
#include "renderer/scene/color_matching.h"

namespace pileus::scene {
namespace {

/// Radiance per nanometre [W/(m^2 sr nm)].
double planck(double nm, double kelvin) {
  constexpr double kFirst = 1.191042972e-16, kSecond = 1.438776877e-2;  // 2 h c^2 [W m^2], h c / k [m K]
  const double m = nm * 1e-9;
  return 1e-9 * kFirst / (m * m * m * m * m) / std::expm1(kSecond / (m * kelvin));
}

constexpr double kFrom = 360, kStep = 2;  // nm
constexpr std::size_t kSteps = 236;       // to 830

/// The matching functions at each step: a table of emission asks for them hundreds of times.
const std::array<dvec3, kSteps>& matchingSteps() {
  static const auto steps = [] {
    std::array<dvec3, kSteps> all;
    for (std::size_t i = 0; i < kSteps; ++i) all[i] = colorMatching(kFrom + kStep * static_cast<double>(i));
    return all;
  }();
  return steps;
}

}  // namespace

dvec3 blackBodyXyz(double kelvin) {
  dvec3 sum(0);
  const auto& steps = matchingSteps();
  for (std::size_t i = 0; i < kSteps; ++i)
    sum += kStep * planck(kFrom + kStep * static_cast<double>(i), kelvin) * steps[i];
  return sum;
}

dvec3 blackBodyColor(double kelvin, double reference) {
  static const dvec3 white = acescgFromXyz(blackBodyXyz(6500) / blackBodyXyz(6500).y);
  const dvec3 xyz = blackBodyXyz(kelvin);
  const dvec3 color = glm::max(acescgFromXyz(xyz) / white, dvec3(0));
  const double luminance = acescgLuminance(color);
  return luminance > 0 ? color / luminance * (xyz.y / blackBodyXyz(reference).y) : dvec3(0);
}

}  // namespace pileus::scene
