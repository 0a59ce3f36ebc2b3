// PNG files: code values, the dither, refusals; read back through stb_image.
#include "renderer/image/png.h"

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <cmath>
#include <memory>

#include "tests/support/support.h"

namespace pileus::image {
namespace {

struct Png {
  int width = 0, height = 0, channels = 0;
  std::vector<unsigned char> bytes;
};

Png load(const std::filesystem::path& path) {
  Png png;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> data(
      stbi_load(path.c_str(), &png.width, &png.height, &png.channels, 0), &stbi_image_free);
  if (data) png.bytes.assign(data.get(), data.get() + png.width * png.height * png.channels);
  return png;
}

std::vector<float> flat(ivec2 size, float value) {
  return std::vector<float>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4, value);
}

TEST(Png, CodeValuesAreExact) {
  const ivec2 size(256, 8);
  std::vector<float> rgba;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (const int code : {x, 255 - x, (x * 7) % 256, 17})
        rgba.push_back(static_cast<float>(code) / 255.0f);
  const auto path = test::scratchFolder() / "codes.png";
  const auto written = writePng(path, size, rgba.data());
  ASSERT_TRUE(written) << written.error().message;
  const Png png = load(path);
  ASSERT_EQ(png.width, 256);
  ASSERT_EQ(png.height, 8);
  ASSERT_EQ(png.channels, 3);
  for (std::size_t y = 0, i = 0; y < 8; ++y)
    for (unsigned x = 0; x < 256; ++x)
      for (const unsigned code : {x, 255 - x, (x * 7) % 256})
        ASSERT_EQ(png.bytes[i++], code) << x << ' ' << y;
}

TEST(Png, TheDitherKeepsTheMean) {
  const ivec2 size(16, 16);
  const auto path = test::scratchFolder() / "dither.png";
  for (const double code : {0.25, 100.5, 200.125, 254.75}) {
    ASSERT_TRUE(writePng(path, size, flat(size, static_cast<float>(code / 255.0)).data()));
    double sum = 0;
    for (const unsigned char byte : load(path).bytes) {
      ASSERT_LE(std::abs(byte - code), 1.0);
      sum += byte;
    }
    EXPECT_NEAR(sum / (16 * 16 * 3), code, 1.0 / 64.0) << code;
  }
}

TEST(Png, ClampsEverythingElse) {
  const ivec2 size(8, 8);
  const auto path = test::scratchFolder() / "clamp.png";
  for (const auto& [value, code] :
       {std::pair(-1.0f, 0), {1.5f, 255}, {1e30f, 255}, {INFINITY, 255}, {-INFINITY, 0}, {NAN, 0}}) {
    ASSERT_TRUE(writePng(path, size, flat(size, value).data()));
    for (const unsigned char byte : load(path).bytes) ASSERT_EQ(byte, code) << value;
  }
}

TEST(Png, RefusesBadTargetsAndSizes) {
  const auto path = test::scratchFolder() / "none" / "a.png";
  const auto written = writePng(path, {2, 2}, flat({2, 2}, 0.5f).data());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, Code::Input);
  EXPECT_NE(written.error().message.find(path.string()), std::string::npos);
  EXPECT_FALSE(writePng(path, {0, 2}, nullptr));
  EXPECT_FALSE(writePng(path, {1 << 20, 1 << 20}, nullptr));
}

}  // namespace
}  // namespace pileus::image
