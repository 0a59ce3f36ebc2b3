// Maps of light from everywhere, read from files: formats, colours, windows, and what is refused.
#include "renderer/image/environment_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus::image {
namespace {

namespace fs = std::filesystem;

const Chromaticities kRec709{{0.64f, 0.33f}, {0.30f, 0.60f}, {0.15f, 0.06f}, {0.3127f, 0.3290f}};

fs::path written(const Image& image) {
  const fs::path path = test::scratchFolder() / "map.exr";
  EXPECT_TRUE(writeExr(path, image, {PixelType::Float, Compression::Zip}));
  return path;
}

Image picture(ivec2 size, int channels = 3) {
  Image out;
  out.size = size;
  out.chromaticities = kRec709;
  out.layers = {{"", channels, {}}};
  for (int i = 0; i < size.x * size.y * channels; ++i) out.layers[0].pixels.push_back(float(i % 97) * 0.25f);
  return out;
}

fs::path writtenText(const std::string& content) {
  const fs::path path = test::scratchFolder() / "map.hdr";
  EXPECT_TRUE(writeFileAtomic(path, content));
  return path;
}

std::string reasonOf(const fs::path& path) {
  const auto read = decodeEnvironment(path);
  if (read) return "(it was read)";
  EXPECT_EQ(read.error().code, Code::Input);
  EXPECT_EQ(read.error().message.find(path.string()), 0u) << read.error().message;
  return read.error().message;
}

#define EXPECT_REASON(path, text) EXPECT_NE(reasonOf(path).find(text), std::string::npos) << reasonOf(path)

const std::string kHead = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n";
std::string bytes(std::initializer_list<int> values) {
  std::string out;
  for (const int v : values) out += char(v);
  return out;
}
/// 10 x 2 pixels in runs: reds rise, greens are a run, blues 7, exponent 1.
std::string runs() {
  std::string out = kHead + "\n-Y 2 +X 10\n";
  for (int y = 0; y < 2; ++y)
    out += bytes({2, 2, 0, 10}) + bytes({10, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100}) +
           bytes({128 + 10, 50 + y}) + bytes({128 + 5, 7, 5, 7, 7, 7, 7, 7}) + bytes({128 + 10, 136});
  return out;
}

TEST(EnvironmentFile, TheDataWindowIsTheMap) {
  Image image = picture({12, 6}, 4);
  image.dataOrigin = {-3, 5};
  image.displaySize = {100, 80};
  const auto read = decodeEnvironment(written(image));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->map.size, ivec2(12, 6));
  EXPECT_TRUE(read->warnings.empty());
  for (std::size_t i = 0; i < 72; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_EQ(read->map.radiance[i][int(c)], image.layers[0].pixels[4 * i + c]);
}

TEST(EnvironmentFile, ColoursAreLinearRec709UnlessNamed) {
  const auto config = ColorConfig::shipped();
  ASSERT_TRUE(config);
  scene::EnvironmentMap map{{2, 2}, {vec3(1), vec3(1, 0, 0), vec3(0, 0, 2), vec3(0)}};
  scene::EnvironmentMap same = map, named = map;
  ASSERT_TRUE(toWorkingSpace(map, "", **config));
  // The primaries of Rec. 709 in ACEScg, adapted by Bradford's matrix: SMPTE RP 177, S-2014-004.
  const vec3 red(0.6131f, 0.0702f, 0.0206f), blue(0.0474f, 0.0134f, 0.8696f);
  EXPECT_LT(glm::length(map.radiance[0] - vec3(1)), 1e-3f);
  EXPECT_LT(glm::length(map.radiance[1] - red), 1e-3f);
  EXPECT_LT(glm::length(map.radiance[2] - 2.0f * blue), 1e-3f);
  ASSERT_TRUE(toWorkingSpace(named, "Linear Rec.709 (sRGB)", **config));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(glm::length(named.radiance[i] - map.radiance[i]), 1e-5f);
  ASSERT_TRUE(toWorkingSpace(same, "ACEScg", **config));
  EXPECT_LT(glm::length(same.radiance[1] - vec3(1, 0, 0)), 1e-6f);
  const auto unknown = toWorkingSpace(same, "nowhere", **config);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, Code::Arguments);
  EXPECT_NE(unknown.error().message.find("'ACEScg'"), std::string::npos);
}

TEST(EnvironmentFile, WhatIsNoRadianceIsCutAndCounted) {
  const auto config = ColorConfig::shipped();
  Image image = picture({4, 2});
  EnvironmentFile file{{{4, 2}, std::vector<vec3>(8, vec3(1))}};
  file.map.radiance[1] = vec3(-5);
  image.chromaticities = Chromaticities();
  const auto plain = decodeEnvironment(written(image));
  ASSERT_TRUE(plain && plain->primaries);
  file.primaries = plain->primaries;
  file.warnings = {"before"};
  std::vector<std::string> warnings;
  const auto map = environmentFrom(file, "", **config, warnings);
  ASSERT_TRUE(map);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(warnings[0], "before");
  EXPECT_NE(warnings[1].find("ACEScg"), std::string::npos);
  EXPECT_NE(warnings[2].find("1 pixels have negative values"), std::string::npos);
  EXPECT_EQ(map->radiance[1], vec3(0));
}

