// A sun behind air: in every picture it is as red as the height of what it lights makes it.
#include <cmath>

#include "renderer/scene/sky.h"
#include "tests/support/lit.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

constexpr double kAltitude = 300, kSigma = 2e-3, kDeep = 100;

double largest(const dvec3& v) { return std::max({v.x, v.y, v.z}); }

scene::Light sunBehindAir(double elevation) {
  scene::Light sun = test::sunFrom(scene::sunDirection(0, elevation), 4);
  sun.air = std::make_shared<const scene::SunAir>(scene::sunAir({}, elevation, kAltitude));
  return sun;
}

TEST(SunBehindAir, IsThatOfTheCpu) {
  std::vector<dvec3> points;
  for (int i = 0; i < 200; ++i) points.push_back(dvec3(vec3(10.0 * i, 60.0 * i - 500, -3.0 * i)));
  for (const double elevation : {-2.0, 0.0, 3.0, 50.0}) {
    const scene::Light sun = sunBehindAir(elevation);
    const std::vector<test::Lit> lit = test::lit({sun, nullptr}, points);
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const dvec3 want(scene::incidence(sun, points[i]).irradiance(sun));
      worst = std::max(worst, largest(glm::abs(lit[i].irradiance - want)));
      EXPECT_EQ(lit[i].arriving, lit[i].irradiance);
    }
    EXPECT_LT(worst, 2e-5) << elevation;
  }
}

/// A thin wall of haze, 12 km high, lit and seen from the same side, 30 km away: a row of pixels is a height.
view::RenderScene tower(double elevation) {
  view::RenderScene scene;
  scene.options.size = {4, 48};
  scene.options.samples = 4;
  scene.options.camera = {{0, 6000, 30000}, {0, 6000, 0}, {0, 1, 0}, 21};
  scene.volumes = {test::box({0, 6000, 0}, {4000, 12000, kDeep}, kSigma)};
  scene.volumes[0].medium.albedo = vec3(1);
  const scene::Light sun = sunBehindAir(elevation);
  scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, {}, 0.5)}};
  return scene;
}

void expectHeights(const image::Image& image, double elevation, double tolerance, const char* by) {
  const std::vector<float>& p = image.layers[0].pixels;
  double worst = 0;
  vec3 below(0), above(0);
  for (int row = 0; row < 48; ++row) {
    const double slope = std::tan(glm::radians(10.5)) * (1 - 2 * (row + 0.5) / 48);
    const double y = 6000 + 30000 * slope;
    // Single scattering sent back by a slab.
    const double seen = std::sqrt(1 + slope * slope), lit = 1 / std::cos(glm::radians(elevation));
    const double sentBack = seen / (seen + lit) * (1 - std::exp(-kSigma * kDeep * (seen + lit))) / (4 * kPi);
    // By the quadrature itself, not by its table; over the row's height.
    dvec3 want(0);
    const double high = 30000 * std::tan(glm::radians(10.5)) / 24;
    for (int i = 0; i < 4; ++i)
      want += sentBack * scene::sunTransmittance({}, y + high * ((i + 0.5) / 4 - 0.5) + kAltitude, elevation);
    vec3 got(0);
    for (int x = 0; x < 4; ++x)
      for (int c = 0; c < 3; ++c) got[c] += p[std::size_t(4 * (4 * row + x) + c)] / 4;
    worst = std::max(worst, largest(glm::abs(dvec3(got) - want)) / (4 * sentBack));
    if (row == 0) above = got;
    if (row == 47) below = got;
  }
  std::printf(
      "  %s, %.0f degrees: off by %.2g of the sun above the air; below %.3g %.3g %.3g, above %.3g %.3g "
      "%.3g\n",
      by, elevation, worst, double(below.r), double(below.g), double(below.b), double(above.r),
      double(above.g), double(above.b));
  EXPECT_LT(worst, tolerance) << by << " " << elevation;
  if (elevation <= -2) {
    EXPECT_EQ(below, vec3(0));
  } else {
    EXPECT_GT(below.r / std::max(below.b, 1e-12f), 1.2f * above.r / above.b);
  }
  EXPECT_GT(above.r, 0.0f);
}

TEST(SunBehindAir, IsRedderBelowInPictures) {
  for (const double elevation : {-2.0, 0.0, 3.0})
    expectHeights(test::render(tower(elevation)), elevation, 0.01, "volume");
}

TEST(SunBehindAir, IsRedderBelowInPaths) {
  for (const double elevation : {-2.0, 0.0, 3.0}) {
    view::RenderScene scene = tower(elevation);
    scene.options.samples = 6000;
    view::PathOptions once;
    once.bounces = 0;
    expectHeights(test::traced(scene, once).picture, elevation, 0.06, "paths");
  }
}

}  // namespace
}  // namespace pileus
