// Differences between pictures, against closed forms.
#include "renderer/image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pileus::image {
namespace {

Image constant(ivec2 size, const std::vector<float>& pixel) {
  Image image;
  image.size = size;
  Layer layer{"", static_cast<int>(pixel.size()), {}};
  for (int i = 0; i < size.x * size.y; ++i)
    layer.pixels.insert(layer.pixels.end(), pixel.begin(), pixel.end());
  image.layers = {layer};
  return image;
}

TEST(Metrics, EqualPicturesDoNotDiffer) {
  const Image a = constant({5, 4}, {0.2f, -3.0f, 40.0f, 1.0f});
  const auto d = compare(a, a);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->rmse, 0.0);
  EXPECT_EQ(d->relMse, 0.0);
  EXPECT_EQ(d->maximum, 0.0);
  ASSERT_EQ(d->channels.size(), 4u);
  EXPECT_EQ(d->channels[3].channel, "A");
}

TEST(Metrics, ConstantOffset) {
  const auto d =
      compare(constant({8, 8}, {0.75f, 0.5f, 0.25f, 1.0f}), constant({8, 8}, {0.5f, 0.5f, 0.5f, 0.75f}));
  ASSERT_TRUE(d);
  EXPECT_NEAR(d->rmse, std::sqrt((0.0625 + 0.0 + 0.0625) / 3.0), 1e-12);
  EXPECT_NEAR(d->relMse, (0.0625 + 0.0 + 0.0625) / 3.0 / (0.25 + 0.01), 1e-12);
  EXPECT_DOUBLE_EQ(d->maximum, 0.25);
  EXPECT_DOUBLE_EQ(d->channels[0].rmse, 0.25);
  EXPECT_DOUBLE_EQ(d->channels[0].mean, 0.25);
  EXPECT_DOUBLE_EQ(d->channels[1].maximum, 0.0);
  EXPECT_DOUBLE_EQ(d->channels[3].maximum, 0.25);
}

TEST(Metrics, OnePixelOfMany) {
  const Image b = constant({10, 10}, {1.0f, 1.0f, 1.0f, 1.0f});
  Image a = b;
  a.layers[0].pixels[4 * 37] = 3.0f;
  const auto d = compare(a, b);
  ASSERT_TRUE(d);
  EXPECT_NEAR(d->rmse, std::sqrt(4.0 / 300.0), 1e-12);
  EXPECT_NEAR(d->relMse, 4.0 / 1.01 / 300.0, 1e-12);
  EXPECT_NEAR(d->channels[0].mean, 2.0 / 100.0, 1e-12);
}

TEST(Metrics, ReferenceAlphaMasksRelMseOnly) {
  Image b = constant({2, 1}, {1.0f, 1.0f, 1.0f, 1.0f});
  b.layers[0].pixels[7] = 0.01f;  // the second pixel is not above the threshold
  Image a = b;
  a.layers[0].pixels[4] = 9.0f;
  auto d = compare(a, b);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->relMse, 0.0);
  EXPECT_NEAR(d->rmse, std::sqrt(64.0 / 6.0), 1e-12);
  // Only the reference's alpha counts.
  a.layers[0].pixels[3] = 0.0f;
  a.layers[0].pixels[0] = 2.0f;
  d = compare(a, b);
  EXPECT_NEAR(d->relMse, 1.0 / 1.01 / 3.0, 1e-12);
}

TEST(Metrics, ATransparentReferenceIsNoBlankCheque) {
  const auto d =
      compare(constant({3, 3}, {1.0f, 1.0f, 1.0f, 1.0f}), constant({3, 3}, {0.0f, 0.0f, 0.0f, 0.0f}));
  ASSERT_TRUE(d);
  EXPECT_NEAR(d->relMse, 100.0, 1e-9);
}

TEST(Metrics, NonFiniteValuesAreInfinitelyFar) {
  const Image b = constant({2, 2}, {1.0f, 1.0f, 1.0f, 1.0f});
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    Image a = b;
    a.layers[0].pixels[1] = bad;
    for (const auto& d : {compare(a, b), compare(b, a)}) {
      ASSERT_TRUE(d);
      EXPECT_FALSE(d->relMse <= 1e30);
      EXPECT_FALSE(d->rmse <= 1e30);
    }
    const auto same = compare(a, a);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->relMse, 0.0);
    EXPECT_EQ(same->maximum, 0.0);
  }
}

TEST(Metrics, GreyAndOpaquePicturesCompare) {
  const auto grey = compare(constant({4, 4}, {0.5f}), constant({4, 4}, {1.0f}));
  ASSERT_TRUE(grey);
  EXPECT_NEAR(grey->relMse, 0.25 / 1.01, 1e-12);
  EXPECT_EQ(grey->channels[0].channel, "Y");
  const auto rgb = compare(constant({4, 4}, {0.0f, 0.0f, 0.5f}), constant({4, 4}, {0.0f, 0.0f, 0.0f}));
  ASSERT_TRUE(rgb);
  EXPECT_NEAR(rgb->relMse, 25.0 / 3.0, 1e-9);
}

TEST(Metrics, FurtherLayersCountForTheMaximumOnly) {
  Image a = constant({2, 2}, {1.0f, 1.0f, 1.0f, 1.0f});
  a.layers.push_back({"tau", 1, {1, 1, 1, 1}});
  Image b = a;
  a.layers[1].pixels[2] = 6.0f;
  const auto d = compare(a, b);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->rmse, 0.0);
  EXPECT_DOUBLE_EQ(d->maximum, 5.0);
  EXPECT_EQ(d->channels.back().channel, "tau.Y");
}

TEST(Metrics, MismatchedPicturesAreRefused) {
  const Image a = constant({4, 4}, {1, 1, 1, 1});
  Image moved = a, extra = a;
  moved.dataOrigin = {1, 0};
  extra.layers.push_back({"tau", 1, std::vector<float>(16)});
  for (const Image& b : {constant({4, 5}, {1, 1, 1, 1}), constant({4, 4}, {1, 1, 1}), moved, extra}) {
    for (const auto& d : {compare(a, b), compare(b, a)}) {
      ASSERT_FALSE(d);
      EXPECT_EQ(d.error().code, Code::Input);
    }
  }
}

}  // namespace
}  // namespace pileus::image
