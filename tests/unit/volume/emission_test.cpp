// Tables of emission, and what a first look makes of grids that glow.
#include "renderer/volume/emission.h"

#include <gtest/gtest.h>

#include "renderer/scene/black_body.h"
#include "renderer/volume/fire_fit.h"
#include "tests/support/noise_grid.h"

namespace pileus::volume {
namespace {

double straight(double part) { return part; }

double luminance(const dvec4& c) {
  return glm::dot(dvec3(c), dvec3(0.2722287168, 0.6740817658, 0.0536895174));
}

TEST(Emission, TheTableIsTheBlackBodysLight) {
  const RemapPtr table = makeEmission(2, 4, straight, {1000, 2000, 7});
  EXPECT_NEAR(luminance(table->at(4)), 7, 1e-5) << "the hottest has the strength as its luminance";
  EXPECT_EQ(luminance(table->at(9)), luminance(table->at(4))) << "and so has all above";
  const dvec3 middle = 7.0 * scene::blackBodyColor(1500, 2000), got(table->at(3));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], middle[c], 2e-3 * middle[c]);
  EXPECT_EQ(table->at(2), dvec4(0)) << "nothing glows where the curve is 0";
  EXPECT_EQ(table->at(0), dvec4(0));
  EXPECT_EQ(table->emptyUpTo, 2);
}

TEST(Emission, LiesBehindARemap) {
  const RemapPtr table = makeEmission(0, 1, straight, {1000, 2000, 3});
  EXPECT_EQ(emissionBehind(nullptr, table), table);
  const RemapPtr halved = emissionBehind(test::table(0, 1, [](double u) { return 0.5 * u; }), table);
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(halved->at(1)[c], table->at(0.5)[c], 1e-6);
}

TEST(Emission, WhatEmitsHasNoExtinction) {
  Instance i = test::gridInstance(test::gridOf(40, test::blobs), 40, 5);
  const dvec3 hot(i.worldFromLocal * dvec4(22, 24, 26, 1));
  EXPECT_GT(sigmaAt(i, hot), 0);
  EXPECT_EQ(emissionAt(i, hot), dvec3(0));
  EXPECT_FALSE(emits(i));
  const Key plain = contentKey({i});
  i.emission = makeEmission(0, 1, straight, {1000, 2000, 3});
  EXPECT_EQ(sigmaAt(i, hot), 0);
  EXPECT_EQ(majorant(i), 0);
  EXPECT_GT(emissionAt(i, hot).r, 0);
  EXPECT_EQ(emissionAt(i, dvec3(2)), dvec3(0)) << "outside";
  EXPECT_TRUE(emits(i));
  EXPECT_NE(contentKey({i}), plain);
  i.emission = makeEmission(0, 1, straight, {1000, 2000, 0});
  EXPECT_FALSE(emits(i)) << "no strength";
}

GridInfo grid(const std::string& name, double maximum) {
  GridInfo g;
  g.name = name;
  g.valueType = "float";
  g.maximum = maximum;
  g.scalar = true;
  g.drawable = maximum > 0;
  return g;
}

TEST(FireFit, ChoosesWhatGlows) {
  const std::vector<GridInfo> kelvins{grid("density", 1), grid("flames", 1), grid("temperature", 1800)};
  EXPECT_EQ(fireGrid(kelvins)->name, "temperature");
  const std::vector<GridInfo> units{grid("density", 1), grid("flames", 0.2), grid("temperature", 1.1)};
  EXPECT_EQ(fireGrid(units)->name, "flames");
  const std::vector<GridInfo> cold{grid("density", 1), grid("flame", 0), grid("heat", 0.7)};
  EXPECT_EQ(fireGrid(cold)->name, "heat");
  const std::vector<GridInfo> none{grid("density", 1), grid("flame", 0)};
  EXPECT_EQ(fireGrid(none), nullptr);
}

