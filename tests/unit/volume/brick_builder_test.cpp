// Bricks against the function they were built from: quantisation, aprons, mips, limits.
#include "renderer/volume/brick_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pileus::volume {
namespace {

/// A source from a plain function of the index.
template <class F>
VoxelSource sourceOf(F f, ivec3 lo, ivec3 hi) {
  VoxelSource s;
  s.name = "test";
  s.activeMin = lo;
  s.activeMax = hi;
  s.fill = [f](ivec3 from, float* out) {
    for (int z = 0; z < kStoredSize; ++z)
      for (int y = 0; y < kStoredSize; ++y)
        for (int x = 0; x < kStoredSize; ++x) *out++ = f(from + ivec3(x, y, z));
    return Fill::Voxels;
  };
  return s;
}

float bumpy(ivec3 p) {
  const double v = std::sin(p.x * 0.31) * std::cos(p.y * 0.17) + std::sin(p.z * 0.23 + p.x * 0.05);
  return v > 0 ? static_cast<float>(v * 3.7) : 0.0f;
}

const Brick& brickOf(const BrickGrid& g, ivec3 index) {
  return g.levels[0].at((index - g.origin) / kBrickSize);
}

BuildResult build(const VoxelSource& s) {
  JobControl control;
  auto r = buildBricks(s, control);
  EXPECT_TRUE(r) << (r ? "" : r.error().message);
  return r ? *r : BuildResult{};
}

TEST(BrickBuilder, VoxelsAreWithinHalfAQuantumAndZerosExact) {
  const ivec3 lo(-37, 5, -100), hi(20, 60, -41);
  const auto g = build(sourceOf(bumpy, lo, hi)).grid;
  ASSERT_FALSE(g->empty());
  std::uint64_t count = 0;
  for (int z = lo.z - 3; z <= hi.z + 3; ++z)
    for (int y = lo.y - 3; y <= hi.y + 3; ++y)
      for (int x = lo.x - 3; x <= hi.x + 3; ++x) {
        const ivec3 p(x, y, z);
        const bool inside = glm::all(glm::greaterThanEqual(p, lo)) && glm::all(glm::lessThanEqual(p, hi));
        const float want = inside ? bumpy(p) : 0.0f, have = voxelAt(*g, p);
        count += want != 0;
        if (want == 0)
          ASSERT_EQ(have, 0.0f);
        else
          ASSERT_NEAR(have, want, brickOf(*g, p).scale / 510 * 1.0001f);
      }
  EXPECT_EQ(g->activeVoxels, count);
  EXPECT_EQ(g->origin, lo - 1);
  EXPECT_EQ(g->indexBounds.min, dvec3(lo) - 1.0);
  EXPECT_EQ(g->indexBounds.max, dvec3(hi) + 1.0);
}

TEST(BrickBuilder, TrilinearIsContinuousAcrossBricksAndMatchesTheVoxels) {
  const ivec3 lo(0), hi(70, 40, 40);
  const auto g = build(sourceOf(bumpy, lo, hi)).grid;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const dvec3 p = dvec3(-2) + u(random) * dvec3(0) + dvec3(u(random), u(random), u(random)) * dvec3(hi + 4);
    const ivec3 base(glm::floor(p));
    const dvec3 t = p - dvec3(base);
    double want = 0, quantum = 0;
    for (int c = 0; c < 8; ++c) {
      const ivec3 o(c & 1, (c >> 1) & 1, c >> 2), q = base + o;
      const bool inside = glm::all(glm::greaterThanEqual(q, lo)) && glm::all(glm::lessThanEqual(q, hi));
      want += (o.x ? t.x : 1 - t.x) * (o.y ? t.y : 1 - t.y) * (o.z ? t.z : 1 - t.z) *
              static_cast<double>(inside ? bumpy(q) : 0.0f);
    }
    const ivec3 b = (base - g->origin) / kBrickSize;
    const bool covered =
        glm::all(glm::greaterThanEqual(base, g->origin)) && glm::all(glm::lessThan(b, g->levels[0].bricks));
    if (covered) quantum = static_cast<double>(g->levels[0].at(b).scale) / 255;
    ASSERT_NEAR(sampleTrilinear(*g, p), want, 0.5 * quantum + 1e-6) << p.x << " " << p.y << " " << p.z;
  }
  // On both sides of every brick face the two bricks agree within their quanta.
  for (int i = 0; i < 2000; ++i) {
    dvec3 p(u(random) * 70, u(random) * 40, u(random) * 40);
    p.x = g->origin.x + kBrickSize * (1 + i % 4);
    EXPECT_NEAR(sampleTrilinear(*g, p), sampleTrilinear(*g, p - dvec3(1e-9, 0, 0)),
                2 * 0.5 * 7.4 / 255 + 1e-6);
  }
}

