// Small pictures of light from everywhere: what stands where, and how bright.
#include "renderer/view/environment_thumbnail.h"

#include <gtest/gtest.h>

#include <random>

namespace pileus::view {
namespace {

constexpr ivec2 kSize{64, 32};

scene::EnvironmentMap noise() {
  scene::EnvironmentMap map{kSize, {}};
  std::mt19937 random(5);
  std::uniform_real_distribution<float> value(0, 2);
  for (int i = 0; i < kSize.x * kSize.y; ++i)
    map.radiance.emplace_back(value(random), value(random), value(random));
  return map;
}

scene::Environment environment(double rotation, vec3 scale = vec3(1)) {
  scene::Environment out = scene::environmentOf(noise());
  out.rotation = rotation;
  out.scale = scale;
  return out;
}

TEST(EnvironmentThumbnail, ShowsEachDirectionWhereItIsInTheWorld) {
  for (const double rotation : {0.0, 45.0, -90.0, 360.0 * 5 / 64, -500.625}) {  // whole columns
    const scene::Environment light = environment(rotation, {2, 1, 0.5f});
    const scene::EnvironmentMap picture = environmentPreview(light, {}, kSize);
    ASSERT_EQ(picture.size, kSize);
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        const dvec2 uv = (dvec2(x, y) + 0.5) / dvec2(kSize);
        const vec3 right =
            light.scale * scene::environmentRadiance(*light.seen, scene::environmentDirection(uv), rotation);
        ASSERT_LT(glm::length(picture.at(x, y) - right), 1e-4f) << rotation << " at " << x << ", " << y;
      }
  }
}

TEST(EnvironmentThumbnail, ASunBringsItsIrradianceWhereItStands) {
  scene::Light sun;
  sun.kind = scene::LightKind::Sun;
  sun.towards = scene::sunDirection(50, 30);
  sun.emitted = {3, 2, 1};
  const scene::Environment light = environment(10);
  const scene::EnvironmentMap without = environmentPreview(light, {}, kSize),
                              with = environmentPreview(light, {&sun, 1}, kSize);
  dvec3 flux(0), middle(0);
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      const dvec3 added = dvec3(with.at(x, y) - without.at(x, y)) * scene::texelSolidAngle(kSize, y);
      flux += added;
      middle += added.x * scene::environmentDirection((dvec2(x, y) + 0.5) / dvec2(kSize));
    }
  EXPECT_LT(glm::length(flux - dvec3(sun.emitted)), 1e-3);
  EXPECT_GT(glm::dot(glm::normalize(middle), sun.towards), std::cos(glm::radians(3.0)));
  // One on the seam, and one straight above.
  for (const double elevation : {10.0, 90.0}) {
    sun.towards = scene::sunDirection(180, elevation);
    const scene::EnvironmentMap edge = environmentPreview(light, {&sun, 1}, kSize);
    EXPECT_NEAR(scene::environmentFlux(edge).y - scene::environmentFlux(without).y, 2, 1e-3) << elevation;
  }
}

TEST(EnvironmentThumbnail, ASmallMapIsCutFinerAndALargeOneKeepsItsLight) {
  scene::EnvironmentMap four{{4, 2}, std::vector<vec3>(8, vec3(1))};
  four.at(1, 0) = vec3(5);
  const scene::Environment light = scene::environmentOf(four);
  const scene::EnvironmentMap picture = environmentPreview(light, {}, kSize);
  EXPECT_GE(picture.size.x, kSize.x);
  EXPECT_LT(glm::length(scene::environmentFlux(picture) - scene::environmentFlux(four)), 1e-4);
  EXPECT_LT(glm::length(scene::environmentFlux(environmentPreview(environment(33), {}, {16, 8})) -
                        scene::environmentFlux(noise())),
            0.02);
}

}  // namespace
}  // namespace pileus::view
