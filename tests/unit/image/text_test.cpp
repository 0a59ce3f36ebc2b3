// Text in pictures: where it lands, how wide it is, and that it is cut at the edges.
#include "renderer/image/text.h"

#include <gtest/gtest.h>

namespace pileus::image {
namespace {

/// Bounds [x0, y0, x1, y1) of what differs from the background; empty: x0 > x1.
struct Ink {
  ivec2 lo{1 << 20}, hi{-1};
};
Ink inkOf(const Canvas& c, float background) {
  Ink ink;
  for (int y = 0; y < c.size.y; ++y)
    for (int x = 0; x < c.size.x; ++x)
      if (c.rgba[std::size_t((y * c.size.x + x) * 4)] != background) {
        ink.lo = glm::min(ink.lo, ivec2(x, y));
        ink.hi = glm::max(ink.hi, ivec2(x + 1, y + 1));
      }
  return ink;
}

TEST(Text, StandsOnItsBaseline) {
  for (const Face face : {Face::Regular, Face::Bold, Face::Mono}) {
    Canvas canvas({200, 60}, vec3(0.1f));
    drawText(canvas, {20, 40}, face, 24, vec3(0.9f), "HEX");
    const Ink ink = inkOf(canvas, 0.1f);
    EXPECT_NEAR(ink.lo.x, 22, 3);
    EXPECT_NEAR(ink.hi.x, 20 + textWidth(face, 24, "HEX"), 3);
    EXPECT_NEAR(ink.hi.y, 40, 1) << "capitals have no descenders";
    EXPECT_NEAR(ink.hi.y - ink.lo.y, 0.73 * 24, 2) << "cap height";
  }
}

TEST(Text, WidthsAddUpAndScale) {
  const double one = textWidth(Face::Mono, 10, "0");
  EXPECT_NEAR(one, 6, 0.01) << "JetBrains Mono is 600 units of 1000 wide";
  EXPECT_NEAR(textWidth(Face::Mono, 10, "0.0123 ms"), 9 * one, 1e-4);
  EXPECT_NEAR(textWidth(Face::Regular, 30, "Fourier"), 3 * textWidth(Face::Regular, 10, "Fourier"), 1e-3);
  EXPECT_LT(textWidth(Face::Regular, 10, "iiii"), textWidth(Face::Regular, 10, "MMMM"));
  EXPECT_EQ(textWidth(Face::Regular, 10, ""), 0);
  EXPECT_NEAR(textWidth(Face::Mono, 10, "\u00b1\u2212"), 2 * one, 1e-4) << "two characters, five bytes";
}

TEST(Text, IsCutAtTheEdgesAndShortenedToFit) {
  Canvas canvas({30, 12}, vec3(0));
  drawText(canvas, {-20, 10}, Face::Bold, 40, vec3(1), "A wide text that leaves the picture on all sides");
  EXPECT_GT(inkOf(canvas, 0).hi.x, 0);
  EXPECT_EQ(fitText(Face::Regular, 12, "short", 100), "short");
  const std::string cut = fitText(Face::Regular, 12, "A rather l\u00f6ng name of a representation", 80);
  EXPECT_LE(textWidth(Face::Regular, 12, cut), 80);
  EXPECT_EQ(cut.substr(cut.size() - 3), "\u2026");
  EXPECT_EQ(cut.substr(0, 8), "A rather");
}

TEST(Text, InvalidUtf8IsDrawnAndEnds) {
  Canvas canvas({60, 20}, vec3(0));
  drawText(canvas, {2, 15}, Face::Mono, 12, vec3(1), "a\xC3");
  drawText(canvas, {2, 15}, Face::Mono, 12, vec3(1), "\xF0\x9F");
  EXPECT_GE(textWidth(Face::Mono, 12, "\xFF\xFE"), 0);
}

}  // namespace
}  // namespace pileus::image
