// The window itself: panels, layouts, both themes, the scale, commands, notices, the log, and that it rests.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

constexpr char kScene[] = R"({
  "pileus": 1,
  "settings": { "size": [192, 108] },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 3 } },
    "Sun": { "type": "light.sun", "at": [0, 130], "params": { "elevation": 30 } },
    "Render": { "type": "render.volume", "at": [300, 0], "params": { "samples": 2 } },
    "View": { "type": "output.view", "at": [600, 0] }
  },
  "links": [ "Box.volume -> Render.volumes", "Sun.light -> Render.lights", "Render.image -> View.image" ]
}
)";

std::filesystem::path sceneFile() {
  const std::filesystem::path path = scratchFolder() / "window.json";
  std::ofstream(path) << kScene;
  return path;
}

double width(const json& t, const char* name) {
  const json& r = t["rects"][name];
  return r.is_null() ? 0 : r[2].get<double>() - r[0].get<double>();
}
bool has(const json& t, const std::string& rect) { return t["rects"].contains(rect); }

json settingsOf(const UiSession& ui) {
  return json::parse(textOf(ui.folder() / "config" / "pileus" / "settings.json"), nullptr, false);
}

void command(const UiSession& ui, const std::string& words, const std::string& id) {
  ui.key("F3");
  ASSERT_TRUE(ui.waitRect("commands/field"));
  ui.type(words);
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["notes"].value("commands/0", "") == id; }))
      << ui.trace()["notes"];
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !has(t, "commands/field"); }));
}

TEST(Window, PanelsLayoutsScaleAndThemeAreKept) {
  UiSession ui({1280, 720}, {sceneFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 60));

  // Ctrl+Space gives the panel under the pointer the window, and takes it back.
  ui.move(ui.center("viewport"));
  ui.key("ctrl+space");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !has(t, "canvas") && has(t, "viewport"); }));
  ui.screenshot("60-maximised");
  ui.key("ctrl+space");
  ASSERT_TRUE(ui.waitRect("canvas"));

  // The corner of a panel hides it; its key brings it back.
  const json canvas = ui.trace()["rects"]["canvas"];
  ui.move({canvas[2].get<double>() - 20, canvas[1].get<double>() + 15});
  ASSERT_TRUE(ui.waitRect("panel/graph/hide"));
  ui.screenshot("61-corner");
  ui.click("panel/graph/hide");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !has(t, "canvas"); }));
  ui.key("alt+2");
  ASSERT_TRUE(ui.waitRect("canvas"));

  // A splitter follows the pointer, and a double click takes it back.
  const auto canvasWidth = [&] { return width(ui.trace(), "canvas"); };
  const double before = canvasWidth();
  const Point grip = ui.center("splitter/parameters");
  ui.drag(grip, {grip.x - 80, grip.y});
  EXPECT_TRUE(ui.waitFor([&](const json&) { return std::abs(canvasWidth() - (before - 80)) < 3; }))
      << canvasWidth();
  const Point moved = ui.center("splitter/parameters");
  ui.doubleClick(moved);
  EXPECT_TRUE(ui.waitFor([&](const json&) { return std::abs(canvasWidth() - before) < 3; })) << canvasWidth();

  // A built-in layout by name, and one of one's own.
  command(ui, "look", "view.layout_look");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !has(t, "canvas"); }));
  ui.screenshot("62-look");
  ui.click("menubar/View");
  ui.click("menu/Layouts");
  ui.click("menu/save layout");
  ui.click("layout name");
  ui.type("Mine");
  ui.screenshot("63-save-layout");
  ui.key("Return");
  ui.key("Escape");
  ui.key("Escape");
  command(ui, "layouts default", "view.layout_default");
  ASSERT_TRUE(ui.waitRect("canvas"));

  // Scale: new fonts, larger panels, nothing lost.
  const double parameters = 1280 - canvasWidth();
  ui.move(ui.emptySpot());
  ui.key("ctrl+equal");
  ASSERT_TRUE(ui.waitFor([&](const json&) { return 1280 - canvasWidth() > parameters * 1.05; }))
      << canvasWidth();
  ui.key("ctrl+minus");
  ASSERT_TRUE(ui.waitFor([&](const json&) { return std::abs(1280 - canvasWidth() - parameters) < 4; }));

  command(ui, "light theme", "view.theme");
  ui.screenshot("64-light");
  ui.key("ctrl+q");
  ASSERT_EQ(ui.waitExit(), 0) << ui.log();
  const json kept = settingsOf(ui);
  ASSERT_TRUE(kept["layouts"].contains("Mine")) << kept;
  EXPECT_EQ(kept["theme"], "light");
  EXPECT_EQ(kept["layouts"]["Mine"]["showGraph"], false);
  EXPECT_EQ(kept["recentCommands"][0], "view.theme");
}

