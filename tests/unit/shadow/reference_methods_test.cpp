// The reference against methods that share nothing with it, on real smoke too, and its speed.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "renderer/shadow/reference.h"
#include "renderer/volume/vdb_child.h"
#include "renderer/volume/vdb_import.h"
#include "tests/support/support.h"
#include "tests/unit/shadow/reference_scenes.h"

namespace pileus::shadow {
namespace {

TEST(Reference, RatioTrackingAgreesWithinItsNoise) {
  const InstanceList list = crowd();
  std::mt19937_64 rng(15);
  const dvec3 rays[][2] = {{{-3, 0, 0}, {4, 0.3, 0.2}},
                           {{0, 3, 0.2}, {1, -2, 1}},
                           {{0.1, 0.2, 0.3}, {2, 2, 2}},
                           {{-2, -2, -2}, {-1, 3, 2}}};
  for (const auto& ray : rays) {
    const double want = std::exp(-opticalDepth(list, ray[0], ray[1]));
    double sum = 0, square = 0;
    const int n = 40000;
    for (int k = 0; k < n; ++k) {
      const double t = ratioTracking(list, ray[0], ray[1], rng);
      sum += t;
      square += t * t;
    }
    const double mean = sum / n, error = std::sqrt((square / n - mean * mean) / n);
    std::printf("T %.5f, ratio tracking %.5f +- %.5f\n", want, mean, error);
    EXPECT_LE(std::abs(mean - want), 4 * error);
    EXPECT_LT(error, 0.003);
    EXPECT_LT(want, 0.9);
  }
}

TEST(Reference, SmokeMatchesBruteForce) {
  PILEUS_NEEDS_DATA();
  JobControl control;
  volume::ImportLimits limits;
  limits.executable = PILEUS_BINARY;
  const auto imported = volume::importVdb(*test::dataFolder() / "vdb" / "smoke1.vdb", "", control, limits);
  ASSERT_TRUE(imported) << imported.error().message;
  const Instance smoke = placed(imported->grid, imported->grid->worldFromIndex, 0.5);
  const Box3 box = volume::worldBounds(smoke);
  Random random{std::mt19937_64(16)};
  double worst = 0;
  for (int n = 0; n < 8; ++n) {
    const dvec3 a = random.point(box.min, dvec3(box.min.x, box.max.y, box.max.z)),
                b = random.point(dvec3(box.max.x, box.min.y, box.min.z), box.max);
    const double want = midpoint({smoke}, a, b, 200000), have = opticalDepth({smoke}, a, b);
    EXPECT_NEAR(have, want, 2e-6 * (1 + want)) << n;
    worst = std::max(worst, std::abs(have - want) / (1 + want));
  }
  std::printf("smoke1: largest difference %.1e\n", worst);
}

TEST(Reference, WalksMillionsOfCellsASecond) {
  const GridPtr grid = randomGrid(ivec3(8), 17);
  const InstanceList list{placed(grid, dmat4(1.0))};
  Random random{std::mt19937_64(18)};
  const auto start = std::chrono::steady_clock::now();
  double cells = 0, tau = 0;
  for (int n = 0; n < 3000; ++n) {
    const dvec3 a = random.point(dvec3(0), dvec3(0, 128, 128)),
                b = random.point(dvec3(128, 0, 0), dvec3(128));
    tau += opticalDepth(list, a, b);
    cells += std::abs(b.x - a.x) + std::abs(b.y - a.y) + std::abs(b.z - a.z);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%.1f million cells a second\n", cells / seconds * 1e-6);
  EXPECT_GT(tau, 0);
#ifdef NDEBUG
  EXPECT_GT(cells / seconds, 2e6);
#endif
}

}  // namespace
}  // namespace pileus::shadow
