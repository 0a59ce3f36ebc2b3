#include "renderer/scene/sky.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "renderer/scene/color_matching.h"
#include "renderer/scene/light.h"

namespace pileus::scene {
namespace {

/// Columns above a point towards a cosine from the zenith, not below the horizon [m].
Densities columnsAbove(double height, double cosine) {
  constexpr int kSteps = 96;
  const double r = kEarthRadius + height, top = kEarthRadius + kAirTop;
  const double low = r * std::sqrt(std::max(1 - cosine * cosine, 0.0)), begin = r * cosine;
  const double end = std::sqrt(std::max(top * top - low * low, 0.0));
  Densities out;
  // Steps are close where the ray is low: on both sides of the lowest point where it goes down first.
  const auto piece = [&](double from, double to) {
    for (int i = 0; i < kSteps; ++i) {
      const double s = (i + 0.5) / kSteps, length = (to - from) * 2 * s / kSteps;
      const Densities d = densities(std::hypot(low, from + (to - from) * s * s) - kEarthRadius);
      out.molecules += length * d.molecules;
      out.aerosol += length * d.aerosol;
      out.ozone += length * d.ozone;
    }
  };
  if (begin < 0) piece(0, -begin);
  piece(std::max(begin, 0.0), std::max(end, begin));
  return out;
}

}  // namespace

EnvironmentMap skyMap(const Atmosphere& atmosphere, const Sky& sky, ivec2 size, Atmosphere::Orders orders) {
  EnvironmentMap out{size, std::vector<vec3>(std::size_t(size.x) * std::size_t(size.y), vec3(0))};
  const dvec3 sun = sunDirection(0, sky.elevation);
  tbb::parallel_for(0, size.y, [&](int y) {
    const double up = rowSine(2 * size.y, 2 * y + 1);
    const Atmosphere::Path path = atmosphere.path(sky.height, up, orders);
    for (int x = 0; x <= (size.x - 1) / 2; ++x) {
      const dvec3 d = environmentDirection({(x + 0.5) / size.x, (y + 0.5) / size.y});
      const Spectrum s = atmosphere.radiance(path, sun.y, std::clamp(glm::dot(d, sun), -1.0, 1.0));
      out.at(x, y) = out.at(size.x - 1 - x, y) = vec3(sky.irradiance * spectrumColor(s));
    }
  });
  return out;
}

dvec3 sunAbove(double irradiance) { return irradiance * sunColor(); }

dvec3 sunTransmittance(const Air& air, double height, double elevation) {
  const double h = std::max(height, 0.0);
  const double radius = glm::radians(kSunDiameter / 2), horizon = std::asin(horizonCosine(h)),
               middle = glm::radians(elevation);
  const double lowest = std::clamp((horizon - middle) / radius, -1.0, 1.0);
  if (lowest >= 1) return dvec3(0);
  // Slices of the disc, by the angle about its middle: what is below the horizon sends nothing.
  constexpr int kSlices = 4;
  constexpr double kStep = 5;
  dvec3 sum(0);
  const double from = std::asin(lowest);
  for (int i = 0; i < kSlices; ++i) {
    const double a = glm::mix(from, kPi / 2, (i + 0.5) / kSlices);
    const double share = 2 / kPi * std::cos(a) * std::cos(a) * (kPi / 2 - from) / kSlices;
    const double cosine = std::sin(std::min(std::max(middle + radius * std::sin(a), horizon), kPi / 2));
    const Densities columns = columnsAbove(std::min(h, kAirTop), cosine);
    dvec3 xyz(0);
    for (double nm = 360; nm <= 830; nm += kStep) {
      const Coefficients c = coefficients(air, nm);
      xyz += kStep * solarIrradiance(nm) * colorMatching(nm) *
             std::exp(-c.molecules * columns.molecules - c.aerosolExtinction * columns.aerosol -
                      c.ozone * columns.ozone);
    }
    sum += share * colorOfSunlit(xyz);
  }
  return glm::max(sum / sunColor(), dvec3(0));
}

}  // namespace pileus::scene