TEST(Window, NoticesTheLogAndTheSheet) {
  const std::filesystem::path file = sceneFile();
  UiSession ui({1280, 720}, {file.string()}, json{{"recentFiles", {file.string(), "/gone/away.json"}}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 60));

  // Saving says so in the corner, and fades.
  ui.key("ctrl+s");
  const auto notice = [](const json& t) {
    for (const auto& [name, text] : t["notes"].items())
      if (name.starts_with("toast/") && text.get<std::string>().starts_with("Saved")) return true;
    return false;
  };
  ASSERT_TRUE(ui.waitFor(notice)) << ui.trace()["notes"];
  ui.screenshot("65-notice");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return !notice(t); }, 10)) << "it fades by itself";

  // The log: filters.
  ui.key("F8");
  ASSERT_TRUE(ui.waitRect("log/search"));
  const auto lines = [&] { return std::stoi(ui.trace()["notes"].value("log", "-1")); };
  ASSERT_TRUE(ui.waitFor([&](const json&) { return lines() > 0; }));
  ui.click("log/search");
  ui.type("no line says this");
  EXPECT_TRUE(ui.waitFor([&](const json&) { return lines() == 0; })) << lines();
  ui.screenshot("66-log");
  ui.key("ctrl+a");
  ui.key("BackSpace");
  EXPECT_TRUE(ui.waitFor([&](const json&) { return lines() > 0; }));
  ui.click("log/clear");
  EXPECT_TRUE(ui.waitFor([&](const json&) { return lines() == 0; }));
  ui.click("log/close");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !has(t, "log"); }));

  // Recent files: what is gone cannot be opened.
  ui.click("menubar/File");
  ui.click("menu/recent");
  ASSERT_TRUE(ui.waitRect("recent/1"));
  ui.screenshot("67-recent");
  ui.click("recent/1");
  EXPECT_EQ(ui.trace()["path"], file.string());
  ui.click("recent/clear");
  ui.key("Escape");
  ui.key("Escape");

  // The sheet of keys, searched.
  ui.key("shift+F1");
  ASSERT_TRUE(ui.waitRect("shortcuts/search"));
  const auto rows = [&] { return std::stoi(ui.trace()["notes"].value("shortcuts", "-1")); };
  const int all = rows();
  EXPECT_GT(all, 30);
  ui.screenshot("68-shortcuts");
  ui.type("maximise");
  EXPECT_TRUE(ui.waitFor([&](const json&) { return rows() >= 1 && rows() < 6; })) << rows();
  ui.screenshot("69-shortcuts-search");
  ui.key("Escape");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !has(t, "shortcuts/search"); }));
  command(ui, "about", "help.about");
  ASSERT_TRUE(ui.waitRect("dialog/copy"));
  ui.screenshot("70-about");
  ui.click("dialog/copy");
  ui.key("Escape");
}

TEST(Window, RestsWithTheDefaultPreset) {
  UiSession ui({1280, 720}, {std::string(PILEUS_SOURCE_DIR) + "/presets/default.json"});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 200));
  pause(6);  // notices fade
  const double before = cpuSeconds(ui.process());
  pause(10);
  const double share = (cpuSeconds(ui.process()) - before) / 10;
  RecordProperty("idle processor share", std::to_string(share));
  std::printf("idle processor share %.4f\n", share);
  EXPECT_LT(share, 0.03);
}

}  // namespace
}  // namespace pileus::test
