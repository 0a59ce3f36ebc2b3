// Colour: the shipped config against colour science worked out here, and configs of other makers.
#include "renderer/image/color.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>

#include "renderer/base/log.h"
#include "tests/support/support.h"

namespace pileus::image {
namespace {

namespace fs = std::filesystem;
using glm::dmat3;

using Config = std::shared_ptr<const ColorConfig>;

/// Sets $OCIO for one scope, or removes it.
struct OcioVariable {
  explicit OcioVariable(const std::string& value) {
    if (const char* old = std::getenv("OCIO")) before = old;
    if (value.empty())
      ::unsetenv("OCIO");
    else
      ::setenv("OCIO", value.c_str(), 1);
  }
  ~OcioVariable() {
    if (before)
      ::setenv("OCIO", before->c_str(), 1);
    else
      ::unsetenv("OCIO");
  }
  std::optional<std::string> before;
};

Config shipped() {
  const OcioVariable none("");
  auto config = ColorConfig::load("");
  EXPECT_TRUE(config) << config.error().message;
  return config ? *config : nullptr;
}

vec3 show(const Config& config, const std::string& display, const std::string& view, const vec3& color) {
  std::array<float, 4> pixel{color.r, color.g, color.b, 0.25f};
  const auto ok = config->applyCpu(display, view, pixel.data(), 1);
  EXPECT_TRUE(ok) << ok.error().message;
  EXPECT_EQ(pixel[3], 0.25f);
  return {pixel[0], pixel[1], pixel[2]};
}

dvec3 xyzFromXy(const dvec2& xy) { return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y}; }

dmat3 xyzFromRgb(const dvec2& r, const dvec2& g, const dvec2& b, const dvec2& white) {
  const dmat3 primaries(xyzFromXy(r), xyzFromXy(g), xyzFromXy(b));
  const dvec3 scale = glm::inverse(primaries) * xyzFromXy(white);
  return dmat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z);
}