TEST(EnvironmentFile, SmallAndOddSizes) {
  for (const ivec2 size : {ivec2(1, 1), ivec2(2, 1), ivec2(7, 5)}) {
    const auto read = decodeEnvironment(written(picture(size)));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->map.size, size);
  }
  const auto square = decodeEnvironment(written(picture({64, 64})));
  ASSERT_TRUE(square);
  ASSERT_EQ(square->warnings.size(), 1u);
  EXPECT_NE(square->warnings[0].find("64 x 64"), std::string::npos);
  const auto one = decodeEnvironment(writtenText(kHead + "\n-Y 1 +X 1\n" + bytes({128, 64, 32, 129})));
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(one->map.radiance[0], vec3(1, 0.5f, 0.25f));
}

TEST(EnvironmentFile, RadianceRunsAndPixels) {
  const auto read = decodeHdr(runs());
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->map.size, ivec2(10, 2));
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 10; ++x)
      EXPECT_EQ(read->map.at(x, y), vec3(float(10 * x + 10), float(50 + y), 7)) << x;
  // Exposures are taken back out.
  std::string exposed = runs();
  exposed.insert(exposed.find("FORMAT"), "EXPOSURE=2\nEXPOSURE= 4\n");
  const auto out = decodeHdr(exposed);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->map.at(9, 1), vec3(100, 51, 7) / 8.0f);
  // Pixels as they are, the older way to repeat them, and no light where the exponent is 0.
  const auto old =
      decodeHdr(kHead + "\n-Y 1 +X 300\n" + bytes({1, 2, 3, 136, 1, 1, 1, 42, 1, 1, 1, 1, 9, 9, 9, 0}));
  ASSERT_TRUE(old) << old.error().message;
  EXPECT_EQ(old->map.at(298, 0), vec3(1, 2, 3));
  EXPECT_EQ(old->map.at(299, 0), vec3(0));
}

TEST(EnvironmentFile, ARadianceFileThatIsCutOffAnywhereIsAnError) {
  const std::string whole = runs();
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_FALSE(decodeHdr(std::string_view(whole).substr(0, n))) << n;
}

TEST(EnvironmentFile, WhatCannotBeReadSaysWhy) {
  EXPECT_REASON(test::scratchFolder() / "none.exr", "there is no such file");
  EXPECT_REASON(test::scratchFolder(), "is not a file");
  EXPECT_REASON(writtenText(""), "neither an OpenEXR nor a Radiance");
  EXPECT_REASON(writtenText("\x76\x2f\x31\x01"), "not a readable EXR");
  EXPECT_REASON(writtenText("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234"), "XYZ");
  EXPECT_REASON(writtenText(kHead + "\n+Y 1 +X 1\n1234"), "turned or mirrored");
  EXPECT_REASON(writtenText(kHead + "\n-Y 0 +X 0\n"), "no pixels");
  EXPECT_REASON(writtenText(kHead + "\n-Y 16000 +X 32000\n"), "more than can be read");
  EXPECT_REASON(writtenText(kHead + "\n-Y 8192 +X 16384\nabcd"), "too short");
  EXPECT_REASON(written(picture({4, 2}, 1)), "no channels R, G, B (it has Y)");
  Image layer = picture({4, 2});
  layer.layers[0].name = "light";
  EXPECT_REASON(written(layer), "light.B");
  fs::resize_file(written(picture({64, 32})), 700);
  EXPECT_REASON(test::scratchFolder() / "map.exr", "map.exr");
}

TEST(EnvironmentFile, FilesOfOtherPrograms) {
  PILEUS_NEEDS_DATA();
  const fs::path data = *test::dataFolder();
  EXPECT_REASON(data / "exr" / "WavyLinesCube.exr", "cube map");
  const auto rings = decodeEnvironment(data / "exr" / "BrightRingsNanInf.exr");
  ASSERT_TRUE(rings) << rings.error().message;
  EXPECT_GE(rings->warnings.size(), 2u);
  int files = 0;
  for (const auto& entry : fs::directory_iterator(data / "env")) {
    SCOPED_TRACE(entry.path());
    const auto read = decodeEnvironment(entry.path());
    ASSERT_TRUE(read) << read.error().message;
    ++files;
    EXPECT_TRUE(read->warnings.empty()) << read->warnings[0];
    EXPECT_EQ(read->map.size.x, 2 * read->map.size.y);
    for (const vec3& texel : read->map.radiance)
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(texel[c]));
  }
  EXPECT_GE(files, 14);
  // The brightest value that the lists of these files name.
  const auto sky = decodeEnvironment(data / "env" / "pmndrs_sky_1k.hdr");
  float brightest = 0;
  for (const vec3& texel : sky->map.radiance) brightest = std::max({brightest, texel.x, texel.y, texel.z});
  EXPECT_EQ(brightest, 61184);
}

}  // namespace
}  // namespace pileus::image
