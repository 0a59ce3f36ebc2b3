// Both themes can be read: every pair of ink and ground that the interface draws.
#include "editor/toolkit/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include "editor/commands/keyboard.h"
#include "editor/toolkit/icon_ranges.h"
#include "tests/support/support.h"

namespace pileus::editor {
namespace {

struct Color {
  const char* name;
  const ImU32* value;
};
#define COLOR(name, dark, light) {#name, &palette::name},
const Color kAll[] = {
#include "editor/toolkit/palette.inc"
};
#undef COLOR

double linear(ImU32 byte) {
  const double v = static_cast<double>(byte) / 255;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double channel(ImU32 c, int shift, double over) {
  const double a = static_cast<double>(c >> 24) / 255;
  return a * static_cast<double>((c >> shift) & 255) + (1 - a) * over;
}
/// WCAG's relative luminance, of `c` over a grey.
double luminance(ImU32 c, double over = 128) {
  const auto part = [&](int shift) {
    return linear(static_cast<ImU32>(std::lround(channel(c, shift, over))));
  };
  return 0.2126 * part(0) + 0.7152 * part(8) + 0.0722 * part(16);
}
double contrast(ImU32 ink, ImU32 ground, double over = 128) {
  const double a = luminance(ink, over), b = luminance(ground, over);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

std::vector<Color> named(const std::string& list) {
  std::vector<Color> out;
  std::istringstream words(list);
  for (std::string word; words >> word;) {
    const auto it =
        std::find_if(std::begin(kAll), std::end(kAll), [&](const Color& c) { return word == c.name; });
    if (it == std::end(kAll))
      ADD_FAILURE() << "no colour is called " << word;
    else
      out.push_back(*it);
  }
  return out;
}

void expectContrast(const std::string& inks, const std::string& grounds, double least) {
  for (const Color& ink : named(inks))
    for (const Color& ground : named(grounds))
      EXPECT_GE(contrast(*ink.value, *ground.value), least) << ink.name << " on " << ground.name;
}

class Themes : public testing::TestWithParam<Appearance> {
 protected:
  void SetUp() override { setPalette(GetParam()); }
  void TearDown() override { setPalette(Appearance::Dark); }
};

TEST_P(Themes, TextCanBeReadOnItsGround) {
  expectContrast("kText kTextStrong kTextDim",
                 "kBackground kSurround kPictureEmpty kPanel kBar kPopup kField kFieldHover kCanvas kNode",
                 4.5);
  expectContrast("kTextFaint", "kPanel kBar kPopup kField kFieldHover kCanvas kNode", 4.5);
  expectContrast("kText kTextStrong",
                 "kAccentHover kAccentDim kButton kButtonHover kRowHover kTextSelected kErrorBack "
                 "kWarningBack",
                 4.5);
  expectContrast("kWarning kError kAccent kGood", "kPanel kBar kPopup kField", 4.5);
  expectContrast("kWarning kError", "kSurround", 4.5);
  expectContrast("kError", "kErrorBack", 4.5);
  expectContrast("kWarning", "kWarningBack", 4.5);
  expectContrast(
      "kTextStrong",
      "kVolume kLight kShadowNode kCamera kSolid kRender kOutput kImage kMath kTime kOther kNodeUnknown",
      4.5);
}

TEST_P(Themes, TextCanBeReadOnAnyPicture) {
  for (const double picture : {0.0, 128.0, 255.0})
    for (const ImU32 ground : {palette::kChip, palette::kVeil})
      EXPECT_GE(contrast(palette::kText, ground, picture), 4.5) << "over a picture of " << picture;
}

TEST_P(Themes, MarksAndCurvesStandOut) {
  expectContrast(
      "kVolumeSocket kLightSocket kMetricSocket kCameraSocket kSolidSocket kImageSocket kNumberSocket "
      "kVectorSocket kColorSocket kTextSocket",
      "kNode kCanvas", 3);
  expectContrast("kSeries0 kSeries1 kSeries2 kSeries3 kSeries4 kSeries5 kExact kGhost", "kField kPanel", 3);
  expectContrast("kSelect", "kCanvas kNode kPanel", 3);
  expectContrast("kFieldBar kAccent", "kField kFieldHover", 3);
  expectContrast("kFieldBar", "kFieldTrack", 2.5);
}

TEST_P(Themes, NothingIsPureAndPicturesStandOnNeutralGrey) {
  for (const Color& c : kAll) {
    EXPECT_NE(*c.value & 0xffffff, 0u) << c.name << " is black";
    EXPECT_NE(*c.value & 0xffffff, 0xffffffu) << c.name << " is white";
  }
  for (const ImU32 c : {palette::kSurround, palette::kPictureEmpty}) {
    EXPECT_EQ(c & 255, (c >> 8) & 255);
    EXPECT_EQ(c & 255, (c >> 16) & 255);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Themes, testing::Values(Appearance::Dark, Appearance::Light),
                         [](const auto& which) { return std::string(enumId(which.param)); });

TEST(Themes, ThemesDifferAndComeBack) {
  std::vector<ImU32> dark, light;
  setPalette(Appearance::Light);
  for (const Color& c : kAll) light.push_back(*c.value);
  setPalette(Appearance::Dark);
  for (const Color& c : kAll) dark.push_back(*c.value);
  EXPECT_NE(dark, light);
  EXPECT_GT(luminance(light[0]), luminance(dark[0]));
}

TEST(Icons, EachIsBaked) {
  std::ifstream file(std::string(PILEUS_SOURCE_DIR) + "/editor/toolkit/icons.h");
  std::stringstream text;
  text << file.rdbuf();
  const std::string source = text.str();
  std::size_t icons = 0;
  for (std::size_t at = source.find("\"\\xef"); at != std::string::npos;
       at = source.find("\"\\xef", at + 1)) {
    const auto byte = [&](std::size_t i) { return std::stoi(source.substr(at + 3 + 4 * i, 2), nullptr, 16); };
    const int code = (byte(0) & 15) << 12 | (byte(1) & 63) << 6 | (byte(2) & 63);
    bool baked = false;
    for (const ImWchar* r = iconRanges(); r[0]; r += 2) baked |= code >= r[0] && code <= r[1];
    EXPECT_TRUE(baked) << std::hex << code << ": add it to the icon ranges of theme.cpp";
    ++icons;
  }
  EXPECT_GT(icons, 30u);
}

TEST(Keyboard, ThePageIsCurrent) {
  std::ifstream file(std::string(PILEUS_SOURCE_DIR) + "/docs/keyboard.md");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), keyboardMarkdown()) << "run: pileus keys --markdown > docs/keyboard.md";
}

TEST(Keyboard, SeriesBecomeOneRow) {
  std::size_t slots = 0;
  for (const KeySection& section : keyboardMap())
    for (const KeyRow& row : section.rows)
      if (row.what.starts_with("View Slot")) {
        ++slots;
        EXPECT_EQ(row.what, "View Slot 1 to 9");
        EXPECT_EQ(row.keys, "1 to 9");
      }
  EXPECT_EQ(slots, 1u);
}

}  // namespace
}  // namespace pileus::editor
