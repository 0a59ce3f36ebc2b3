// How regions follow the time they take: fed with times, without a GPU.
#include "renderer/gl/region_cursor.h"

#include <gtest/gtest.h>

#include <vector>

namespace pileus::gl {
namespace {

DeviceInfo device(bool software) {
  DeviceInfo info;
  info.software = software;
  return info;
}

int pixels(const RegionCursor& c) {
  const ivec2 size = c.end() - c.origin();
  return size.x * size.y;
}

/// Walks all of it; `time` of a region by its pixels. How often each pixel came, and the most at once.
template <class Time>
int walk(RegionCursor cursor, ivec2 size, const Time& time, ivec2 at = ivec2(0)) {
  std::vector<int> seen(std::size_t(size.x * size.y), 0);
  int most = 0;
  double last = -1;
  for (; !cursor.done(); cursor.advance(time(pixels(cursor)))) {
    EXPECT_GT(cursor.fraction(), last);
    last = cursor.fraction();
    const ivec2 lo = cursor.origin() - at, hi = cursor.end() - at;
    EXPECT_TRUE(lo.x >= 0 && lo.y >= 0 && hi.x <= size.x && hi.y <= size.y && lo.x < hi.x && lo.y < hi.y);
    for (int y = lo.y; y < hi.y; ++y)
      for (int x = lo.x; x < hi.x; ++x) ++seen[std::size_t(y * size.x + x)];
    most = std::max(most, (hi.x - lo.x) * (hi.y - lo.y));
  }
  for (const int n : seen) EXPECT_EQ(n, 1);
  EXPECT_EQ(cursor.fraction(), 1);
  return most;
}

TEST(Pace, GrowsWhileThereIsTimeAndShrinksWhenItIsLong) {
  Pace p{8, 1, 512};
  p.took(2);
  EXPECT_EQ(p.now, 16);
  p.took(15);
  EXPECT_EQ(p.now, 16) << "neither well below the wanted time nor long";
  p.took(90);
  EXPECT_EQ(p.now, 16);
  p.took(150);
  EXPECT_EQ(p.now, 8);
  p.took(5000);
  EXPECT_EQ(p.now, 2);
  p.took(5000);
  p.took(5000);
  EXPECT_EQ(p.now, 1) << "the least";
  for (int i = 0; i < 40; ++i) p.took(0);
  EXPECT_EQ(p.now, 512) << "the most";
}

TEST(RegionCursor, BeginsWithOneTileWhateverTheDevice) {
  for (const bool software : {true, false}) {
    const RegionCursor c(ivec2(1000, 700), device(software));
    EXPECT_EQ(c.origin(), ivec2(0));
    EXPECT_EQ(c.end(), ivec2(RegionCursor::kTile));
  }
}

TEST(RegionCursor, EveryPixelComesOnceHoweverLongRegionsTake) {
  for (const ivec2 size : {ivec2(1000, 700), ivec2(64, 64), ivec2(65, 1), ivec2(1, 300), ivec2(2000, 40)})
    for (const double nsPerPixel : {1.0, 300.0, 3000.0, 30000.0, 1e6})
      for (const ivec2 at : {ivec2(0), ivec2(13, 7)}) {
        const auto ms = [&](int n) { return 1e-6 * nsPerPixel * n; };
        walk(RegionCursor(size, device(false), 1, at), size, ms, at);
        walk(RegionCursor(size, device(true), 1, at), size, ms, at);
      }
}

TEST(RegionCursor, NoRegionOfEvenCostTakesLong) {
  const ivec2 size(1920, 1080);
  for (const double nsPerPixel : {1.0, 300.0, 3000.0, 30000.0}) {
    double longest = 0;
    int regions = 0;
    walk(RegionCursor(size, device(false)), size, [&](int n) {
      const double ms = 1e-6 * nsPerPixel * n;
      if (++regions > 2) longest = std::max(longest, ms);
      return ms;
    });
    EXPECT_LE(longest, Pace::kLongMs) << nsPerPixel;
    // And none is so small that the GPU has nothing to do.
    EXPECT_LE(regions, 20 + 1e-6 * nsPerPixel * size.x * size.y / (Pace::kWantedMs / 8) +
                           2.0 * size.x * size.y /
                               (RegionCursor::kTile * RegionCursor::kTile * RegionCursor::kMostTiles) * 8);
  }
}

TEST(RegionCursor, FastRegionsGrowToTheLargest) {
  const ivec2 size(2048, 2048);
  const int most = walk(RegionCursor(size, device(false)), size, [](int) { return 0.1; });
  EXPECT_EQ(most, RegionCursor::kMostTiles * RegionCursor::kTile * RegionCursor::kTile);
}

TEST(RegionCursor, ACpuKeepsToItsTiles) {
  const ivec2 size(640, 256);
  for (const double ms : {0.0, 1e6}) {
    RegionCursor c(size, device(true));
    for (int i = 0; !c.done(); ++i, c.advance(ms)) {
      EXPECT_EQ(c.origin(), 64 * ivec2(i % 10, i / 10));
      EXPECT_EQ(pixels(c), 64 * 64);
    }
  }
  RegionCursor wide(size, device(true), 16);
  EXPECT_EQ(wide.end(), ivec2(640, 64));
}

TEST(RegionCursor, ASampleBeginsAtThePaceOfTheLast) {
  RegionCursor c(ivec2(1024, 1024), device(false));
  while (!c.done()) c.advance(1);
  c.restart();
  EXPECT_EQ(c.origin(), ivec2(0));
  EXPECT_EQ(c.fraction(), 0);
  EXPECT_EQ(pixels(c), RegionCursor::kMostTiles * 64 * 64);
  c.finish();
  EXPECT_TRUE(c.done());
}

}  // namespace
}  // namespace pileus::gl
