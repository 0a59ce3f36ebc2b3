// Pictures of the window in both themes and three sizes, to be looked at: screenshots/gallery-*. What is
// checked here is that each state can be reached and that nothing warns on the way.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

struct Look {
  const char* name;
  const char* theme;
  ivec2 size;
  const char* scale;
};
constexpr Look kLooks[] = {
    {"dark-720", "dark", {1280, 720}, "1"},   {"light-720", "light", {1280, 720}, "1"},
    {"dark-1080", "dark", {1920, 1080}, "1"}, {"light-1080", "light", {1920, 1080}, "1"},
    {"dark-200", "dark", {2560, 1440}, "2"},  {"light-200", "light", {2560, 1440}, "2"},
};

class Gallery : public testing::TestWithParam<Look> {};

TEST_P(Gallery, EveryState) {
  const Look look = GetParam();
  UiSession ui(look.size, {std::string(PILEUS_SOURCE_DIR) + "/presets/shadows-across-gaps.json"},
               json{{"theme", look.theme}, {"viewportResolution", 0.25}}, {},
               {std::string("PILEUS_UI_SCALE=") + look.scale});
  ASSERT_TRUE(ui.running()) << ui.log();
  const auto shot = [&](const std::string& name) {
    ui.screenshot(std::string("gallery-") + look.name + "-" + name);
  };
  ui.finishPicture();
  ui.move(ui.emptySpot());
  ui.key("Home");
  ui.settle();
  shot("1-whole");
  const json rects = ui.trace()["rects"];
  std::string header;
  for (const auto& [name, r] : rects.items())
    if (name.starts_with("header/") && (header.empty() || name.find("Map") != std::string::npos))
      header = name;
  ASSERT_FALSE(header.empty());
  ui.click(header);
  shot("2-selected");
  ui.move(ui.emptySpot());
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("search/field"));
  shot("3-search");
  ui.key("Escape");
  ui.key("F3");
  ASSERT_TRUE(ui.waitRect("commands/field"));
  shot("4-commands");
  ui.key("Escape");
  ui.key("shift+F1");
  ASSERT_TRUE(ui.waitRect("shortcuts/search"));
  shot("5-shortcuts");
  ui.key("Escape");
  ui.click("menubar/View");
  shot("6-menu");
  ui.key("Escape");
  ui.key("F8");
  ASSERT_TRUE(ui.waitRect("log/search"));
  shot("7-log");
  ui.key("F8");
  ui.key("F7");
  ui.key("shift+s");
  ui.settle();
  shot("8-lab-and-scope");
  ui.key("shift+s");
  ui.key("F7");
  ui.move(ui.center("viewport"));
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("compare/line"));
  if (wantsScreenshots()) pause(3);
  shot("9-compare");
}

/// In the smallest window that is promised, at both scales.
TEST(SmallWindow, DialogsFitAndPanelsAreThere) {
  for (const char* scale : {"1", "2"}) {
    SCOPED_TRACE(scale);
    UiSession ui({1280, 720}, {std::string(PILEUS_SOURCE_DIR) + "/presets/default.json"},
                 json{{"viewportResolution", 0.25}}, {}, {std::string("PILEUS_UI_SCALE=") + scale});
    ASSERT_TRUE(ui.running()) << ui.log();
    ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("picture"); }, 60));
    const std::string name = std::string("small-") + scale;
    ui.settle();
    ui.screenshot(name + "-1-whole");
    ui.key("ctrl+o");
    ASSERT_TRUE(ui.waitRect("browser"));
    ui.settle();
    ui.screenshot(name + "-2-open");
    const json r = ui.trace()["rects"]["browser"], ok = ui.trace()["rects"]["browser/ok"];
    EXPECT_GE(r[1], 0) << r;
    EXPECT_LE(r[3], 720) << r;
    EXPECT_LE(ok[3], 720) << ok;
    EXPECT_LE(r[2], 1280) << r;
    EXPECT_GE(r[3].get<double>() - r[1].get<double>(), 480) << "more than a row or two of files";
    ui.key("Escape");
    ui.key("shift+F1");
    ASSERT_TRUE(ui.waitRect("shortcuts/search"));
    ui.screenshot(name + "-3-keys");
    ui.key("Escape");
    ui.click("menubar/File");
    ui.settle();
    ui.screenshot(name + "-4-menu");
    ui.key("Escape");
  }
}

INSTANTIATE_TEST_SUITE_P(All, Gallery, testing::ValuesIn(kLooks), [](const auto& which) {
  std::string name = which.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace pileus::test
