// The sun by the height of what it lights: the table against the quadrature behind it, and what it says.
#include <cmath>
#include <random>

#include "renderer/scene/light.h"
#include "renderer/scene/sky.h"
#include "tests/support/support.h"

namespace pileus::scene {
namespace {

double largest(const dvec3& v) { return std::max({v.x, v.y, v.z}); }

TEST(SunAir, IsTheQuadratureAtEveryHeight) {
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> u(0, 1);
  const Air air;
  for (const double elevation : {-8.0, -3.0, -1.0, -0.2, 0.0, 0.3, 2.0, 10.0, 60.0}) {
    for (const double altitude : {0.0, 1500.0}) {
      const SunAir table = sunAir(air, elevation, altitude);
      ASSERT_EQ(table.passes.size(), std::size_t(kSunHeights));
      double worst = 0;
      for (int i = 0; i < 60; ++i) {
        const double y = i < 40 ? 16000 * u(rng) - 500 : 100000 * u(rng);
        const dvec3 want = sunTransmittance(air, std::clamp(y + altitude, 0.0, kAirTop), elevation),
                    got(sunThrough(table, y));
        worst = std::max(worst, largest(glm::abs(got - want)));
      }
      std::printf("  %.1f degrees, %.0f m: %.2g\n", elevation, altitude, worst);
      EXPECT_LT(worst, 3e-3) << elevation;
    }
  }
}

TEST(SunAir, LowSunsAreRedderBelow) {
  const SunAir low = sunAir({}, 1, 0);
  double before = 1e9;
  for (double y = 0; y <= 20000; y += 500) {
    const vec3 t = sunThrough(low, y);
    const double red = double(t.r / t.b);
    EXPECT_LT(red, before) << y;
    before = red;
  }
  const vec3 below = sunThrough(low, 500), above = sunThrough(low, 10000);
  EXPECT_GT(double(above.g), 2 * double(below.g));
}

// Below the horizon of the ground it stands above that of whoever is high enough.
TEST(SunAir, SetsFromBelow) {
  const SunAir set = sunAir({}, -2, 0);
  EXPECT_EQ(sunThrough(set, 0), vec3(0));
  EXPECT_GT(sunThrough(set, 12000).r, 0.0f);
  EXPECT_TRUE(sunIsUp(set));
  EXPECT_FALSE(sunIsUp(sunAir({}, -20, 0)));
  // Half of the disc above the horizon of the sea, no air: half of the light.
  EXPECT_NEAR(sunThrough(sunAir({0, 0, 0, 0}, 0, 0), 0).g, 0.5f, 0.02f);
}

TEST(SunAir, IsInTheIncidence) {
  Light sun;
  sun.towards = sunDirection(30, 1);
  sun.emitted = vec3(3, 2, 1);
  EXPECT_EQ(incidence(sun, {0, 50, 0}).irradiance(sun), sun.emitted);
  sun.air = std::make_shared<const SunAir>(sunAir({}, 1, 200));
  const vec3 want = sun.emitted * sunThrough(*sun.air, 50);
  EXPECT_EQ(incidence(sun, {7, 50, 3}).irradiance(sun), want);
  EXPECT_LT(want.b, 0.5f);
}

}  // namespace
}  // namespace pileus::scene
