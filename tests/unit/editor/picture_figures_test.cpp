// What the viewport says about a picture in numbers, and how large its drafts are.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "editor/picture/draft_pace.h"
#include "editor/viewport/pixel_probe.h"
#include "renderer/view/picture_scan.h"

namespace pileus::editor {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

/// Drafts of a renderer that draws `perMs` pixels a millisecond after `maps` ms at 128 texels.
int paced(DraftPace& pace, double perMs, double maps, double target, int whole, int drafts) {
  int pixels = 0;
  for (int i = 0; i < drafts; ++i) {
    pixels = std::min(pace.pixels(), whole);
    const double picture = pixels / perMs, made = maps * pace.texels() * pace.texels() / (128.0 * 128.0);
    pace.learn({picture + made + 2, picture, made}, pixels, target);
  }
  return pixels;
}

TEST(DraftPace, FindsTheSizeThatTakesTheTarget) {
  for (const double perMs : {100.0, 400.0, 5000.0}) {
    DraftPace pace(true);
    const int pixels = paced(pace, perMs, 0, 60, 500000, 12);
    EXPECT_NEAR(pixels / perMs, std::min(58.0, 500000 / perMs), 8) << perMs;
  }
}

TEST(DraftPace, SlowMapsAreMadeSmallerAndFastOnesLarger) {
  DraftPace slow(true), fast(true);
  paced(slow, 1000, 200, 60, 500000, 10);
  EXPECT_LT(slow.texels(), 128);
  EXPECT_GE(slow.texels(), DraftPace::kLeastTexels);
  paced(fast, 1000, 1, 60, 500000, 10);
  EXPECT_EQ(fast.texels(), 256);
}

TEST(DraftPace, OneSlowDraftDoesNotEndInASpeck) {
  DraftPace pace(true);
  paced(pace, 500, 0, 60, 500000, 10);
  const int before = pace.pixels();
  pace.learn({5000, 5000, 0}, before, 60);
  EXPECT_GT(pace.pixels(), before / 4);
}

TEST(PixelFigures, AreWordsWhereThereIsNoNumber) {
  EXPECT_EQ(figureText(0.18f), "0.1800");
  EXPECT_EQ(figureText(0), "0");
  EXPECT_EQ(figureText(kNan), "nan");
  EXPECT_EQ(figureText(-kInf), "-inf");
  EXPECT_EQ(figureText(1e-6f), "1.00e-06");
  EXPECT_EQ(stopsText(0.36f), "+1.00 stops");
  EXPECT_EQ(stopsText(0), "no light");
  EXPECT_EQ(stopsText(kNan), "no stops");
}

TEST(PixelFigures, OfAnAreaLeaveOutWhatIsNotFinite) {
  const vec4 texels[] = {{1, 2, 3, 1}, {3, kNan, 5, 0}, {kInf, 4, 1, 0.5f}};
  const TexelFigures f = texelFigures(texels);
  EXPECT_EQ(f.nan, 1u);
  EXPECT_EQ(f.inf, 1u);
  EXPECT_EQ(f.min, vec4(1, 2, 1, 0));
  EXPECT_EQ(f.max, vec4(3, 4, 5, 1));
  EXPECT_EQ(f.mean, vec4(2, 3, 3, 0.5f));
}

TEST(PictureScan, CountsStopsAndFindsTheRangeOfDepth) {
  std::vector<vec4> texels(100, vec4(0.18f, 0.18f, 0.18f, 1));
  texels[0] = vec4(0);
  texels[1] = vec4(kNan);
  const view::ScanResult r = view::scanTexels(texels);
  EXPECT_EQ(r.notFinite, 1u);
  int peak = 0;
  for (int i = 0; i < view::Histogram::kBins; ++i)
    if (r.histogram.parts[3][static_cast<std::size_t>(i)] > 0.9f) peak = i;
  EXPECT_NEAR(view::Histogram::stopOf(peak), 0, 0.2);
  EXPECT_NEAR(r.histogram.black, 0.01f, 1e-4f);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = vec4(vec3(static_cast<float>(10 + i)), i < 50 ? 1.0f : 0.0f);
  const vec2 depth = view::scanTexels(texels).depth;
  EXPECT_NEAR(depth.x, 10, 1.5);
  EXPECT_NEAR(depth.y, 59, 1.5) << "what covers nothing has no depth";
}

}  // namespace
}  // namespace pileus::editor
