// Colour configs of other makers ($PILEUS_TEST_DATA/ocio).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/image/color.h"
#include "tests/support/support.h"

namespace pileus::image {
namespace {

namespace fs = std::filesystem;
using Config = std::shared_ptr<const ColorConfig>;

fs::path ocioFile(const std::string& name) { return *test::dataFolder() / "ocio" / name; }

Config load(const std::string& path) {
  auto config = ColorConfig::load(path);
  EXPECT_TRUE(config) << config.error().message;
  return config ? *config : nullptr;
}

TEST(ColorFiles, ShippedViewsEqualThoseOfTheAcesConfig) {
  PILEUS_NEEDS_DATA();
  const Config ours = load(std::string(PILEUS_SOURCE_DIR) + "/presets/color/pileus.ocio");
  const Config aces = load(ocioFile("aces_builtin/cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio"));
  ASSERT_TRUE(ours && aces);
  constexpr std::array<std::array<const char*, 2>, 2> displays{
      {{"sRGB", "sRGB - Display"}, {"Rec.709", "Rec.1886 Rec.709 - Display"}}};
  constexpr std::array<std::array<const char*, 2>, 3> views{
      {{"ACES 1.0 SDR", "ACES 1.0 - SDR Video"}, {"Un-tone-mapped", "Un-tone-mapped"}, {"Raw", "Raw"}}};
  for (const auto& display : displays)
    for (const auto& view : views) {
      std::vector<float> a;
      for (const float r : {-0.05f, 0.0f, 0.01f, 0.18f, 0.5f, 1.0f, 3.0f, 16.0f, 100.0f})
        for (const float g : {0.0f, 0.18f, 2.0f})
          for (const float b : {0.0f, 0.18f, 5.0f}) a.insert(a.end(), {r, g, b, 1.0f});
      std::vector<float> b = a;
      ASSERT_TRUE(ours->applyCpu(display[0], view[0], a.data(), a.size() / 4));
      ASSERT_TRUE(aces->applyCpu(display[1], view[1], b.data(), b.size() / 4));
      for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_NEAR(a[i], b[i], 1e-4f) << display[0] << " / " << view[0] << ' ' << i;
    }
}

TEST(ColorFiles, EveryViewOfEveryConfigWorksAndAgreesWithItsTextures) {
  PILEUS_NEEDS_DATA();
  for (const char* name :
       {"aces_builtin/cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio",
        "aces_builtin/studio-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio", "nuke-default_osl/config.ocio",
        "ocio-v2_demo/ocio-v2_demo.ocio", "blender-3.4-filmic/config.ocio",
        "xstudio/xstudio-config-v2.1.0_aces-v1.3_ocio-v2.1.ocio"}) {
    const Config config = load(ocioFile(name));
    ASSERT_TRUE(config);
    for (const std::string& display : config->displays())
      for (const std::string& view : config->views(display)) {
        std::array<float, 8> pixels{0.18f, 0.18f, 0.18f, 1.0f, 4.0f, 2.0f, 1.0f, 0.5f};
        const auto cpu = config->applyCpu(display, view, pixels.data(), 2);
        ASSERT_TRUE(cpu) << cpu.error().message;
        EXPECT_TRUE(std::all_of(pixels.begin(), pixels.end(), [](float v) { return std::isfinite(v); }))
            << view;
        const auto gpu = config->gpuTransform(display, view);
        ASSERT_TRUE(gpu) << gpu.error().message;
        for (const LutTexture& t : gpu->textures) {
          const std::string declaration = fmt::format("uniform sampler{}D {};", t.dimensions, t.sampler);
          EXPECT_NE(gpu->glsl.find(declaration), std::string::npos) << declaration;
          EXPECT_EQ(t.texels.size(), static_cast<std::size_t>(t.size.x * t.size.y * t.size.z * t.channels));
          EXPECT_TRUE(
              std::all_of(t.texels.begin(), t.texels.end(), [](float v) { return std::isfinite(v); }));
        }
        const auto declared = [&](const char* type) {
          std::size_t n = 0;
          for (std::size_t at = 0; (at = gpu->glsl.find(type, at)) != std::string::npos; ++at) ++n;
          return n;
        };
        EXPECT_EQ(declared("uniform "), gpu->textures.size()) << view;
      }
  }
}

TEST(ColorFiles, NewerProfilesAreRefusedWithBothVersions) {
  PILEUS_NEEDS_DATA();
  for (const auto& [name, version] : {std::pair("cg-config-v2.1.0_aces-v1.3_ocio-v2.3.ocio", "2.3"),
                                      {"cg-config-v2.2.0_aces-v1.3_ocio-v2.4.ocio", "2.4"},
                                      {"cg-config-v4.0.0_aces-v2.0_ocio-v2.5.ocio", "2.5"}}) {
    const auto config = ColorConfig::load(ocioFile(std::string("aces_builtin/") + name));
    if (config) GTEST_SKIP() << "this OpenColorIO reads profile " << version;
    EXPECT_EQ(config.error().code, Code::Input);
    EXPECT_NE(config.error().message.find(std::string("profile version ") + version), std::string::npos)
        << config.error().message;
    EXPECT_NE(config.error().message.find("OpenColorIO 2."), std::string::npos) << config.error().message;
    EXPECT_NE(config.error().message.find(name), std::string::npos);
  }
}

TEST(ColorFiles, MissingLutsAreSaidByTheViewThatNeedsThem) {
  PILEUS_NEEDS_DATA();
  const Config config = load(ocioFile("aces_1.0.1_luts-missing/config.ocio"));
  ASSERT_TRUE(config);
  EXPECT_EQ(config->workingSpace(), "ACES - ACEScg");
  const std::string display = config->defaultDisplay();
  EXPECT_GE(config->views(display).size(), 10u);
  float pixel[4]{0.18f, 0.18f, 0.18f, 1.0f};
  const auto cpu = config->applyCpu(display, "sRGB D60 sim.", pixel, 1);
  const auto gpu = config->gpuTransform(display, "sRGB D60 sim.");
  ASSERT_FALSE(cpu);
  ASSERT_FALSE(gpu);
  for (const Error& e : {cpu.error(), gpu.error()}) {
    EXPECT_EQ(e.code, Code::Input);
    EXPECT_NE(e.message.find("'sRGB D60 sim.'"), std::string::npos);
    EXPECT_NE(e.message.find(".spi1d"), std::string::npos) << e.message;
  }
  EXPECT_EQ(pixel[0], 0.18f);
  EXPECT_TRUE(config->applyCpu(display, "Raw", pixel, 1));
  EXPECT_TRUE(config->gpuTransform(display, "Raw"));
}

}  // namespace
}  // namespace pileus::image
