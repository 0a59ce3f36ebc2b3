// Differences between pictures, against closed forms.
#include "renderer/image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

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

/// A picture of one colour with an error of its own at each pixel, `d` of it up or down, and noise in the
/// halves; what `blocks` is true for is the same in each 2 x 2 pixels.
struct Noisy {
  Image a, b1, b2;
};
Noisy noisy(std::mt19937& random, ivec2 size, double d, double noise, bool blocks) {
  std::normal_distribution<double> normal;
  std::bernoulli_distribution up;
  Noisy out{constant(size, {1, 1, 1, 1}), constant(size, {1, 1, 1, 1}), constant(size, {1, 1, 1, 1})};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto at = static_cast<std::size_t>(y * size.x + x) * 4;
      const bool copied = blocks && (x % 2 == 1 || y % 2 == 1);
      const auto from = static_cast<std::size_t>(y / 2 * 2 * size.x + x / 2 * 2) * 4;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto put = [&](Image& image, double value) {
          std::vector<float>& p = image.layers[0].pixels;
          p[at + c] = copied ? p[from + c] : static_cast<float>(value);
        };
        put(out.a, up(random) ? 1 + d : 1 - d);
        put(out.b1, 1 + noise * normal(random));
        put(out.b2, 1 + noise * normal(random));
      }
    }
  return out;
}

TEST(ScaledRelMse, ClosedCases) {
  const Image b = constant({8, 8}, {0.5f, 0.25f, 0.75f, 1}), a = constant({8, 8}, {0.75f, 0.25f, 0.75f, 1});
  const double m = 0.5;  // over all channels
  auto s = scaledRelMse(a, b, b);
  ASSERT_TRUE(s) << s.error().message;
  EXPECT_NEAR(s->value, 0.0625 / (0.25 + 0.01 * m * m) / 3, 1e-12);
  EXPECT_NEAR(s->standardError, 0, 1e-12) << "every block is the same";
  EXPECT_NEAR(s->ratio, (0.75 + 0.25 + 0.75) / 1.5, 1e-12);
  EXPECT_EQ(s->pixels, 64u);
  // Halves on either side of the picture: the product is below 0.
  const auto between = scaledRelMse(constant({8, 8}, {1, 1, 1, 1}), constant({8, 8}, {1.5f, 1.5f, 1.5f, 1}),
                                    constant({8, 8}, {0.5f, 0.5f, 0.5f, 1}));
  EXPECT_NEAR(between->value, -0.25 / 1.01, 1e-12);
  EXPECT_EQ(between->ratio, 1);
  // Twice as bright: the same.
  const auto brighter =
      scaledRelMse(constant({8, 8}, {1.5f, 0.5f, 1.5f, 1}), constant({8, 8}, {1, 0.5f, 1.5f, 1}),
                   constant({8, 8}, {1, 0.5f, 1.5f, 1}));
  EXPECT_NEAR(brighter->value, s->value, 1e-12);
}

TEST(ScaledRelMse, AlphaOfThePictureDecidesWhatCounts) {
  const Image b = constant({4, 1}, {1, 1, 1, 0});
  Image a = constant({4, 1}, {1, 1, 1, 1});
  a.layers[0].pixels[7] = 0.01f, a.layers[0].pixels[4] = 9;  // not above the bound
  auto s = scaledRelMse(a, b, b);
  ASSERT_TRUE(s);
  EXPECT_EQ(s->pixels, 3u);
  EXPECT_EQ(s->value, 0);
  EXPECT_EQ(s->ratio, 1);
  // One block: from the spread of its pixels. One of three is off by 2 in one channel of three.
  a.layers[0].pixels[0] = 3;
  s = scaledRelMse(a, b, b);
  const double term = 4 / 1.01 / 3, mean = term / 3;
  EXPECT_NEAR(s->value, mean, 1e-12);
  EXPECT_NEAR(s->standardError, std::sqrt(3.0 / 2 * ((term - mean) * (term - mean) + 2 * mean * mean)) / 3,
              1e-12);
  EXPECT_TRUE(std::isinf(scaledRelMse(constant({1, 1}, {1, 1, 1, 1}), constant({1, 1}, {1, 1, 1, 1}),
                                      constant({1, 1}, {1, 1, 1, 1}))
                             ->standardError));
  // Without alpha all of them count; black on black is no error.
  const Image grey = constant({3, 2}, {0.0f});
  s = scaledRelMse(grey, grey, grey);
  EXPECT_EQ(s->pixels, 6u);
  EXPECT_EQ(s->value, 0);
  EXPECT_EQ(s->ratio, 1);
}