/// ACEScg to linear RGB of the given primaries at D65, Bradford adaptation; from the published chromaticities
/// alone.
dmat3 fromAcesCg(const dvec2& r, const dvec2& g, const dvec2& b) {
  const dvec2 acesWhite(0.32168, 0.33767), d65(0.3127, 0.3290);
  const dmat3 bradford =
      glm::transpose(dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const dvec3 gain = (bradford * xyzFromXy(d65)) / (bradford * xyzFromXy(acesWhite));
  const dmat3 adapt = glm::inverse(bradford) * dmat3(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z) * bradford;
  return glm::inverse(xyzFromRgb(r, g, b, d65)) * adapt *
         xyzFromRgb({0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, acesWhite);
}

const dmat3 kRec709FromAcesCg = fromAcesCg({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06});
const dmat3 kP3FromAcesCg = fromAcesCg({0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060});

double srgbEncode(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055; }
double srgbDecode(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

/// Colours inside both gamuts, so that every curve is defined for them; some are far above 1.
const std::vector<vec3> kColors{{0.18f, 0.18f, 0.18f}, {1.0f, 1.0f, 1.0f},      {0.02f, 0.02f, 0.02f},
                                {0.5f, 0.3f, 0.2f},    {0.2f, 0.4f, 0.3f},      {0.1f, 0.15f, 0.4f},
                                {4.0f, 3.0f, 2.5f},    {0.003f, 0.002f, 0.004f}};

TEST(Color, ShippedConfigIsTheDefault) {
  const Config config = shipped();
  ASSERT_TRUE(config);
  EXPECT_EQ(config->workingSpace(), "ACEScg");
  EXPECT_EQ(config->defaultDisplay(), "sRGB");
  EXPECT_EQ(config->displays(), (std::vector<std::string>{"sRGB", "Rec.709", "Display P3"}));
  for (const std::string& display : config->displays()) {
    EXPECT_EQ(config->views(display), (std::vector<std::string>{"ACES 1.0 SDR", "Un-tone-mapped", "Raw"}));
    EXPECT_EQ(config->defaultView(display), "ACES 1.0 SDR");
  }
}

TEST(Color, ShippedConfigValidatesSilently) {
  const std::size_t before = log::history().size();
  ASSERT_TRUE(shipped());
  EXPECT_EQ(log::history().size(), before);
}

TEST(Color, UnToneMappedIsAMatrixAndACurve) {
  const Config config = shipped();
  for (const vec3& color : kColors) {
    const dvec3 rec709 = kRec709FromAcesCg * dvec3(color), p3 = kP3FromAcesCg * dvec3(color);
    const vec3 srgb = show(config, "sRGB", "Un-tone-mapped", color),
               hd = show(config, "Rec.709", "Un-tone-mapped", color),
               wide = show(config, "Display P3", "Un-tone-mapped", color);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(srgb[c], srgbEncode(rec709[c]), 1e-4) << c;
      EXPECT_NEAR(hd[c], std::pow(rec709[c], 1.0 / 2.4), 1e-4) << c;
      EXPECT_NEAR(wide[c], srgbEncode(p3[c]), 1e-4) << c;
    }
  }
}

TEST(Color, RawChangesNothing) {
  const Config config = shipped();
  for (const std::string& display : config->displays()) {
    const vec3 odd(-0.5f, 70000.0f, 0.18f);
    EXPECT_EQ(show(config, display, "Raw", odd), odd);
  }
}

TEST(Color, AcesPutsGreyAtATenthOfTheScreen) {
  // The ACES 1 tone scale takes 0.18 to 4.8 of 48 nits (black at 0.02), then the dim surround's exponent.
  const double expected = std::pow((4.8 - 0.02) / (48.0 - 0.02), 0.9811);
  const vec3 grey = show(shipped(), "", "", vec3(0.18f));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(srgbDecode(double(grey[c])), expected, 2e-4);
}

TEST(Color, NothingIsClampedBeforeTheView) {
  const Config config = shipped();
  for (const std::string view : {"ACES 1.0 SDR", "Un-tone-mapped", "Raw"}) {
    float previous = -1.0f;
    for (const float value : {0.0f, 0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f}) {
      const vec3 shown = show(config, "sRGB", view, vec3(value));
      EXPECT_GT(shown.g, previous + 1e-3f) << view << ' ' << value;
      previous = shown.g;
    }
  }
  // Negative values too; only the ACES rendering itself drops them.
  EXPECT_LT(show(config, "sRGB", "Un-tone-mapped", {-0.2f, 0.5f, 0.5f}).r,
            show(config, "sRGB", "Un-tone-mapped", {0.0f, 0.5f, 0.5f}).r - 0.01f);
  EXPECT_GT(show(config, "sRGB", "Un-tone-mapped", vec3(16.0f)).r, 3.0f);
}

TEST(Color, ManyPixelsEqualSinglePixels) {
  const Config config = shipped();
  std::vector<float> pixels;
  for (std::size_t i = 0; i < 20000; ++i)
    for (const float v : {kColors[i % 8].r, kColors[i % 8].g, kColors[i % 8].b, static_cast<float>(i)})
      pixels.push_back(v);
  ASSERT_TRUE(config->applyCpu("", "", pixels.data(), 20000));
  for (std::size_t i = 0; i < 20000; i += 777) {
    const vec3 one = show(config, "", "", kColors[i % 8]);
    for (int c = 0; c < 3; ++c) ASSERT_FLOAT_EQ(pixels[i * 4 + static_cast<std::size_t>(c)], one[c]);
    ASSERT_EQ(pixels[i * 4 + 3], static_cast<float>(i));
  }
  EXPECT_TRUE(config->applyCpu("", "", nullptr, 0));
}

TEST(Color, GpuTextIsSelfContained) {
  const Config config = shipped();
  std::set<std::string> keys;
  for (const std::string& display : config->displays())
    for (const std::string& view : config->views(display)) {
      const auto gpu = config->gpuTransform(display, view), again = config->gpuTransform(display, view);
      ASSERT_TRUE(gpu) << gpu.error().message;
      EXPECT_NE(gpu->glsl.find("vec4 ocioDisplay(vec4"), std::string::npos);
      EXPECT_EQ(gpu->glsl.find("#version"), std::string::npos);
      EXPECT_TRUE(gpu->textures.empty()) << display << ' ' << view;
      EXPECT_EQ(gpu->key, again->key);
      keys.insert(gpu->key.hex());
    }
  EXPECT_GE(keys.size(), 7u);  // raw is the same for every display
}

TEST(Color, UnknownNamesListWhatExists) {
  const Config config = shipped();
  const auto display = config->gpuTransform("CRT", "");
  ASSERT_FALSE(display);
  EXPECT_EQ(display.error().code, Code::Arguments);
  EXPECT_NE(display.error().message.find("'CRT'"), std::string::npos);
  EXPECT_NE(display.error().message.find("'Display P3'"), std::string::npos);
  float pixel[4]{};
  const auto view = config->applyCpu("sRGB", "Film", pixel, 1);
  ASSERT_FALSE(view);
  EXPECT_EQ(view.error().code, Code::Arguments);
  EXPECT_NE(view.error().message.find("'ACES 1.0 SDR', 'Un-tone-mapped', 'Raw'"), std::string::npos)
      << view.error().message;
  EXPECT_TRUE(config->views("CRT").empty());
}

TEST(Color, BrokenConfigsSayWhatIsWrong) {
  const fs::path folder = test::scratchFolder();
  std::ofstream(folder / "text.ocio") << "hello\n";
  std::ofstream(folder / "yaml.ocio") << "ocio_profile_version: 2\nroles: [\n";
  std::ofstream(folder / "bare.ocio") << "ocio_profile_version: 2\n";
  std::ofstream(folder / "future.ocio") << "ocio_profile_version: 3.7\n";
  for (const char* name : {"text.ocio", "yaml.ocio", "bare.ocio", "future.ocio", "missing.ocio", ""}) {
    const auto config = ColorConfig::load((folder / name).string());
    ASSERT_FALSE(config) << name;
    EXPECT_EQ(config.error().code, Code::Input);
    EXPECT_EQ(config.error().message.find((folder / name).string()), 0u) << config.error().message;
  }
  EXPECT_NE(ColorConfig::load((folder / "future.ocio").string()).error().message.find("profile version 3.7"),
            std::string::npos);
  EXPECT_FALSE(ColorConfig::load("ocio://default"));
}

TEST(Color, EnvironmentVariableChoosesTheConfig) {
  const fs::path path = test::scratchFolder() / "own.ocio";
  std::ifstream source(fs::path(PILEUS_SOURCE_DIR) / "presets/color/pileus.ocio");
  std::ofstream(path) << source.rdbuf();
  {
    const OcioVariable variable(path.string());
    const auto config = ColorConfig::load("");
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_NE((*config)->description().find(path.string()), std::string::npos);
  }
  const OcioVariable missing((path.parent_path() / "gone.ocio").string());
  const auto config = ColorConfig::load("");
  ASSERT_FALSE(config);
  EXPECT_NE(config.error().message.find("$OCIO"), std::string::npos);
}

std::string smallConfig(const std::string& roles) {
  return "ocio_profile_version: 2\nstrictparsing: true\nroles:\n  default: lin709\n  scene_linear: lin709\n" +
         roles +
         "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
         "displays:\n  Screen:\n    - !<View> {name: Plain, colorspace: lin709}\n"
         "colorspaces:\n"
         "  - !<ColorSpace> {name: aces, isdata: false}\n"
         "  - !<ColorSpace>\n    name: lin709\n    isdata: false\n"
         "    from_scene_reference: !<GroupTransform>\n      children:\n"
         "        - !<BuiltinTransform> {style: ACEScg_to_ACES2065-1, direction: inverse}\n"
         "        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD}\n";
}

TEST(Color, ConfigsWithoutAcesCgConvertThroughTheInterchangeRole) {
  const fs::path folder = test::scratchFolder();
  std::ofstream(folder / "interchange.ocio") << smallConfig("  aces_interchange: aces\n");
  std::ofstream(folder / "none.ocio") << smallConfig("");
  const auto exact = ColorConfig::load((folder / "interchange.ocio").string());
  ASSERT_TRUE(exact) << exact.error().message;
  const vec3 color(0.5f, 0.3f, 0.2f);
  const vec3 expected = kRec709FromAcesCg * dvec3(color);
  const vec3 shown = show(*exact, "", "", color);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], expected[c], 1e-4f);
  EXPECT_EQ((*exact)->description(), (folder / "interchange.ocio").string());

  const auto vague = ColorConfig::load((folder / "none.ocio").string());
  ASSERT_TRUE(vague) << vague.error().message;
  EXPECT_EQ((*vague)->workingSpace(), "lin709");
  EXPECT_NE((*vague)->description().find("colours are taken as 'lin709'"), std::string::npos);
  EXPECT_EQ(show(*vague, "", "", color), color);
}

}  // namespace
}  // namespace pileus::image
