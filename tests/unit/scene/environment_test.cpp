// Maps of light from everywhere: where a texel lies, what it holds, and the suns that are taken out of one.
#include "renderer/scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "renderer/scene/environment_suns.h"

namespace pileus::scene {
namespace {

EnvironmentMap noise(ivec2 size, unsigned seed = 1) {
  EnvironmentMap map{size, {}};
  std::mt19937 random(seed);
  std::exponential_distribution<float> value(1.0f);
  for (int i = 0; i < size.x * size.y; ++i)
    map.radiance.emplace_back(value(random), 0.5f * value(random), 2 * value(random));
  return map;
}

EnvironmentMap constant(ivec2 size, const vec3& radiance) {
  return {size, std::vector<vec3>(std::size_t(size.x) * std::size_t(size.y), radiance)};
}

/// A disc of that diameter, texels covered in part by 8 x 8 points.
void addDisc(EnvironmentMap& map, const dvec3& towards, double diameter, const vec3& radiance) {
  for (int y = 0; y < map.size.y; ++y)
    for (int x = 0; x < map.size.x; ++x) {
      const dvec3 middle = environmentDirection({(x + 0.5) / map.size.x, (y + 0.5) / map.size.y});
      if (glm::length(middle - towards) > glm::radians(diameter / 2) + 2 * kPi / map.size.y) continue;
      int inside = 0;
      for (int k = 0; k < 64; ++k) {
        const dvec2 at((x + (k % 8 + 0.5) / 8) / map.size.x, (y + (k / 8 + 0.5) / 8) / map.size.y);
        inside += glm::length(environmentDirection(at) - towards) < 2 * std::sin(glm::radians(diameter) / 4);
      }
      map.at(x, y) += radiance * (float(inside) / 64);
    }
}

TEST(EnvironmentMap, ColumnsAndRowsShowWhatTheConventionSays) {
  for (const double rotation : {0.0, 30.0, -200.0})
    for (const dvec2& uv : {dvec2(0.5, 0.5), dvec2(0.25, 0.3), dvec2(0.9, 0.9), dvec2(0, 0.5)}) {
      const dvec3 d = environmentDirection(uv, rotation);
      EXPECT_NEAR(glm::length(d - sunDirection((0.5 - uv.x) * 360 + rotation, 90 - 180 * uv.y)), 0, 1e-12);
      EXPECT_NEAR(glm::length(environmentUv(d, rotation) - uv), 0, 1e-12);
      EXPECT_NEAR(glm::length(turned(environmentDirection(uv), rotation) - d), 0, 1e-12);
    }
  EXPECT_NEAR(environmentDirection({0.25, 0.5}).x, 1, 1e-12) << "a quarter from the left is +X";
}

TEST(EnvironmentMap, TexelsCoverTheSphere) {
  for (const ivec2 size : {ivec2(1, 1), ivec2(2, 1), ivec2(7, 5), ivec2(1024, 512)}) {
    double sum = 0;
    for (int y = 0; y < size.y; ++y) {
      sum += size.x * texelSolidAngle(size, y);
      EXPECT_NEAR(texelSolidAngle(size, y), 2 * kPi / size.x * (rowSine(size.y, y) - rowSine(size.y, y + 1)),
                  1e-12);
    }
    EXPECT_NEAR(sum, 4 * kPi, 1e-11);
  }
}

TEST(EnvironmentMap, LookupsFindTheTexelOfADirection) {
  const EnvironmentMap map = noise({16, 9});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 16; ++x) {
      const dvec3 d = environmentDirection({(x + 0.5) / 16, (y + 0.5) / 9}, 77);
      EXPECT_EQ(environmentRadiance(map, d, 77), map.at(x, y));
      EXPECT_NEAR(double(glm::length(smoothRadiance(map, d, 77) - map.at(x, y))), 0, 1e-4);
    }
}

TEST(EnvironmentMap, SmallerMapsKeepTheFlux) {
  const EnvironmentMap map = noise({100, 53});
  const dvec3 flux = environmentFlux(map);
  for (const ivec2 size : {ivec2(50, 53), ivec2(37, 20), ivec2(99, 1), ivec2(1, 1), ivec2(200, 10)}) {
    const EnvironmentMap small = reduced(map, size);
    EXPECT_EQ(small.size, glm::min(size, map.size));
    EXPECT_LT(glm::length(environmentFlux(small) / flux - 1.0), 2e-7) << size.x;
  }
  const EnvironmentMap even = reduced(constant({64, 32}, vec3(3)), {10, 7});
  for (const vec3& texel : even.radiance) EXPECT_NEAR(texel.x, 3, 1e-5f);
  const EnvironmentMap fine = refined(map, {250, 60});
  EXPECT_EQ(fine.size, ivec2(300, 106));
  EXPECT_LT(glm::length(environmentFlux(fine) / flux - 1.0), 1e-12);
}

TEST(EnvironmentMap, IrradianceOfAnEvenSphere) {
  const EnvironmentMap map = constant({256, 128}, vec3(2));
  for (const dvec3& normal : {dvec3(0, 1, 0), dvec3(1, 0, 0), glm::normalize(dvec3(1, -1, 1))})
    EXPECT_NEAR(environmentIrradiance(map, normal).x, 2 * kPi, 1e-3);
}

TEST(EnvironmentMap, WhatIsNoRadianceIsRepairedAndCounted) {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  EnvironmentMap map{
      {6, 1}, {vec3(1), vec3(nan, 1, nan), vec3(-1, 2, 3), vec3(infinity), vec3(1e30f), vec3(-infinity)}};
  const EnvironmentFaults faults = repair(map);
  EXPECT_EQ(faults.notNumbers, 1u);
  EXPECT_EQ(faults.negative, 2u);
  EXPECT_EQ(faults.tooBright, 2u);
  EXPECT_EQ(map.radiance, (std::vector<vec3>{vec3(1), vec3(0, 1, 0), vec3(0, 2, 3), vec3(kInfiniteRadiance),
                                             vec3(kLargestRadiance), vec3(0)}));
  EXPECT_FALSE(repair(map).any());
}

TEST(EnvironmentSuns, OneBrightTexelIsASun) {
  EnvironmentMap map = constant({128, 64}, vec3(0));
  map.at(40, 20) = {100, 200, 50};
  const EnvironmentMap before = map;
  const std::vector<Light> suns = extractSuns(map);
  ASSERT_EQ(suns.size(), 1u);
  EXPECT_NEAR(glm::length(suns[0].towards - environmentDirection({40.5 / 128, 20.5 / 64})), 0, 1e-12);
  EXPECT_LT(glm::length(dvec3(suns[0].emitted) / environmentFlux(before) - 1.0), 1e-6);
  EXPECT_LT(suns[0].angle, 3.2);
  EXPECT_EQ(environmentFlux(map), dvec3(0));
}

/// Direction, colour and size of discs before a sky, at places where rows are long and short.
TEST(EnvironmentSuns, DiscsBecomeSunsAndNoFluxIsLost) {
  for (const double elevation : {5.0, 45.0, 80.0, 89.9}) {
    SCOPED_TRACE(elevation);
    EnvironmentMap map = constant({2048, 1024}, vec3(0.5f, 0.7f, 1.0f));
    const dvec3 one = sunDirection(-100, elevation), two = sunDirection(60, elevation - 20);
    addDisc(map, one, 0.7, {40000, 30000, 20000});
    addDisc(map, two, 2, {1500, 2000, 2500});
    const dvec3 flux = environmentFlux(map);
    const std::vector<Light> suns = extractSuns(map);
    ASSERT_EQ(suns.size(), 2u);
    EXPECT_LT(glm::degrees(glm::length(suns[0].towards - one)), 0.02);
    EXPECT_LT(glm::degrees(glm::length(suns[1].towards - two)), 0.02);
    EXPECT_NEAR(suns[0].angle, 0.7, 0.1);
    EXPECT_NEAR(suns[1].angle, 2, 0.05);
    const double disc = kPi * std::pow(glm::radians(2.0) / 2, 2);
    EXPECT_NEAR(double(suns[1].emitted.x) / (1500 * disc), 1, 0.01);
    EXPECT_NEAR(double(suns[1].emitted.z) / (2500 * disc), 1, 0.01);
    const dvec3 after = environmentFlux(map) + dvec3(suns[0].emitted) + dvec3(suns[1].emitted);
    EXPECT_LT(glm::length(after / flux - 1.0), 1e-6);
    for (const vec3& texel : map.radiance) EXPECT_LE(texel.x, 0.5f);
  }
}

TEST(EnvironmentSuns, AreNeitherEvenSkiesNorHotTexelsNorPanels) {
  EnvironmentMap even = constant({256, 128}, vec3(1)), before = even;
  EXPECT_TRUE(extractSuns(even).empty());
  EXPECT_EQ(even, before);
  EnvironmentMap hot = noise({1024, 512});
  hot.at(7, 200) = vec3(1000);
  before = hot;
  EXPECT_TRUE(extractSuns(hot).empty());
  EXPECT_EQ(hot, before);
  EnvironmentMap panel = constant({256, 128}, vec3(0.01f));
  for (int y = 40; y < 60; ++y)
    for (int x = 20; x < 60; ++x) panel.at(x, y) = vec3(50);
  EXPECT_TRUE(extractSuns(panel).empty());
  EnvironmentMap black = constant({8, 4}, vec3(0)), nothing;
  EXPECT_TRUE(extractSuns(black).empty());
  EXPECT_TRUE(extractSuns(nothing).empty());
}

TEST(EnvironmentSuns, AreAtMostFour) {
  EnvironmentMap map = constant({512, 256}, vec3(0.001f));
  for (int i = 0; i < 6; ++i) addDisc(map, sunDirection(60 * i, 30), 2, vec3(float(1000 << i)));
  EXPECT_EQ(extractSuns(map).size(), std::size_t(kMostSuns));
}

}  // namespace
}  // namespace pileus::scene