TEST(FireFit, AUniformBlockReachesTheWantedRadiance) {
  // 30 voxels of 1/60 m: half a metre across.
  const GridPtr made = test::gridOf(60, [](ivec3 v) {
    return glm::all(glm::greaterThanEqual(v, ivec3(15))) && glm::all(glm::lessThan(v, ivec3(45))) ? 0.8f
                                                                                                  : 0.0f;
  });
  auto small = std::make_shared<BrickGrid>(*made);
  small->worldFromIndex = glm::scale(dmat4(1), dvec3(1.0 / 60));
  const FireFit fit = fitFire(small, {}, nullptr, 4.0);
  EXPECT_FALSE(fit.kelvins);
  EXPECT_NEAR(fit.brightness, 4, 0.05);
  EXPECT_NEAR(fit.range.highest, 0.8, 0.01);
  EXPECT_EQ(fit.range.lowest, 0);
  EXPECT_NEAR(fit.range.body.strength * 0.5, 4, 0.3) << "strength x length";
  const FireFit twice = fitFire(small, {}, nullptr, 8.0);
  EXPECT_NEAR(twice.range.body.strength, 2 * fit.range.body.strength, 0.02 * twice.range.body.strength);
}

TEST(FireFit, SmokeInFrontMakesItStronger) {
  const auto made = std::make_shared<BrickGrid>(*test::gridOf(60, test::blobs));
  made->worldFromIndex = glm::scale(dmat4(1), dvec3(1.0 / 60));
  Instance smoke;
  smoke.shape = Shape::Grid;
  smoke.grid = made;
  smoke.worldFromLocal = made->worldFromIndex;
  const FireFit alone = fitFire(made, {});
  smoke.medium.extinction = 1e-9;
  EXPECT_NEAR(fitFire(made, {}, &smoke).range.body.strength, alone.range.body.strength,
              0.01 * alone.range.body.strength);
  smoke.medium.extinction = 6;
  const FireFit dimmed = fitFire(made, {}, &smoke);
  EXPECT_GT(dimmed.range.body.strength, 1.2 * alone.range.body.strength);
  EXPECT_NEAR(dimmed.brightness, 2, 0.02);
  smoke.medium.extinction = 1000;
  const FireFit hidden = fitFire(made, {}, &smoke);
  EXPECT_NEAR(hidden.range.body.strength, 10 * alone.range.body.strength, 0.1 * alone.range.body.strength)
      << "not as strong as it takes";
  EXPECT_LT(hidden.brightness, 1);
}

TEST(FireFit, KelvinsAreTakenAsSuch) {
  const FireFit fit = fitFire(test::gridOf(40, [](ivec3 v) { return 300 + 1500 * test::blobs(v); }), {});
  EXPECT_TRUE(fit.kelvins);
  EXPECT_EQ(fit.range.lowest, fit.range.body.coolest);
  EXPECT_EQ(fit.range.highest, fit.range.body.hottest);
  EXPECT_GT(fit.range.body.hottest, 1400);
  EXPECT_LE(fit.range.body.hottest, 1800);
  EXPECT_NE(fireNote(fit.range, 1800).find("taken as kelvins"), std::string::npos);
  EXPECT_NE(fireNote({0, 1800, {}}, 1800).find("look like kelvins"), std::string::npos);
  EXPECT_EQ(fireNote({0, 1.5, {}}, 1.5), "Values 0 to 1.5 become 1000 to 2200 K");
}

TEST(FireFit, EmptyAndColdGridsGiveNothing) {
  EXPECT_EQ(fitFire(nullptr, {}).brightness, 0);
  EXPECT_EQ(fitFire(test::gridOf(20, [](ivec3) { return 0.0f; }), {}).brightness, 0);
  EXPECT_EQ(fitFire(test::gridOf(20, [](ivec3) { return 250.0f; }), {}).brightness, 0) << "no fire at 250 K";
}

}  // namespace
}  // namespace pileus::volume
