// The procedural cloud field: determinism, coverage, limits, low-pass, cancellation.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "renderer/volume/cloud/procedural.h"

namespace pileus::volume {
namespace {

CloudParams coarse(int resolution = 64) {
  CloudParams p;
  p.genus = Genus::Classic;
  p.resolution = resolution;
  return p;
}

GridPtr bake(const CloudParams& p) {
  JobControl control;
  auto r = bakeCloud(p, control);
  EXPECT_TRUE(r) << (r ? "" : r.error().message);
  return r ? *r : nullptr;
}

/// Part of the box's columns that hold more than a soft edge.
double groundCovered(const BrickGrid& g, const CloudParams& p) {
  if (g.empty()) return 0;
  const ivec3 lo(g.indexBounds.min), hi(g.indexBounds.max);
  int columns = 0;
  for (int z = lo.z; z <= hi.z; ++z)
    for (int x = lo.x; x <= hi.x; ++x) {
      bool any = false;
      for (int y = lo.y; y <= hi.y && !any; ++y)
        any = static_cast<double>(voxelAt(g, {x, y, z})) > 0.2 * p.density;
      columns += any;
    }
  return columns * g.voxelSize * g.voxelSize / (p.size.x * p.size.z);
}

TEST(Cloud, EqualParametersGiveEqualVoxels) {
  EXPECT_EQ(bake(coarse())->content, bake(coarse())->content);
  CloudParams other = coarse();
  other.seed = 2;
  EXPECT_NE(bake(coarse())->content, bake(other)->content);
}

TEST(Cloud, DefaultLiesInItsBoxWithPhysicalDensity) {
  const CloudParams p = coarse(96);
  const auto g = bake(p);
  ASSERT_FALSE(g->empty());
  EXPECT_LE(g->maximum, 0.0601f);
  EXPECT_GT(g->maximum, 0.03f);
  EXPECT_GE(g->minimum, 0.0f);
  const Box3 world = transformed({g->indexBounds.min + 1.0, g->indexBounds.max - 1.0}, g->worldFromIndex);
  for (int a = 0; a < 3; ++a) {
    EXPECT_GE(world.min[a], p.center[a] - p.size[a] / 2);
    EXPECT_LE(world.max[a], p.center[a] + p.size[a] / 2);
  }
  EXPECT_NEAR(g->voxelSize, 1600.0 / 96, 1e-9);
}

TEST(Cloud, CoverageIsTheCoveredPartOfTheGround) {
  double last = 0;
  for (double coverage : {0.05, 0.2, 0.4, 0.6, 0.8}) {
    CloudParams p = coarse();
    p.coverage = coverage;
    const double covered = groundCovered(*bake(p), p);
    EXPECT_NEAR(covered, coverage, 0.03 + 0.15 * coverage);
    EXPECT_GT(covered, last);
    last = covered;
  }
  CloudParams p = coarse();
  p.coverage = 0;
  EXPECT_TRUE(bake(p)->empty());
  p.coverage = 1;
  EXPECT_GT(groundCovered(*bake(p), p), 0.9);
}

TEST(Cloud, ALowResolutionIsTheLowPassOfAHighOne) {
  const auto fine = bake(coarse(128)), low = bake(coarse(32));
  const auto mass = [](const BrickGrid& g) {
    double sum = 0;
    const ivec3 lo(g.indexBounds.min), hi(g.indexBounds.max);
    for (int z = lo.z; z <= hi.z; ++z)
      for (int y = lo.y; y <= hi.y; ++y)
        for (int x = lo.x; x <= hi.x; ++x) sum += static_cast<double>(voxelAt(g, {x, y, z}));
    return sum * std::pow(g.voxelSize, 3);
  };
  EXPECT_NEAR(mass(*low) / mass(*fine), 1.0, 0.2);
  // Mean over 4^3 fine voxels against the coarse voxel: correlated like two pictures of one thing.
  const dmat4 fineFromWorld = glm::inverse(fine->worldFromIndex);
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0, n = 0;
  for (int z = 0; z < 32; ++z)
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 32; ++x) {
        const double a = static_cast<double>(voxelAt(*low, {x, y, z}));
        const dvec3 f = dvec3(fineFromWorld * (low->worldFromIndex * dvec4(x, y, z, 1)));
        const double b = sampleTrilinear(*fine, f, 2);
        sa += a, sb += b, saa += a * a, sbb += b * b, sab += a * b, ++n;
      }
  const double r = (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
  EXPECT_GT(r, 0.93);
}

TEST(Cloud, EveryCornerOfTheParametersWorks) {
  for (double v : {0.0, 1.0})
    for (double shear : {-10.0, 10.0}) {
      CloudParams p = coarse(24);
      p.detail = v;
      p.billow = 1 - v;
      p.shear = shear;
      const auto g = bake(p);
      EXPECT_TRUE(std::isfinite(g->maximum));
    }
  for (const dvec3 size :
       {dvec3(10, 5000, 10), dvec3(1e-3), dvec3(1e6, 1, 1e6), dvec3(1e6, 1e-3, 1), dvec3(200, 60, 3000)}) {
    CloudParams p = coarse(20);
    p.size = size;
    EXPECT_TRUE(std::isfinite(bake(p)->maximum));
  }
  CloudParams tiny = coarse(16);
  EXPECT_FALSE(bake(tiny)->empty());
}

TEST(Cloud, ParametersOutOfRangeAreNamed) {
  JobControl control;
  CloudParams p = coarse();
  p.coverage = 1.5;
  auto r = bakeCloud(p, control);
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, Code::Arguments);
  EXPECT_NE(r.error().message.find("coverage"), std::string::npos);
  p = coarse();
  p.size.y = std::nan("");
  EXPECT_FALSE(bakeCloud(p, control));
  p = coarse();
  p.resolution = 1000000;
  EXPECT_FALSE(bakeCloud(p, control));
}

TEST(Cloud, CancelStopsSoon) {
  CloudParams p = coarse(1024);
  p.coverage = 1;
  JobControl control;
  std::chrono::steady_clock::time_point asked;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    asked = std::chrono::steady_clock::now();
    control.cancel();
  });
  auto r = bakeCloud(p, control);
  const auto ended = std::chrono::steady_clock::now();
  canceller.join();
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, Code::Cancelled);
  EXPECT_LT(std::chrono::duration<double>(ended - asked).count(),
            0.5);  // 50 ms when the machine has nothing else to do
}

}  // namespace
}  // namespace pileus::volume
