// Solids on the CPU: where rays meet them.
#include "renderer/scene/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pileus::scene {
namespace {

Solid plane(const dvec3& center, const dvec3& size, const dvec3& rotate = dvec3(0)) {
  return {SolidShape::Plane, composeTransform(center, rotate, {size.x, 1, size.z})};
}
Solid box(const dvec3& center, const dvec3& size, const dvec3& rotate = dvec3(0)) {
  return {SolidShape::Box, composeTransform(center, rotate, size)};
}

TEST(Solid, APlaneIsMetOnBothSidesWithinItsEdges) {
  const Solid s = plane({1, 2, 3}, {4, 1, 2});
  const auto above = intersect(s, {1, 5, 3}, {0, -2, 0});
  ASSERT_TRUE(above);
  EXPECT_EQ(above->t, 1.5);  // in lengths of d
  EXPECT_EQ(above->normal, dvec3(0, 1, 0));
  const auto below = intersect(s, {2.9, 0, 3.9}, {0, 1, 0});
  ASSERT_TRUE(below);
  EXPECT_EQ(below->normal, dvec3(0, -1, 0));
  EXPECT_FALSE(intersect(s, {3.1, 0, 3}, {0, 1, 0}));
  EXPECT_FALSE(intersect(s, {1, 0, 4.1}, {0, 1, 0}));
  EXPECT_FALSE(intersect(s, {1, 5, 3}, {0, 1, 0}));        // behind
  EXPECT_FALSE(intersect(s, {-9, 2, 3}, {1, 0, 0}));       // along it
  EXPECT_FALSE(intersect(s, {1, 5, 3}, {0, -2, 0}, 1.6));  // before tMin
}

TEST(Solid, ABoxIsMetFromOutsideAndInside) {
  const Solid s = box({0, 0, 0}, {2, 4, 6});
  const auto outside = intersect(s, {0, 0, 10}, {0, 0, -1});
  ASSERT_TRUE(outside);
  EXPECT_NEAR(outside->t, 7, 1e-14);
  EXPECT_EQ(outside->normal, dvec3(0, 0, 1));
  const auto inside = intersect(s, {0.5, 0, 0}, {1, 0, 0});
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->t, 0.5, 1e-14);
  EXPECT_EQ(inside->normal, dvec3(-1, 0, 0));  // against the ray
  EXPECT_FALSE(intersect(s, {0, 2.1, 10}, {0, 0, -1}));
  EXPECT_FALSE(intersect(s, {0, 0, 10}, {0, 0, 1}));
}

/// Inside or on the solid, in units of its edges.
double depthOf(const Solid& s, const dvec3& world) {
  const dvec3 p = glm::abs(dvec3(glm::inverse(s.worldFromLocal) * dvec4(world, 1)));
  return 0.5 - std::max({p.x, p.y, p.z});
}

TEST(Solid, RandomRaysHitTheSurfaceAndNothingBefore) {
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> u(-1, 1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Solid s = box({u(rng), u(rng), u(rng)}, {1.2 + u(rng), 1.2 + u(rng), 1.2 + u(rng)},
                        {180 * u(rng), 180 * u(rng), 180 * u(rng)});
    const dvec3 o(3 * u(rng), 3 * u(rng), 3 * u(rng)), d = dvec3(u(rng), u(rng), u(rng)) - o;
    if (depthOf(s, o) > -1e-3) continue;
    const auto hit = intersect(s, o, d);
    const double end = hit ? hit->t : 20;
    for (int k = 0; k < 200; ++k) ASSERT_LT(depthOf(s, o + (k / 200.0) * end * d), 1e-12) << i;
    if (!hit) continue;
    ++hits;
    const dvec3 p = o + hit->t * d;
    EXPECT_NEAR(depthOf(s, p), 0, 1e-12) << i;
    EXPECT_NEAR(glm::length(hit->normal), 1, 1e-12) << i;
    EXPECT_LE(glm::dot(hit->normal, d), 0) << i;
    EXPECT_LT(depthOf(s, p + 1e-4 * hit->normal), 0) << i;  // outwards
    EXPECT_GT(depthOf(s, p - 1e-4 * hit->normal), -1e-9) << i;
  }
  std::printf("%d of 2000 rays hit\n", hits);
  EXPECT_GT(hits, 500);
}

TEST(Solid, BlockedIsSymmetricAndOpen) {
  const SolidList solids{box({0, 0, 0}, dvec3(1)), plane({5, 0, 0}, dvec3(1))};
  EXPECT_TRUE(blocked(solids, {-2, 0, 0}, {2, 0, 0}));
  EXPECT_TRUE(blocked(solids, {2, 0, 0}, {-2, 0, 0}));
  EXPECT_FALSE(blocked(solids, {-2, 0, 0}, {-0.6, 0, 0}));
  EXPECT_FALSE(blocked(solids, {-2, 0.6, 0}, {2, 0.6, 0}));
  EXPECT_TRUE(blocked(solids, {5, 1, 0}, {5, -1, 0}));
  EXPECT_FALSE(blocked(solids, {5, 1, 0}, {5, 0.1, 0}));
  EXPECT_TRUE(blocked(solids, {0, 0, 0}, {0, 3, 0}));  // a light inside lights nothing outside
  EXPECT_FALSE(blocked({}, {0, 0, 0}, {0, 3, 0}));
}

TEST(Solid, WorldBoundsHoldThem) {
  const Box3 b = worldBounds({box({0, 1, 0}, {2, 2, 2}), plane({10, 0, 0}, {4, 9, 6})});
  EXPECT_EQ(b.min, dvec3(-1, 0, -3));
  EXPECT_EQ(b.max, dvec3(12, 2, 3));
  EXPECT_TRUE(worldBounds(SolidList{}).empty());
}

}  // namespace
}  // namespace pileus::scene
