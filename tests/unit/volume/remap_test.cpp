// Remapped densities on the CPU: the table, its bounds, one after another, and histograms.
#include "renderer/volume/remap.h"

#include <gtest/gtest.h>

#include <random>

#include "renderer/volume/density_histogram.h"
#include "tests/support/noise_grid.h"

namespace pileus::volume {
namespace {

using test::table;

TEST(Remap, IsStraightBetweenEntriesAndLevelBeyond) {
  const RemapPtr r = table(0.5, 2.5, [](double u) { return 3 * u; });
  for (const double d : {0.5, 0.77, 1.0, 2.0, 2.5}) EXPECT_NEAR(r->density(d), 3 * (d - 0.5) / 2, 1e-6) << d;
  EXPECT_EQ(r->density(-1), 0);
  EXPECT_EQ(r->density(99), 3);
  EXPECT_EQ(r->at(99), dvec4(1, 1, 1, 3));
}

TEST(Remap, BoundsHoldForEveryDensity) {
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> u(0, 1);
  for (int round = 0; round < 50; ++round) {
    const double zeros = round % 3 == 0 ? 0 : u(rng);
    const RemapPtr r = table(0.2, 1.7, [&](double at) { return at < zeros ? 0 : u(rng); });
    const double from = 2 * u(rng), to = from + u(rng), most = r->largest(from, to), empty = r->emptyUpTo;
    double seen = 0;
    for (int k = 0; k <= 5000; ++k) {
      const double d = from + (to - from) * k / 5000;
      seen = std::max(seen, r->density(d));
      if (d <= empty) {
        ASSERT_EQ(r->density(d), 0);
      }
    }
    EXPECT_LE(seen, most + 1e-12);
    EXPECT_GE(seen, most - 0.02);
    if (std::isfinite(empty)) {
      EXPECT_GT(r->density(empty + 1e-3), 0);
    }
  }
  EXPECT_EQ(table(0, 1, [](double) { return 0; })->emptyUpTo, std::numeric_limits<double>::infinity());
  EXPECT_LT(table(0, 1, [](double) { return 1; })->emptyUpTo, 0);
}

TEST(Remap, OneAfterTheOther) {
  const RemapPtr square = table(0, 1, [](double u) { return u * u; }),
                 twice = table(0, 1, [](double u) { return 2 * u; });
  const RemapPtr both = composed(square, twice);
  for (const double d : {0.0, 0.25, 0.5, 1.0, 3.0})
    EXPECT_NEAR(both->density(d), twice->density(square->density(d)), 1e-4) << d;
  EXPECT_EQ(composed(nullptr, twice), twice);
  EXPECT_EQ(composed(twice, nullptr), twice);
  EXPECT_NE(both->content, square->content);
}

TEST(Remap, ShowsInBoundsKeysAndSigma) {
  Instance i = test::gridInstance(test::gridOf(80, test::blobs), 80, 2);
  const Key plain = contentKey({i});
  const dvec3 inside = dvec3(i.worldFromLocal * dvec4(22, 24, 26, 1)),
              air = dvec3(i.worldFromLocal * dvec4(70, 10, 10, 1));
  const double before = sigmaAt(i, inside);
  ASSERT_GT(before, 1.5);
  ASSERT_EQ(sigmaAt(i, air), 0);
  i.remap = table(0, 1, [](double u) { return 0.5 - 0.5 * u; });
  EXPECT_NE(contentKey({i}), plain);
  EXPECT_NEAR(sigmaAt(i, inside), 2 * (0.5 - 0.25 * before), 1e-6);
  EXPECT_EQ(sigmaAt(i, air), 1) << "empty space is filled";
  EXPECT_EQ(sigmaAt(i, air + dvec3(10, 0, 0)), 0) << "but nothing outside the volume's box";
  EXPECT_NEAR(majorant(i), 1, 1e-6);
  EXPECT_TRUE(occupied(i, Brick{}));
  i.remap = table(0, 1, [](double u) { return u < 0.5 ? 0 : 1; });
  EXPECT_FALSE(occupied(i, Brick{kConstantBrick, 0, 0, 0, 0.4f}));
  EXPECT_TRUE(occupied(i, Brick{kConstantBrick, 0, 0, 0, 0.6f}));
}

TEST(DensityHistogram, CountsEachVoxelThatHoldsSomething) {
  const auto half = [](ivec3 p) { return p.x < 16 ? 0.25f : p.x < 24 ? 1.0f : 0.0f; };
  Instance i = test::gridInstance(test::gridOf(32, half), 32, 1);
  JobControl control;
  const auto h = densityHistogram({i}, control);
  ASSERT_TRUE(h);
  EXPECT_EQ(h->highest, 1);
  EXPECT_NEAR(h->between(0.2, 0.3), 16 * 32 * 32, 1) << "the far planes of the lattice are empty";
  EXPECT_NEAR(h->between(0.9, 1), 8 * 32 * 32, 1);
  EXPECT_EQ(h->between(0.4, 0.9), 0);
  EXPECT_NEAR(h->between(0, 1), 24 * 32 * 32, 1e-6);
  i.remap = table(0, 1, [](double u) { return u > 0.5 ? 0.5 * u : 0; });
  const auto remapped = densityHistogram({i}, control);
  EXPECT_NEAR(remapped->between(0, 1), 8 * 32 * 32, 1e-6) << "as remapped";
  Instance box;
  box.density = 3;
  EXPECT_EQ(densityHistogram({box}, control)->between(2.9, 3), 64 * 64 * 64);
  control.cancel();
  EXPECT_FALSE(densityHistogram({i}, control));
}

}  // namespace
}  // namespace pileus::volume
