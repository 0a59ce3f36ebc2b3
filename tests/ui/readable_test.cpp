// What the window says can be read in a small window, at the usual size and at twice that, in both themes.
#include <fmt/core.h>

#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

/// Texts that are cut on the screen now.
std::vector<std::string> cuts(const json& t) {
  std::vector<std::string> out;
  for (const auto& [name, text] : t["notes"].items())
    if (name.starts_with("cut/")) out.push_back(text.get<std::string>());
  return out;
}

bool has(const std::vector<std::string>& all, const std::string& text) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

class Readable : public testing::TestWithParam<std::tuple<int, const char*>> {};

TEST_P(Readable, NamesAndTheStatusLineAreWholeWhereThereIsRoom) {
  const auto [scale, theme] = GetParam();
  UiSession ui({1280, 720}, {std::string(PILEUS_SOURCE_DIR) + "/presets/default.json"}, {{"theme", theme}},
               {}, {fmt::format("PILEUS_UI_SCALE={}", scale)});
  ASSERT_TRUE(ui.running()) << ui.log();
  if (wantsScreenshots())
    ui.finishPicture();
  else
    ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("picture"); }, 60));
  ui.move(ui.emptySpot());
  ui.key("a");
  ui.settle();
  ui.screenshot(fmt::format("readable-{}-{}", scale, theme));
  const std::vector<std::string> all = cuts(ui.trace());
  const json nodes = ui.trace()["document"]["nodes"];
  for (const auto& [name, node] : nodes.items()) EXPECT_FALSE(has(all, name)) << name << " is cut";
  for (const std::string& text : all)
    EXPECT_EQ(text.find(" ms"), std::string::npos)
        << "figures of the status line are shown whole or not: " << text;
  ui.click("header/Sky");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Sky"}; }));
  ui.settle();
  ui.screenshot(fmt::format("readable-{}-{}-sky", scale, theme));
  for (const char* label : {"Ground albedo", "Altitude", "Irradiance"})
    EXPECT_FALSE(has(cuts(ui.trace()), label)) << label << " is cut";
}

INSTANTIATE_TEST_SUITE_P(Sizes, Readable,
                         testing::Combine(testing::Values(1, 2), testing::Values("dark", "light")),
                         [](const auto& which) {
                           return fmt::format("{}{}", std::get<1>(which.param),
                                              100 * std::get<0>(which.param));
                         });

bool apart(const json& a, const json& b) {
  return a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
}

TEST(Bars, KeepTheirButtonsApartInASmallWindow) {
  UiSession ui({1280, 720}, {std::string(PILEUS_SOURCE_DIR) + "/presets/default.json"},
               json::object({{"showTimeline", true}}), {}, {"PILEUS_UI_SCALE=2"});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("picture"); }, 60));
  json rects = ui.trace()["rects"];
  int fields = 0;
  for (const char* field : {"timeline/frame", "timeline/start", "timeline/end", "timeline/fps"})
    if (rects.contains(field)) {
      ++fields;
      EXPECT_TRUE(apart(rects[field], rects["timeline/close"])) << field;
    }
  EXPECT_GE(fields, 3);
  ui.click("timeline/close");
  ui.move(ui.center("viewport"));
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("compare/close"));
  ui.settle();
  ui.screenshot("compare-bar-small");
  rects = ui.trace()["rects"];
  for (const auto& [name, rect] : rects.items())
    if (name.starts_with("compare") && name != "compare/close") {
      EXPECT_TRUE(apart(rect, rects["compare/close"])) << name;
    }
  // The choices are in a list.
  ui.click("compare");
  ui.click("compare/error");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["rects"].contains("compare/scale"); }));
}

TEST(CutTexts, AreReadWhereThePointerRests) {
  const std::filesystem::path path = scratchFolder() / "long.json";
  const std::string name = "A very long name of a node that has no room in its header";
  std::ofstream(path) << R"({ "pileus": 1, "settings": { "size": [160, 90] },
    "nodes": { ")" + name + R"(": { "type": "volume.box", "at": [0, 0] },
               "Render": { "type": "render.volume", "at": [260, 0], "params": { "samples": 1 } },
               "View": { "type": "output.view", "at": [520, 0] } },
    "links": [ ")" + name + R"(.volume -> Render.volumes", "Render.image -> View.image" ] })";
  UiSession ui({1280, 720}, {path.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ASSERT_TRUE(has(cuts(ui.trace()), name)) << ui.trace()["notes"];
  ui.move(ui.center("header/" + name));
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["notes"].value("cut text", "") == name; }))
      << ui.trace()["notes"];
  ui.screenshot("cut-text");
  ui.move(ui.emptySpot());
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["notes"].contains("cut text"); }));
}

}  // namespace
}  // namespace pileus::test
