// The light that surfaces get: under a spot, in the shadow of a box, in the penumbra of a soft sun.
#include <cmath>

#include "tests/support/lit.h"

namespace pileus {
namespace {

shadow::ShadowSpec marched() {
  shadow::ShadowSpec spec;
  spec.kind = shadow::ShadowSpec::Kind::RayMarch;
  return spec;
}

TEST(LitSurfaces, PlaneIsLitByASpotAsItsConeSays) {
  const double h = 4;
  scene::Light spot = test::spotAt({0, h, 0}, {0, 0, 0}, 60, 0.5);
  spot.emitted = vec3(20);
  const scene::SolidList ground{test::solidPlane({0, 0, 0}, {20, 1, 20})};
  for (const double degrees : {0.0, 10.0, 14.0, 20.0, 25.0, 29.0, 31.0, 60.0}) {
    const double a = glm::radians(degrees), x = h * std::tan(a), r2 = h * h + x * x;
    const double c0 = std::cos(glm::radians(30.0)), c1 = std::cos(glm::radians(15.0));
    const double t = glm::clamp((std::cos(a) - c0) / (c1 - c0), 0.0, 1.0);
    const double want = 20 / r2 * std::cos(a) * t * t * (3 - 2 * t) * 0.5 / kPi;
    const double have = double(test::along({x, 30, 0}, {x, 0, 0}, {{}, {}, {{spot, nullptr}}, ground}).x);
    EXPECT_NEAR(have, want, 2e-5 * 20 / (h * h)) << degrees;
    if (degrees > 30) {
      EXPECT_EQ(have, 0) << degrees;
    }
  }
}

TEST(LitSurfaces, PlaneInTheShadowOfABox) {
  const scene::SolidList solids{test::solidPlane({0, 0, 0}, {40, 1, 40}),
                                test::solidBox({0, 2, 0}, {2, 2, 2})};
  const scene::Light sun =
      test::sunFrom({1, 1, 0}, 3);  // its shadow on the ground: x in [-4, 0], z in [-1, 1]
  const scene::Light lamp = test::pointAt({0, 6, 0}, 90);  // its shadow on the ground: |x| and |z| < 2
  const scene::Light inside = test::pointAt({0, 2, 0}, 90), below = test::pointAt({0, -3, 0}, 90);
  const auto at = [&](const scene::Light& light, double x, double z) {
    const shadow::ShadowedLight shadowed = test::shadowed(light, marched(), {}, solids);
    const dvec3 ground(x, 0, z);
    return double(test::along(ground + dvec3(0, 0.9, 0), ground, {{}, {}, {shadowed}, solids}).x);
  };
  const double lit = 3 * std::sqrt(0.5) * 0.5 / kPi;
  for (const double e : {0.003, 0.5}) {
    EXPECT_EQ(at(sun, 0 - e, 0), 0);
    EXPECT_EQ(at(sun, -2, 1 - e), 0);
    EXPECT_EQ(at(sun, -4 + e, 0), 0);
    EXPECT_NEAR(at(sun, 0 + e, 0), lit, 1e-6);
    EXPECT_NEAR(at(sun, -4 - e, 0), lit, 1e-6);
    EXPECT_NEAR(at(sun, -2, 1 + e), lit, 1e-6);
    EXPECT_EQ(at(lamp, 2 - e, 1), 0);
    const double x = 2 + e, r2 = 36 + x * x + 1;
    EXPECT_NEAR(at(lamp, x, 1), 90 / r2 * 6 / std::sqrt(r2) * 0.5 / kPi, 1e-5);
    EXPECT_EQ(at(inside, x, 1), 0);  // a lamp in a box lights nothing outside
    EXPECT_EQ(at(below, x, 1), 0);   // nor one below the ground what is above
  }
}

TEST(LitSurfaces, SoftSunHasThePenumbraOfItsDisc) {
  // A wide box's edge, 10 m above the ground along z, hides the part of the disc with angles below that of
  // the edge.
  const double height = 10, angle = 6;
  const int samples = 32;
  scene::Light sun = test::sunFrom({0, 1, 0}, 4);
  sun.angle = angle;
  const scene::SolidList solids{test::solidPlane({0, 0, 0}, {100, 1, 100}),
                                test::solidBox({-25, height + 0.5, 0}, {50, 1, 200})};
  std::vector<shadow::ShadowedLight> lights;
  for (const scene::Light& part : scene::splitDisc(sun, samples))
    lights.push_back(test::shadowed(part, marched(), {}, solids));
  ASSERT_EQ(lights.size(), 32u);
  const double edge = std::sin(glm::radians(angle) / 2);
  double worst = 0, mean = 0;
  const int steps = 40;
  double last = -1;
  for (int i = 0; i <= steps; ++i) {
    const double x = (2.4 * i / steps - 1.2) * height * std::tan(glm::radians(angle) / 2);
    // Rays towards directions with sin(angle in x) >= that of the edge as seen from x pass: a chord's share
    // of the disc.
    const double s = glm::clamp(-x / std::sqrt(x * x + height * height) / edge, -1.0, 1.0);
    const double share = (std::acos(s) - s * std::sqrt(1 - s * s)) / kPi;
    const double have =
        double(test::along({x, 5, 0}, {x, 0, 0}, {{}, {}, lights, solids}).x) / (4 * 0.5 / kPi);
    worst = std::max(worst, std::abs(have - share));
    mean += std::abs(have - share) / (steps + 1);
    EXPECT_GE(have, last - 1e-6);  // never darker further out
    last = have;
  }
  std::printf("penumbra by %d suns: mean error %.4f, max %.4f of the disc\n", samples, mean, worst);
  // The edge passes over no more than two or three of the suns at once, and mostly is off by less than one.
  EXPECT_LT(worst, 2.5 / samples);
  EXPECT_LT(mean, 0.8 / samples);
}

}  // namespace
}  // namespace pileus
