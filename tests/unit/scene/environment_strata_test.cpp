// An environment as a few suns: parts of equal energy, directions by importance, and means that converge.
#include "renderer/scene/environment_strata.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/scene/light.h"
#include "renderer/scene/phase.h"

namespace pileus::scene {
namespace {

/// A sky with a bright half, a dark ground, coloured lamps.
EnvironmentMap scenery(ivec2 size) {
  EnvironmentMap map{size, {}};
  std::mt19937 random(5);
  std::uniform_real_distribution<float> even(0.5f, 1.5f);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const dvec3 d = environmentDirection({(x + 0.5) / size.x, (y + 0.5) / size.y});
      const float glow = float(std::exp(8 * (glm::dot(d, sunDirection(70, 20)) - 1)));
      vec3 v = d.y > 0 ? vec3(0.3f, 0.5f, 1.0f) + glow * vec3(6, 4, 2) : vec3(0.1f, 0.08f, 0.05f);
      if (glm::dot(d, sunDirection(-120, -30)) > 0.99) v += vec3(0, 30, 3);
      map.radiance.push_back(v * even(random));
    }
  return map;
}

TEST(EnvironmentStrata, HaveEqualEnergyAndAllOfTheFlux) {
  for (const ivec2 size : {ivec2(1, 1), ivec2(6, 3), ivec2(300, 151), ivec2(1024, 512)}) {
    const EnvironmentMap map = scenery(size);
    const dvec3 flux = environmentFlux(map);
    for (const int count : {1, 16, 23, 256}) {
      SCOPED_TRACE(fmt::format("{} x {}, {}", size.x, size.y, count));
      const EnvironmentStrata strata(map, count);
      ASSERT_EQ(strata.strata().size(), std::size_t(count));
      dvec3 sum(0);
      for (const Stratum& s : strata.strata()) {
        sum += s.flux;
        EXPECT_NEAR(s.energy * count, environmentImportance(vec3(flux)), 1e-6 * flux.y);
        EXPECT_NEAR(glm::length(s.mean), 1, 1e-12);
        EXPECT_GE(s.narrow, 0);
        EXPECT_LE(s.narrow, 1);
      }
      EXPECT_LT(glm::length(sum / flux - 1.0), 1e-6);
    }
  }
  EXPECT_TRUE(EnvironmentStrata({{4, 2}, std::vector<vec3>(8, vec3(0))}).strata().empty());
  EXPECT_TRUE(EnvironmentStrata(EnvironmentMap()).strata().empty());
}

TEST(EnvironmentStrata, OfAnEvenSphereAreNarrowed) {
  const EnvironmentStrata whole({{1, 1}, {vec3(1)}}, 1);
  EXPECT_NEAR(whole.strata()[0].narrow, 0, 1e-6);
  // A half of the sphere has the mean 1/2.
  const EnvironmentStrata half({{1, 2}, {vec3(1), vec3(0)}}, 1);
  EXPECT_NEAR(half.strata()[0].narrow, 0.5, 1e-3);
  EXPECT_NEAR(half.strata()[0].mean.y, 1, 1e-9);
}

TEST(EnvironmentStrata, PartsAreThePartsOfTheWhole) {
  const EnvironmentStrata strata(scenery({256, 128}), 4);
  for (const Stratum& s : strata.strata()) {
    dvec3 flux(0), mean(0);
    for (unsigned i = 0; i < unsigned(kStratumParts); ++i) {
      const Stratum part = strata.part(s, i);
      EXPECT_NEAR(part.energy * kStratumParts, s.energy, 1e-6 * s.energy);
      flux += part.flux;
      mean += part.energy * part.narrow * part.mean;
    }
    EXPECT_LT(glm::length(flux / s.flux - 1.0), 1e-6);
    EXPECT_LT(glm::length(mean / (s.energy * s.narrow) - s.mean), 1e-6);
  }
}

/// Directions are those of the stratum, their density is what pdf says: the mean of f / pdf is its integral.
TEST(EnvironmentStrata, SamplesAreWeightedByTheirDensity) {
  const EnvironmentMap map = scenery({64, 32});
  const EnvironmentStrata strata(map, 8);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> even(0, 1);
  for (const Stratum& s : strata.strata()) {
    dvec3 flux(0), toward(0);
    constexpr int kSamples = 40000;
    for (int i = 0; i < kSamples; ++i) {
      const StratumSample one = strata.sample(s, even(random), even(random));
      ASSERT_GT(one.pdf, 0);
      ASSERT_NEAR(glm::length(one.direction), 1, 1e-9);
      ASSERT_EQ(one.radiance, environmentRadiance(map, one.direction));
      flux += dvec3(one.radiance) / one.pdf / double(kSamples);
      toward += one.direction / double(kSamples);
    }
    EXPECT_LT(glm::length(flux / s.flux - 1.0), 0.02);  // 4 standard errors of the widest
    EXPECT_NEAR(glm::length(toward), s.narrow, 0.01);
    EXPECT_LT(glm::length(glm::normalize(toward) - s.mean), 0.02);
  }
}

/// Mean of |estimate - integral of L p| / mean integral over directions of travel, after each of `sets`.
std::vector<double> errorsAfter(const EnvironmentMap& map, double g, const std::vector<unsigned>& sets,
                                bool draft = false) {
  const EnvironmentStrata strata(map, 16);
  const Phase phase = henyeyGreenstein(g);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> even(0, 1);
  std::vector<dvec3> directions, truth;
  double total = 0;
  for (int q = 0; q < 64; ++q) {
    const dvec3 d = sunDirection(360 * even(random), glm::degrees(std::asin(2 * even(random) - 1)));
    dvec3 sum(0);
    for (int y = 0; y < map.size.y; ++y)
      for (int x = 0; x < map.size.x; ++x) {
        const dvec3 from = environmentDirection({(x + 0.5) / map.size.x, (y + 0.5) / map.size.y});
        sum += texelSolidAngle(map.size, y) * phaseValue(phase, glm::dot(d, from)) * dvec3(map.at(x, y));
      }
    directions.push_back(d);
    truth.push_back(sum);
    total += sum.x + sum.y + sum.z;
  }
  std::vector<dvec3> sums(directions.size(), dvec3(0));
  std::vector<double> out;
  for (unsigned set = 0; set < sets.back(); ++set) {
    for (const EnvironmentLight& l : draft ? draftLights(strata) : environmentLights(strata, set)) {
      const Phase wide = henyeyGreenstein(g * l.narrow);
      for (std::size_t q = 0; q < directions.size(); ++q)
        sums[q] += phaseValue(wide, glm::dot(l.towards, directions[q])) * dvec3(l.irradiance);
    }
    if (std::find(sets.begin(), sets.end(), set + 1) == sets.end()) continue;
    double error = 0;
    for (std::size_t q = 0; q < directions.size(); ++q) {
      const dvec3 difference = glm::abs(sums[q] / double(set + 1) - truth[q]);
      error += difference.x + difference.y + difference.z;
    }
    out.push_back(error / total);
  }
  return out;
}

TEST(EnvironmentStrata, LightsConvergeToTheIntegral) {
  const EnvironmentMap map = scenery({256, 128});
  for (const double g : {0.0, 0.6, 0.85}) {
    SCOPED_TRACE(g);
    const std::vector<double> errors = errorsAfter(map, g, {16, 272, 1024});
    EXPECT_LT(errors[0], g == 0 ? 1e-6 : g < 0.7 ? 0.01 : 0.06);
    EXPECT_LT(errors[1], g < 0.7 ? 0.001 : 0.005);
    EXPECT_LT(errors[2], g < 0.7 ? 0.002 : 0.008);  // directions inside the parts begin
    EXPECT_LT(errorsAfter(map, g, {1}, true)[0], g < 0.7 ? 0.1 : 0.5);
  }
}

TEST(EnvironmentStrata, LightsComeFromTheNumberOfTheirSetAlone) {
  const EnvironmentStrata one(scenery({64, 32}), 16), two(scenery({64, 32}), 16);
  const dvec3 flux = environmentFlux(scenery({64, 32}));
  dvec3 sum(0);
  for (const unsigned set : {0u, 5u, 16u, 100u, 300u, 100000u}) {
    const auto a = environmentLights(one, set), b = environmentLights(two, set);
    ASSERT_EQ(a.size(), 16u);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].towards, b[i].towards);
      EXPECT_EQ(a[i].irradiance, b[i].irradiance);
      EXPECT_TRUE(a[i].narrow >= 0 && a[i].narrow <= 1);
    }
  }
  for (unsigned set = 0; set < unsigned(kStratumParts); ++set)
    for (const EnvironmentLight& l : environmentLights(one, set))
      sum += dvec3(l.irradiance) / double(kStratumParts);
  EXPECT_LT(glm::length(sum / flux - 1.0), 1e-6) << "a round of sets holds the whole map";
}

}  // namespace
}  // namespace pileus::scene
