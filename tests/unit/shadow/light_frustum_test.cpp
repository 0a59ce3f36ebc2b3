// What part of space a light's map covers.
#include "renderer/shadow/light_frustum.h"

#include <gtest/gtest.h>

#include "renderer/volume/brick_builder.h"

namespace pileus {
namespace {

volume::Instance box(const dvec3& center, const dvec3& size) {
  volume::Instance i;
  i.worldFromLocal = composeTransform(center, dvec3(0), size);
  i.medium.extinction = 1;
  return i;
}

scene::Light spot(const dvec3& position, const dvec3& target, double cone) {
  scene::Light light;
  light.kind = scene::LightKind::Spot;
  light.position = position;
  light.towards = glm::normalize(position - target);
  light.cone = cone;
  return light;
}

TEST(LightFrustum, ASpotLooksAtWhatIsInItsCone) {
  const scene::Light light = spot({0, 0, 0}, {0, 0, -10}, 40);
  const volume::Instance lit = box({0.3, 0.1, -5}, dvec3(1)), beside = box({300, 0, -5}, dvec3(2)),
                         behind = box({0, 0, 50}, dvec3(2)), far = box({0, 700, -50}, dvec3(1));
  const auto alone = shadow::fitLight(light, {lit}, 256);
  const auto among = shadow::fitLight(light, {beside, lit, behind, far}, 256);
  EXPECT_EQ(among.nearDistance, alone.nearDistance);
  EXPECT_EQ(among.farDistance, alone.farDistance);
  // The box's nearest and farthest points.
  EXPECT_NEAR(alone.nearDistance, 4.5, 0.01);
  EXPECT_NEAR(alone.farDistance, glm::length(dvec3(0.8, 0.6, 5.5)), 0.02);
}

TEST(LightFrustum, ASpotSeesAsMuchOfAWideMediumAsIsInItsCone) {
  // A floor of a kilometre, two metres below a lamp: what lies under the lamp alone counts.
  const scene::Light light = spot({0, 2, 0}, {0, 0, 0}, 60);
  const auto f = shadow::fitLight(light, {box({0, -0.5, 0}, {1000, 1, 1000})}, 256);
  EXPECT_NEAR(f.nearDistance, 2, 0.01);
  const double across = 3 * f.tanHalf;  // the pyramid's corner at the floor's lower side
  EXPECT_NEAR(f.farDistance, std::sqrt(9 + 2 * across * across), 0.02);
}

TEST(LightFrustum, EveryPointInTheConeIsWithinItsRange) {
  for (const double cone : {10.0, 90.0, 178.0}) {
    const scene::Light light = spot({0.4, 0.3, 0.2}, {1, -2, 0.5}, cone);
    // The light is in one of them.
    const volume::InstanceList media{box(dvec3(0), dvec3(2)), box({2, -5, 1}, {3, 1, 9}),
                                     box({9, 0, 0}, dvec3(3))};
    const auto f = shadow::fitLight(light, media, 256);
    EXPECT_EQ(f.nearDistance, 0);
    for (int k = 0; k < 20000; ++k) {
      const auto at = [&](int i) { return (k * (i + 7) * 2654435761u >> 8) % 10007 / 10006.0 - 0.5; };
      const volume::Instance& i = media[std::size_t(k % 3)];
      const dvec3 p(i.worldFromLocal * dvec4(at(1), at(4), at(9), 1));
      const auto m = shadow::mapCoordinates(f, p, 256);
      if (m.at.x < 0 || m.at.x > 1 || m.at.y < 0 || m.at.y > 1) continue;
      EXPECT_GE(m.at.z, 0);
      EXPECT_LE(m.at.z, 1);
    }
  }
}

TEST(LightFrustum, NothingInTheConeIsAnyRange) {
  const auto f = shadow::fitLight(spot({0, 0, 0}, {0, 0, -10}, 20), {box({50, 0, 0}, dvec3(1))}, 256);
  EXPECT_GT(f.farDistance, f.nearDistance);
}

TEST(LightFrustum, AsSmallAsItsMedia) {
  scene::Light sun;
  sun.towards = {0, 1, 0};
  for (const double size : {1e-9, 1e-3, 1e6}) {
    const auto f = shadow::fitLight(sun, {box(dvec3(0), dvec3(size))}, 256);
    EXPECT_NEAR(f.depth() / size, 1, 1e-3) << size;
    EXPECT_NEAR(f.width() / size, 1, 0.02) << size;
  }
}

TEST(LightFrustum, KnowsWhatItsTexelsAreTooWideFor) {
  volume::VoxelSource source;
  source.name = "full";
  source.activeMin = ivec3(0);
  source.activeMax = ivec3(63, 63, 7);
  source.fill = [](ivec3, float* out) {
    std::fill_n(out, volume::kStoredSize * volume::kStoredSize * volume::kStoredSize, 1.0f);
    return volume::Fill::Voxels;
  };
  JobControl control;
  volume::Instance grid;
  grid.shape = volume::Shape::Grid;
  grid.grid = volume::buildBricks(source, control).value().grid;
  grid.worldFromLocal = glm::scale(dmat4(1.0), dvec3(100, 100, 1));
  grid.medium.extinction = 1;
  scene::Light sun;
  sun.towards = {0, 0, 1};
  const double thick = grid.grid->indexBounds.size().z, wide = 100 * grid.grid->indexBounds.size().x;
  for (const int resolution : {128, 512, 2048}) {
    const auto f = shadow::fitLight(sun, {grid}, resolution);
    const auto thin = shadow::thinnestMedium(sun, {grid}, f, resolution);
    ASSERT_EQ(thin.has_value(), wide / resolution > thick) << resolution;
    if (!thin) continue;
    EXPECT_NEAR(thin->thickness, thick, 1e-9);
    EXPECT_NEAR(thin->texel, wide / resolution, 0.03 * thin->texel);
  }
  // A sheet that is exact between texels anyway.
  const volume::Instance sheet = box(dvec3(0), {1000, 1000, 0.001});
  EXPECT_FALSE(shadow::thinnestMedium(sun, {sheet}, shadow::fitLight(sun, {sheet}, 64), 64));
}

}  // namespace
}  // namespace pileus