TEST(ScaledRelMse, WhatCannotBeMeasuredIsRefused) {
  const Image a = constant({4, 4}, {1, 1, 1, 1}), none = constant({4, 4}, {1, 1, 1, 0.01f});
  Image moved = a;
  moved.dataOrigin = {1, 0};
  for (const Image& b : {constant({4, 5}, {1, 1, 1, 1}), constant({4, 4}, {1}), moved})
    for (const auto& s : {scaledRelMse(a, b, a), scaledRelMse(a, a, b), scaledRelMse(b, a, a)}) {
      ASSERT_FALSE(s);
      EXPECT_EQ(s.error().code, Code::Input);
    }
  EXPECT_FALSE(scaledRelMse(none, a, a));
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()})
    for (const std::size_t at : {17u, 19u}) {  // a colour and an alpha
      Image broken = a;
      broken.layers[0].pixels[at] = bad;
      const auto s = scaledRelMse(broken, a, a);
      ASSERT_TRUE(s);
      EXPECT_FALSE(s->value <= 1e30);
    }
}

// Errors of 10 % and halves with 1 % of noise: compared with one half, 1e-4 would be added to 1e-2; with the
// mean of both, 0.5e-4. The product has neither.
TEST(ScaledRelMse, NoiseDropsOutOfTheMean) {
  std::mt19937 random(1);
  const double right = 0.01 / 1.01;
  double sum = 0, variance = 0, naive = 0;
  constexpr int kPictures = 40;
  for (int i = 0; i < kPictures; ++i) {
    const Noisy n = noisy(random, {48, 48}, 0.1, 0.01, false);
    const auto s = scaledRelMse(n.a, n.b1, n.b2), same = scaledRelMse(n.a, n.b1, n.b1);
    ASSERT_TRUE(s);
    sum += s->value / kPictures, naive += same->value / kPictures;
    variance += s->standardError * s->standardError / (kPictures * kPictures);
  }
  const double error = std::sqrt(variance);
  std::printf("  %.7f +- %.7f, right %.7f; with one half twice %.7f\n", sum, error, right, naive);
  EXPECT_NEAR(sum, right, 4 * error);
  EXPECT_LT(4 * error, 0.25e-4) << "fine enough to tell";
  EXPECT_GT(naive, right + 0.5e-4);
}

// How often the right value lies within one and two standard errors, also where neighbours share their noise.
TEST(ScaledRelMse, TheStandardErrorIsOne) {
  for (const bool blocks : {false, true}) {
    std::mt19937 random(2);
    const double right = 0.01 / 1.01;
    int within1 = 0, within2 = 0;
    constexpr int kPictures = 400;
    double squares = 0;
    for (int i = 0; i < kPictures; ++i) {
      const Noisy n = noisy(random, {32, 32}, 0.1, 0.03, blocks);
      const auto s = scaledRelMse(n.a, n.b1, n.b2);
      const double off = (s->value - right) / s->standardError;
      within1 += std::abs(off) < 1 ? 1 : 0, within2 += std::abs(off) < 2 ? 1 : 0;
      squares += off * off / kPictures;
    }
    std::printf("  %s: %d and %d of %d within 1 and 2, root mean square %.3f\n",
                blocks ? "shared by 2 x 2" : "each its own", within1, within2, kPictures, std::sqrt(squares));
    // 68.3 and 95.4 %, four standard deviations of a count; 64 blocks are a t distribution, all but normal.
    EXPECT_NEAR(within1, 0.683 * kPictures, 4 * std::sqrt(0.683 * 0.317 * kPictures));
    EXPECT_NEAR(within2, 0.954 * kPictures, 4 * std::sqrt(0.954 * 0.046 * kPictures));
    EXPECT_NEAR(std::sqrt(squares), 1, 0.15);
  }
}

TEST(BlocksOf, AreMeansAndLeaveOutWhatIsLeft) {
  Image picture;
  picture.size = {5, 4};
  picture.layers = {{"", 3, {}}, {"more", 1, std::vector<float>(20, 7)}};
  for (int i = 0; i < 5 * 4 * 3; ++i) picture.layers[0].pixels.push_back(float(i % 15 / 3 + i % 3));
  const Image blocks = blocksOf(picture, 2);
  EXPECT_EQ(blocks.size, ivec2(2, 2));
  ASSERT_EQ(blocks.layers.size(), 1u);
  EXPECT_EQ(blocks.layers[0].pixels,
            (std::vector<float>{0.5f, 1.5f, 2.5f, 2.5f, 3.5f, 4.5f, 0.5f, 1.5f, 2.5f, 2.5f, 3.5f, 4.5f}));
}

}  // namespace
}  // namespace pileus::image