TEST(BrickBuilder, MipsAreContinuousAcrossBricks) {
  const auto g = build(sourceOf(bumpy, ivec3(0), ivec3(100, 100, 100))).grid;
  ASSERT_GE(g->levels.size(), 3u);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(0, 1);
  int faces = 0;
  for (int level = 1; level < static_cast<int>(g->levels.size()); ++level) {
    const ivec3 bricks = g->levels[std::size_t(level)].bricks;
    for (int axis = 0; axis < 3; ++axis)
      for (int face = 1; face < bricks[axis]; ++face)
        for (int i = 0; i < 200; ++i, ++faces) {
          dvec3 q = dvec3(u(random), u(random), u(random)) * dvec3(bricks * kBrickSize - 1);
          q[axis] = face * kBrickSize;
          const dvec3 p = (q + 0.5) * std::exp2(level) - 0.5 + dvec3(g->origin);
          dvec3 below = p;
          below[axis] -= 1e-9;
          ASSERT_NEAR(sampleTrilinear(*g, p, level), sampleTrilinear(*g, below, level), 7.4 / 255 + 1e-6)
              << "level " << level << ", axis " << axis << ", face " << face;
        }
  }
  EXPECT_GT(faces, 1000);
}

TEST(BrickBuilder, BrickRangesBoundWhatTheyAnswerFor) {
  const auto g = build(sourceOf(bumpy, ivec3(0), ivec3(50, 33, 33))).grid;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  for (int level = 0; level < static_cast<int>(g->levels.size()); ++level) {
    const Level& l = g->levels[std::size_t(level)];
    for (int i = 0; i < 5000; ++i) {
      const dvec3 q = dvec3(u(random), u(random), u(random)) * dvec3(l.bricks * kBrickSize);
      const dvec3 p = (q + 0.5) * std::exp2(level) - 0.5 + dvec3(g->origin);
      const Brick& b = l.at(ivec3(q / double(kBrickSize)));
      const double v = sampleTrilinear(*g, p, level);
      ASSERT_LE(v, static_cast<double>(b.maximum) + 1e-6);
      ASSERT_GE(v, static_cast<double>(b.minimum) - 1e-6);
    }
  }
  for (const Brick& b : g->levels[0].table) EXPECT_LE(b.maximum, g->maximum);
}

TEST(BrickBuilder, MipsConserveTheSum) {
  const ivec3 lo(3, -8, 11), hi(90, 70, 60);
  const auto g = build(sourceOf(bumpy, lo, hi)).grid;
  double want = 0;
  for (int z = lo.z; z <= hi.z; ++z)
    for (int y = lo.y; y <= hi.y; ++y)
      for (int x = lo.x; x <= hi.x; ++x) want += static_cast<double>(bumpy({x, y, z}));
  ASSERT_GE(g->levels.size(), 4u);
  EXPECT_EQ(g->levels.back().bricks, ivec3(1));
  for (int level = 0; level < static_cast<int>(g->levels.size()); ++level) {
    const Level& l = g->levels[std::size_t(level)];
    double sum = 0, bound = 0;
    const double cell = std::exp2(3 * level);
    for (int z = 0; z < l.bricks.z * kBrickSize; ++z)
      for (int y = 0; y < l.bricks.y * kBrickSize; ++y)
        for (int x = 0; x < l.bricks.x * kBrickSize; ++x) {
          const dvec3 p = (dvec3(x, y, z) + 0.5) * std::exp2(level) - 0.5 + dvec3(g->origin);
          sum += sampleTrilinear(*g, p, level) * cell;
          bound += cell * static_cast<double>(l.at(ivec3(x, y, z) / kBrickSize).scale) / 510;
        }
    EXPECT_NEAR(sum, want, bound) << "level " << level;
    EXPECT_NEAR(sum, want, 2e-3 * want) << "level " << level;  // rounding errors mostly cancel
  }
}

