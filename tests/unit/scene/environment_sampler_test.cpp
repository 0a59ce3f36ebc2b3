// Directions of an environment by importance: density, its integral, and what is drawn.
#include "renderer/scene/environment_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pileus::scene {
namespace {

/// Values over six powers of ten, with black rows, columns and texels.
EnvironmentMap rough(ivec2 size) {
  EnvironmentMap map{size, {}};
  std::mt19937 random(11);
  std::uniform_real_distribution<float> power(-3, 3), even(0, 1);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const bool black = y == 3 || x == 0 || x + 1 == size.x || even(random) < 0.2f;
      map.radiance.push_back(black ? vec3(0)
                                   : vec3(even(random), even(random), 1) * std::pow(10.0f, power(random)));
    }
  return map;
}

TEST(EnvironmentSampler, DensityIntegratesToOneAndFollowsImportance) {
  for (const ivec2 size : {ivec2(1, 1), ivec2(20, 9), ivec2(512, 256)}) {
    const EnvironmentMap map = size.x == 1 ? EnvironmentMap{size, {vec3(2)}} : rough(size);
    const EnvironmentSampler sampler = environmentSampler(map);
    ASSERT_EQ(sampler.size, size);
    const double energy = environmentImportance(vec3(environmentFlux(map)));
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const double pdf = sampler.pdf(environmentDirection({(x + 0.5) / size.x, (y + 0.5) / size.y}));
        const double wanted = environmentImportance(map.at(x, y)) / energy;
        // Shares are floats: they end after 2^-24 of a row's and of the whole's.
        EXPECT_NEAR(pdf * texelSolidAngle(size, y), wanted * texelSolidAngle(size, y),
                    2e-7 + 1e-4 * wanted * texelSolidAngle(size, y));
        sum += pdf * texelSolidAngle(size, y);
      }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

TEST(EnvironmentSampler, LargerMapsAreReducedAndBlackOnesEven) {
  EXPECT_EQ(environmentSampler(rough({700, 300})).size, ivec2(512, 256));
  const EnvironmentSampler black = environmentSampler({{8, 4}, std::vector<vec3>(32, vec3(0))});
  for (int y = 0; y < 4; ++y)
    EXPECT_NEAR(black.pdf(environmentDirection({0.3, (y + 0.5) / 4})), 1 / (4 * kPi), 1e-6);
}

/// Chi square of a million samples over the cells, those that expect less than 10 together.
TEST(EnvironmentSampler, SamplesFollowTheDensity) {
  const ivec2 size(40, 20);
  const EnvironmentMap map = rough(size);
  const EnvironmentSampler sampler = environmentSampler(map);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> even(0, 1);
  constexpr int kSamples = 1000000;
  std::vector<double> found(std::size_t(size.x * size.y), 0), upper(found), left(found);
  for (int i = 0; i < kSamples; ++i) {
    const EnvironmentSample one = sampler.sample(even(random), even(random));
    ASSERT_NEAR(glm::length(one.direction), 1, 1e-12);
    ASSERT_GT(one.pdf, 0);
    ASSERT_EQ(one.pdf, sampler.pdf(one.direction));
    const dvec2 p = environmentUv(one.direction) * dvec2(size);
    const std::size_t cell = std::size_t(int(p.y) * size.x + int(p.x));
    found[cell] += 1;
    const double middle = (rowSine(size.y, int(p.y)) + rowSine(size.y, int(p.y) + 1)) / 2;
    upper[cell] += one.direction.y > middle;
    left[cell] += p.x - int(p.x) < 0.5;
  }
  double chi = 0, rareFound = 0, rareWanted = 0;
  int cells = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const std::size_t cell = std::size_t(y * size.x + x);
      const double wanted = kSamples * texelSolidAngle(size, y) * environmentImportance(map.at(x, y)) /
                            environmentImportance(vec3(environmentFlux(map)));
      if (wanted == 0) {
        EXPECT_EQ(found[cell], 0);
      } else if (wanted < 10) {
        rareFound += found[cell];
        rareWanted += wanted;
      } else {
        ++cells;
        chi += (found[cell] - wanted) * (found[cell] - wanted) / wanted;
        // Within a cell directions are even in solid angle.
        EXPECT_NEAR(upper[cell] / found[cell], 0.5, 2.5 / std::sqrt(found[cell]));
        EXPECT_NEAR(left[cell] / found[cell], 0.5, 2.5 / std::sqrt(found[cell]));
      }
    }
  chi += (rareFound - rareWanted) * (rareFound - rareWanted) / rareWanted;
  // Normal approximation of Wilson and Hilferty; p > 1e-4.
  const double n = cells, z = (std::cbrt(chi / n) - (1 - 2 / (9 * n))) / std::sqrt(2 / (9 * n));
  EXPECT_LT(z, 3.72) << chi << " over " << n;
}

TEST(EnvironmentSampler, EndsOfTheRangeAreInside) {
  const EnvironmentSampler sampler = environmentSampler(rough({16, 8}));
  for (const double a : {0.0, 0.5, 1 - 0x1p-53})
    for (const double b : {0.0, 0.5, 1 - 0x1p-53}) {
      const EnvironmentSample one = sampler.sample(a, b);
      EXPECT_GT(one.pdf, 0);
      EXPECT_NEAR(glm::length(one.direction), 1, 1e-12);
    }
}

}  // namespace
}  // namespace pileus::scene
