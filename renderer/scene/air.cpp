#include "renderer/scene/air.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/scene/acescg.h"
#include "renderer/scene/black_body.h"
#include "renderer/scene/color_matching.h"

namespace pileus::scene {
namespace {

/// Straight between values that are `step` apart, level beyond them.
template <std::size_t N>
double tabled(const std::array<double, N>& values, double from, double step, double x) {
  const double t = std::clamp((x - from) / step, 0.0, double(N - 1));
  const std::size_t i = std::min(std::size_t(t), N - 2);
  return glm::mix(values[i], values[i + 1], t - double(i));
}

/// Vertical optical depth of molecules (Bodhaine, Wood, Dutton and Slusser 1999, eq. 30: sea level, 45 N).
double molecularOpticalDepth(double nm) {
  const double l2 = nm * nm * 1e-6;  // micrometres squared
  return 0.0021520 * (1.0455996 - 341.29061 / l2 - 0.90230850 * l2) /
         (1 + 0.0027059889 / l2 - 85.968563 * l2);
}

/// XYZ of sunlight above the air.
dvec3 solarXyz() {
  static const dvec3 sum = [] {
    dvec3 s(0);
    for (double nm = 360; nm <= 830; nm += 5) s += 5 * solarIrradiance(nm) * colorMatching(nm);
    return s;
  }();
  return sum;
}

/// As blackBodyColor() has it: 6500 K is white.
dvec3 whiteBalanced(const dvec3& xyz) {
  static const dvec3 white = acescgFromXyz(blackBodyXyz(6500) / blackBodyXyz(6500).y);
  return acescgFromXyz(xyz) / white;
}

}  // namespace

Densities densities(double height) {
  if (height > kAirTop) return {};
  const double h = std::max(height, 0.0);
  // Ozone: a tent from 10 to 40 km.
  return {std::exp(-h / kMolecularDepth), std::exp(-h / kAerosolDepth),
          std::max(0.0, 1 - std::abs(h - 25e3) / kOzoneDepth)};
}

Coefficients coefficients(const Air& air, double nm) {
  // Cross sections of ozone at 293 K [1e-26 m^2], 380 to 760 nm in steps of 20 (Gorshelev, Serdyuchenko et
  // al. 2014, University of Bremen), means over 10 nm.
  static constexpr std::array<double, 20> kOzone{0.028, 0.153, 0.552, 1.58, 3.67, 7.75, 14.8,
                                                 21.4,  30.9,  42.7,  44.0, 50.2, 37.4, 26.6,
                                                 18.5,  12.1,  7.5,   5.1,  4.2,  2.5};
  constexpr double kOzoneColumn = 300 * 2.687e20;  // molecules per m^2 of 300 Dobson units
  // Aerosols of a clear continental day: optical depth 0.1 at 550 nm, Angstrom's exponent 1.3, and 0.95 of
  // what they take from a beam is scattered.
  const double aerosol = air.aerosol * 0.1 * std::pow(nm / 550, -1.3) / kAerosolDepth;
  return {air.air * molecularOpticalDepth(nm) / kMolecularDepth, 0.95 * aerosol, aerosol,
          air.ozone * kOzoneColumn * 1e-26 * tabled(kOzone, 380, 20, nm) / kOzoneDepth};
}

Phase molecularPhase() { return rayleigh(); }
Phase aerosolPhase() { return draine(0.65, 1); }  // mean cosine 0.71

double solarIrradiance(double nm) {
  // ASTM E-490, means over 10 nm, 360 to 830 nm.
  static constexpr std::array<double, 48> kIrradiance{
      1.11776, 1.14259, 1.01249, 1.14716, 1.72765, 1.73054, 1.6887,  1.61253, 1.91198, 2.03474,
      2.02042, 2.02212, 1.93377, 1.95809, 1.91686, 1.8298,  1.8685,  1.8931,  1.85149, 1.8504,
      1.8341,  1.8345,  1.8147,  1.78158, 1.7533,  1.6965,  1.68194, 1.64654, 1.6048,  1.52143,
      1.55622, 1.5113,  1.474,   1.4482,  1.41018, 1.36775, 1.34188, 1.31429, 1.28303, 1.26758,
      1.2367,  1.2082,  1.18737, 1.14683, 1.12362, 1.1058,  1.07124, 1.04992};
  return tabled(kIrradiance, 360, 10, nm);
}

dvec3 colorOfSunlit(const dvec3& xyz) {
  static const double luminance = acescgLuminance(whiteBalanced(solarXyz()));
  return whiteBalanced(xyz) / luminance;
}

dvec3 sunColor() { return colorOfSunlit(solarXyz()); }

double horizonCosine(double height) {
  const double h = std::max(height, 0.0), r = kEarthRadius + h;
  return -std::sqrt(h * (2 * kEarthRadius + h)) / r;
}

double visibleDisc(double height, double cosine) {
  const double above = std::asin(std::clamp(cosine, -1.0, 1.0)) - std::asin(horizonCosine(height));
  const double x = std::clamp(above / glm::radians(kSunDiameter / 2), -1.0, 1.0);
  return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / kPi;
}

}  // namespace pileus::scene