TEST(BrickBuilder, ConstantBricksHaveNoPayload) {
  const auto g = build(sourceOf([](ivec3) { return 0.7f; }, ivec3(0), ivec3(99))).grid;
  int constant = 0;
  for (const Brick& b : g->levels[0].table) constant += b.payload == kConstantBrick;
  EXPECT_EQ(constant, 5 * 5 * 5);  // of 7^3: those that no edge of the bounds touches
  EXPECT_EQ(voxelAt(*g, ivec3(50)), 0.7f);
  EXPECT_EQ(sampleTrilinear(*g, dvec3(50.3)), static_cast<double>(0.7f));
  EXPECT_EQ(voxelAt(*g, ivec3(-1)), 0.0f);
  EXPECT_EQ(voxelAt(*g, ivec3(99)), 0.7f);
  EXPECT_EQ(voxelAt(*g, ivec3(100)), 0.0f);
}

TEST(BrickBuilder, NonFiniteVoxelsBecomeZeroAndAreCounted) {
  auto f = [](ivec3 p) {
    if (p == ivec3(4)) return std::nanf("");
    if (p == ivec3(15, 16, 17)) return INFINITY;
    if (p == ivec3(16, 16, 16)) return -INFINITY;
    return 1.0f;
  };
  const BuildResult r = build(sourceOf(f, ivec3(0), ivec3(40)));
  EXPECT_EQ(r.nonFinite, 3u);
  EXPECT_EQ(voxelAt(*r.grid, ivec3(4)), 0.0f);
  EXPECT_EQ(voxelAt(*r.grid, ivec3(15, 16, 17)), 0.0f);
  EXPECT_EQ(voxelAt(*r.grid, ivec3(5)), 1.0f);
  for (const Level& l : r.grid->levels)
    for (const Brick& b : l.table) EXPECT_TRUE(std::isfinite(b.offset) && std::isfinite(b.scale));
}

TEST(BrickBuilder, EmptyAndAllZeroGridsAreEmpty) {
  EXPECT_TRUE(build(sourceOf(bumpy, ivec3(0), ivec3(-1))).grid->empty());
  const auto g = build(sourceOf([](ivec3) { return 0.0f; }, ivec3(0), ivec3(30))).grid;
  EXPECT_TRUE(g->empty());
  EXPECT_EQ(sampleTrilinear(*g, dvec3(3)), 0.0);
  EXPECT_EQ(voxelAt(*g, ivec3(3)), 0.0f);
}

TEST(BrickBuilder, RefusesAbsurdSizesAndSingularTransforms) {
  JobControl control;
  const auto reject = [&](const VoxelSource& s, const char* word) {
    auto r = buildBricks(s, control);
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error().code, Code::Input);
    EXPECT_NE(r.error().message.find(word), std::string::npos) << r.error().message;
  };
  reject(sourceOf(bumpy, ivec3(0), ivec3(70000, 1, 1)), "limit");
  reject(sourceOf(bumpy, ivec3(INT_MIN), ivec3(INT_MAX)), "limit");
  reject(sourceOf(bumpy, ivec3(INT_MAX - 4), ivec3(INT_MAX)), "limit");
  reject(sourceOf(bumpy, ivec3(0), ivec3(60000)), "limit");
  auto s = sourceOf(bumpy, ivec3(0), ivec3(9));
  s.worldFromIndex[1] = dvec4(0);
  reject(s, "singular");
  BuildLimits tight;
  tight.payloadBytes = 20 * kStoredVoxels;
  auto r = buildBricks(sourceOf(bumpy, ivec3(0), ivec3(200)), control, 0, tight);
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, Code::Input);
}

TEST(BrickBuilder, ContentKeyFollowsTheVoxelsAndThreadsDoNotMatter) {
  const auto a = build(sourceOf(bumpy, ivec3(0), ivec3(150, 90, 40))).grid,
             b = build(sourceOf(bumpy, ivec3(0), ivec3(150, 90, 40))).grid;
  EXPECT_EQ(a->content, b->content);
  const auto c =
      build(sourceOf([](ivec3 p) { return p == ivec3(7) ? 9.0f : bumpy(p); }, ivec3(0), ivec3(150, 90, 40)))
          .grid;
  EXPECT_NE(a->content, c->content);
}

TEST(BrickBuilder, CancelStops) {
  JobControl control;
  control.cancel();
  auto r = buildBricks(sourceOf(bumpy, ivec3(0), ivec3(300)), control);
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, Code::Cancelled);
}

}  // namespace
}  // namespace pileus::volume
