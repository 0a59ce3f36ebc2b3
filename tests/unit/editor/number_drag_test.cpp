// Steps of numbers and the hue of colours.
#include <gtest/gtest.h>

#include <cmath>

#include "editor/toolkit/hsv.h"
#include "editor/toolkit/number_drag.h"

namespace pileus::editor {
namespace {

NumberRange range(double softMin, double softMax, double hardMin, double hardMax) {
  NumberRange r;
  r.softMin = softMin, r.softMax = softMax, r.hardMin = hardMin, r.hardMax = hardMax;
  return r;
}

TEST(NumberSteps, GoByRoundSteps) {
  const NumberRange r = range(0, 10, 0, 100);
  EXPECT_EQ(steppedValue(2, 1, r, false), 2.2);
  EXPECT_EQ(steppedValue(2, -1, r, false), 1.8);
  EXPECT_EQ(steppedValue(2, 1, r, true), 2.02);
  EXPECT_EQ(steppedValue(10, 1, r, false), 10) << "the soft range stops them";
  EXPECT_EQ(steppedValue(55, 1, r, false), 55);
  EXPECT_LT(steppedValue(55, -1, r, false), 55)
      << "a value typed beyond the soft range is not pulled back, but may come";
  EXPECT_GT(steppedValue(55, -1, r, false), 54);
}

TEST(NumberSteps, IntegersByOneAndRatiosByTenPerCent) {
  NumberRange whole = range(0, 0, 1, 32);
  whole.integer = true;
  EXPECT_EQ(steppedValue(8, 1, whole, false), 9);
  EXPECT_EQ(steppedValue(1, -1, whole, false), 1);
  EXPECT_EQ(steppedValue(32, 5, whole, false), 32);
  NumberRange ratio = range(0.01, 100, 0, 1e6);
  ratio.logarithmic = true;
  EXPECT_EQ(steppedValue(1, 1, ratio, false), 1.1);
  EXPECT_EQ(steppedValue(100, 1, ratio, false), 100);
  EXPECT_EQ(steppedValue(0.01, -1, ratio, false), 0.01);
}

TEST(NumberSteps, ShareOfTheSoftRange) {
  EXPECT_EQ(softShare(5, range(0, 10, 0, 100)), 0.5);
  EXPECT_EQ(softShare(50, range(0, 10, 0, 100)), 1);
  EXPECT_EQ(softShare(5, range(0, 0, 0, 100)), 0) << "without a soft range there is no fill";
  NumberRange ratio = range(0.01, 100, 0, 1e6);
  ratio.logarithmic = true;
  EXPECT_NEAR(softShare(1, ratio), 0.5, 1e-12);
  EXPECT_EQ(softShare(0, ratio), 0);
}

TEST(NumberFields, NothingIsBehindTheNumber) {
  for (const float scale : {0.75f, 1.0f, 1.25f, 1.5f, 2.0f, 2.5f}) {
    const float font = std::round(16 * scale), height = font + 2 * std::round(5 * scale);
    const FieldRows rows = fieldRows(height, font, scale);
    EXPECT_GE(rows.text, 0) << scale;
    EXPECT_GE(rows.barTop, rows.text + font) << "the bar is below the text at " << scale;
    EXPECT_GE(rows.barEnd - rows.barTop, 2) << "and can be seen";
    EXPECT_EQ(rows.barEnd, height);
  }
}

TEST(Hsv, ThereAndBackWithoutLimit) {
  for (const dvec3& c :
       {dvec3(1, 0, 0), dvec3(0.2, 0.9, 0.4), dvec3(12, 3, 7), dvec3(0.5, 0.5, 0.1), dvec3(0, 0, 3)}) {
    const dvec3 back = rgbOf(hsvOf(c));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], c[i], 1e-12);
  }
  EXPECT_NEAR(hsvOf({0, 1, 0}).hue, 1.0 / 3, 1e-12);
  EXPECT_EQ(hsvOf({12, 3, 7}).value, 12);
}

TEST(Hsv, GreyKeepsTheHueItHad) {
  const Hsv blue = hsvOf({0, 0, 1});
  const Hsv grey = hsvOf({0.5, 0.5, 0.5}, blue);
  EXPECT_EQ(grey.hue, blue.hue);
  EXPECT_EQ(grey.saturation, 0);
  const Hsv black = hsvOf({0, 0, 0}, blue);
  EXPECT_EQ(black.hue, blue.hue);
  EXPECT_EQ(black.saturation, 1);
}

}  // namespace
}  // namespace pileus::editor
