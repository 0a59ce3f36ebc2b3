// The sky against quadratures and photons of its own: first order by wavelength, all orders through layers,
// energy, colours of the sun, every height and hour.
#include "renderer/scene/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/scene/acescg.h"
#include "renderer/scene/color_matching.h"
#include "renderer/scene/light.h"

namespace pileus::scene {
namespace {

/// Optical depth at each wavelength of the straight way between two points: even steps, many.
struct Columns {
  double molecules = 0, aerosol = 0, ozone = 0;
  double depth(const Coefficients& c) const {
    return c.molecules * molecules + c.aerosolExtinction * aerosol + c.ozone * ozone;
  }
};
double heightOf(const dvec3& p) { return glm::length(p) - kEarthRadius; }
/// Distance to a sphere about the Earth's middle; below 0: it is not met.
double meets(const dvec3& o, const dvec3& d, double radius, bool far) {
  const double b = glm::dot(o, d), q = b * b - glm::dot(o, o) + radius * radius;
  return q < 0 ? -1 : far ? -b + std::sqrt(q) : -b - std::sqrt(q);
}
void add(Columns& sum, const dvec3& p, double length) {
  const Densities d = densities(std::max(heightOf(p), 0.0));
  sum.molecules += length * d.molecules;
  sum.aerosol += length * d.aerosol;
  sum.ozone += length * d.ozone;
}

/// Light scattered once, by colour: a march in steps that grow with the distance, from each point another to
/// the sun; wavelengths every 5 nm. The sun is a point.
dvec3 scatteredOnce(const Air& air, double height, const dvec3& view, const dvec3& sun) {
  const dvec3 o(0, kEarthRadius + height, 0);
  const double ground = meets(o, view, kEarthRadius, false);
  const double end = ground > 0 ? ground : meets(o, view, kEarthRadius + kAirTop, true);
  struct Point {
    Columns there;
    Densities d;
    double length;
  };
  std::vector<Point> points;
  Columns along, behind;
  constexpr int kSteps = 600;
  for (int i = 0; i < kSteps; ++i) {
    const double a = end * std::pow(double(i) / kSteps, 1.5), b = end * std::pow(double(i + 1) / kSteps, 1.5);
    const dvec3 p = o + view * ((a + b) / 2);
    Columns here = along;
    add(here, p, (b - a) / 2);
    add(along, p, b - a);
    if (meets(p, sun, kEarthRadius, false) > 0) continue;
    const double out = meets(p, sun, kEarthRadius + kAirTop, true);
    for (int k = 0; k < 150; ++k) {
      const double s = out * std::pow(double(k) / 150, 2), t = out * std::pow(double(k + 1) / 150, 2);
      add(here, p + sun * ((s + t) / 2), t - s);
    }
    points.push_back({here, densities(std::max(heightOf(p), 0.0)), b - a});
  }
  if (ground > 0) {
    const dvec3 p = o + view * ground;
    behind = along;
    for (int k = 0; k < 150; ++k) {
      const double out = meets(p, sun, kEarthRadius + kAirTop, true);
      const double s = out * std::pow(double(k) / 150, 2), t = out * std::pow(double(k + 1) / 150, 2);
      add(behind, p + sun * ((s + t) / 2), t - s);
    }
  }
  const double c = glm::dot(view, sun), molecular = phaseValue(molecularPhase(), c),
               dust = phaseValue(aerosolPhase(), c);
  dvec3 xyz(0);
  for (double nm = 360; nm <= 830; nm += 5) {
    const Coefficients k = coefficients(air, nm);
    double sum = 0;
    for (const Point& p : points)
      sum += p.length * std::exp(-p.there.depth(k)) *
             (molecular * k.molecules * p.d.molecules + dust * k.aerosolScattering * p.d.aerosol);
    if (ground > 0)
      sum += std::exp(-behind.depth(k)) * air.groundAlbedo / kPi *
             std::max(glm::dot(glm::normalize(o + view * ground), sun), 0.0);
    xyz += 5 * solarIrradiance(nm) * sum * colorMatching(nm);
  }
  return glm::max(colorOfSunlit(xyz), dvec3(0));
}

TEST(Sky, FirstOrderIsTheSpectralQuadrature) {
  for (const Air& air : {Air{}, Air{1.5, 4, 0.5, 0.8}, Air{1, 0, 2, 0}}) {
    const Atmosphere atmosphere(air);
    for (const double elevation : {80.0, 30.0, 5.0, 1.0, -3.0})
      for (const double height : {2.0, 1000.0, 12000.0})
        for (const dvec2& look :
             {dvec2(0, 90), dvec2(0, 40), dvec2(120, 8), dvec2(40, 2), dvec2(180, -20), dvec2(90, -70)}) {
          const dvec3 sun = sunDirection(0, elevation), view = sunDirection(look.x, look.y);
          const dvec3 expected = scatteredOnce(air, height, view, sun);
          const dvec3 found = spectrumColor(atmosphere.radiance(
              atmosphere.path(height, view.y, Atmosphere::Orders::First), sun.y, glm::dot(view, sun)));
          const double size = acescgLuminance(expected);
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 0.05 * std::max(expected[c], 0.3 * size) + 1e-6)
                << c << " sun " << elevation << " height " << height << " look " << look.x << ' ' << look.y
                << " aerosol " << air.aerosol;
        }
  }
}

/// Irradiance of the ground by the sky, of a photon each: flat layers, all orders, exact phase functions.
double photons(const Air& air, double nm, double elevation, int count) {
  const Coefficients c = coefficients(air, nm);
  constexpr int kLayers = 1000;
  constexpr double kThick = kAirTop / kLayers;
  std::vector<double> above(kLayers + 1, 0);  // optical depth above a layer's lower face
  for (int i = kLayers - 1; i >= 0; --i) {
    const Densities d = densities((i + 0.5) * kThick);
    above[std::size_t(i)] =
        above[std::size_t(i) + 1] +
        kThick * (c.molecules * d.molecules + c.aerosolExtinction * d.aerosol + c.ozone * d.ozone);
  }
  std::mt19937 random(9);
  std::uniform_real_distribution<double> even(0, 1);
  const auto turn = [&](const dvec3& d, double cosine) {
    const dvec3 side = glm::normalize(glm::cross(d, std::abs(d.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    const double a = 2 * kPi * even(random), s = std::sqrt(std::max(1 - cosine * cosine, 0.0));
    return glm::normalize(cosine * d + s * (std::cos(a) * side + std::sin(a) * glm::cross(d, side)));
  };
  double arrived = 0;
  for (int n = 0; n < count; ++n) {
    dvec3 d = -sunDirection(0, elevation);
    double depth = 0, weight = 1;  // optical depth below space
    for (bool scattered = false;;) {
      depth += -std::log(1 - even(random)) * -d.y;
      if (depth < 0) break;
      if (depth >= above[0]) {
        if (scattered) arrived += weight;
        weight *= air.groundAlbedo;
        const double up = std::sqrt(even(random)), a = 2 * kPi * even(random);
        d = {std::sqrt(1 - up * up) * std::cos(a), up, std::sqrt(1 - up * up) * std::sin(a)};
        depth = above[0];
      } else {
        std::size_t layer = std::size_t(
            std::upper_bound(above.begin(), above.end(), depth, std::greater<>()) - above.begin());
        layer = std::min(layer, std::size_t(kLayers)) - 1;
        const Densities here = densities((double(layer) + 0.5) * kThick);
        const double air_ = c.molecules * here.molecules, dust = c.aerosolScattering * here.aerosol,
                     all = air_ + c.aerosolExtinction * here.aerosol + c.ozone * here.ozone;
        weight *= (air_ + dust) / all;
        const bool molecule = even(random) * (air_ + dust) < air_;
        d = turn(d, sampleCosine(molecule ? molecularPhase() : aerosolPhase(), [&] { return even(random); }));
      }
      scattered = true;
      if (weight < 1e-4) break;
    }
  }
  return arrived / count * std::sin(glm::radians(elevation));
}

TEST(Sky, AllOrdersAreThoseOfPhotons) {
  for (const Air& air : {Air{}, Air{1, 0, 0, 0}, Air{1, 3, 1, 0.8}})
    for (const int wave : {0, 1, 5}) {
      const double elevation = 50;
      const Atmosphere atmosphere(air);
      double sky = 0;
      constexpr int kRings = 60, kAround = 60;
      for (int i = 0; i < kRings; ++i) {
        const double up = (i + 0.5) / kRings;
        const Atmosphere::Path path = atmosphere.path(0, up);
        for (int k = 0; k < kAround; ++k) {
          const double across = std::sqrt(1 - up * up), a = 2 * kPi * (k + 0.5) / kAround;
          const dvec3 d(across * std::sin(a), up, across * std::cos(a)), sun = sunDirection(0, elevation);
          sky += up * 2 * kPi / kRings / kAround *
                 double(atmosphere.radiance(path, sun.y, glm::dot(d, sun))[std::size_t(wave)]);
        }
      }
      const double expected = photons(air, kFirstWave + wave * kWaveStep, elevation, 200000);
      // Even scattering after the first is the less true the more aerosols there are.
      EXPECT_NEAR(sky / expected, 1, air.aerosol > 1 ? 0.1 : 0.06)
          << "aerosol " << air.aerosol << " wave " << wave;
    }
}

TEST(Sky, SendsLessThanArrivesAboveTheAir) {
  for (const Air& air : {Air{}, Air{1, 0, 0, 0}, Air{1, 10, 1, 0.3}, Air{2, 1, 1, 0}}) {
    const Atmosphere atmosphere(air);
    double before = 0;
    for (const double elevation : {2.0, 10.0, 40.0, 90.0}) {
      const EnvironmentMap map = skyMap(atmosphere, {elevation, 10, 0}, {64, 32});
      const double sine = std::sin(glm::radians(elevation));
      const dvec3 sky = environmentIrradiance(map, {0, 1, 0}),
                  sun = sine * sunTransmittance(air, 0, elevation) * sunAbove(10),
                  above = sine * sunAbove(10);
      const double all = acescgLuminance(sky + sun);
      EXPECT_LT(all, acescgLuminance(above)) << elevation;
      EXPECT_GT(all, before) << elevation;
      before = all;
    }
  }
}

TEST(Sky, TheSinkingSunReddensAndSets) {
  const Air air;
  for (const double height : {0.0, 2000.0, 8000.0}) {  // farther up ozone takes the red
    double ratio = 0, before = 2;
    const double horizon = glm::degrees(std::asin(horizonCosine(height)));
    for (double elevation = 90; elevation > horizon - 0.26; elevation -= elevation > 5 ? 1 : 0.05) {
      const dvec3 t = sunTransmittance(air, height, elevation);
      EXPECT_GE(t.x / t.z, ratio * (1 - 1e-6)) << height << ' ' << elevation;
      EXPECT_LE(acescgLuminance(t), before * (1 + 1e-9)) << height << ' ' << elevation;
      ratio = t.x / t.z;
      before = acescgLuminance(t);
    }
    EXPECT_EQ(sunTransmittance(air, height, horizon - 0.27), dvec3(0));
    EXPECT_EQ(sunTransmittance(air, height, -90), dvec3(0));
  }
  EXPECT_LT(glm::length(sunTransmittance(air, kAirTop, 45) - dvec3(1)), 1e-4);
  // The disc goes under smoothly: half of it is left when its middle is at the horizon of space.
  const double edge = glm::degrees(std::asin(horizonCosine(kAirTop)));
  EXPECT_LT(sunTransmittance({0, 0, 0, 0}, kAirTop, edge).x, 0.5 + 1e-6);
  EXPECT_NEAR(sunTransmittance({0, 0, 0, 0}, kAirTop, edge).x, 0.5, 0.02);
  for (double height = 0; height < 5000; height += 1000)
    EXPECT_GT(sunTransmittance(air, height + 1000, 10).z, sunTransmittance(air, height, 10).z);
}

TEST(Sky, TheTablesBeamIsThatOfTheQuadrature) {
  const Air air;
  const Atmosphere atmosphere(air);
  for (const double height : {0.0, 500.0, 3000.0, 15000.0, 60000.0})
    for (const double elevation : {90.0, 30.0, 5.0, 1.0, 0.5}) {
      const dvec3 found = spectrumColor(atmosphere.sunlight(height, std::sin(glm::radians(elevation)))),
                  expected = sunTransmittance(air, height, elevation) * sunColor();
      EXPECT_LT(glm::length(found - expected), 0.05 * glm::length(expected) + 2e-4)
          << height << ' ' << elevation;
    }
}

TEST(Sky, IsFiniteAtEveryHourAndHeight) {
  for (const Air& air : {Air{}, Air{0, 0, 0, 0}, Air{10, 10, 10, 1}}) {
    const Atmosphere atmosphere(air);
    for (const double elevation : {-90.0, -20.0, -10.0, -6.0, -1.0, -0.266, 0.0, 0.266, 3.0, 45.0, 90.0})
      for (const double height : {0.0, 1.0, 1000.0, 30000.0, 99999.0, 100000.0, 2e5, -100.0})
        for (const vec3& texel : skyMap(atmosphere, {elevation, 10, height}, {16, 8}).radiance)
          for (int c = 0; c < 3; ++c)
            ASSERT_TRUE(std::isfinite(texel[c]) && texel[c] >= 0) << elevation << ' ' << height;
  }
}

TEST(Sky, TheGroundIsLitByItsAlbedo) {
  for (const double albedo : {0.0, 0.2, 0.9}) {
    const Air air{1, 1, 1, albedo};
    const Atmosphere atmosphere(air);
    const EnvironmentMap map = skyMap(atmosphere, {60, 10, 0}, {128, 64});
    const dvec3 from = environmentIrradiance(map, {0, 1, 0}) +
                       std::sin(glm::radians(60.0)) * sunTransmittance(air, 0, 60) * sunAbove(10);
    const dvec3 ground(map.at(64, 63));
    EXPECT_LT(glm::length(ground - albedo / kPi * from), 0.04 * albedo / kPi * glm::length(from) + 1e-6)
        << albedo;
  }
}

TEST(Sky, LooksAsSkiesDo) {
  const Atmosphere atmosphere{Air{}};
  const EnvironmentMap day = skyMap(atmosphere, {40, 10, 1000});
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) ASSERT_EQ(day.at(x, y), day.at(255 - x, y));
  const vec3 zenith = day.at(10, 1), horizon = day.at(10, 62);
  EXPECT_GT(zenith.z, 1.5f * zenith.x);
  EXPECT_GT(horizon.x / horizon.z, 1.4f * zenith.x / zenith.z);
  EXPECT_GT(horizon.y, zenith.y);
  // Dusk: the side of the sun is bright and red.
  const EnvironmentMap dusk = skyMap(atmosphere, {-2, 10, 1000});
  EXPECT_GT(dusk.at(128, 63).x, 3 * dusk.at(0, 63).x);
  EXPECT_GT(dusk.at(128, 63).x, dusk.at(128, 63).z);
  EXPECT_NEAR(acescgLuminance(sunAbove(10)), 10, 1e-9);
}

}  // namespace
}  // namespace pileus::scene
