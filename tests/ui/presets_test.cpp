// Presets of one's own in a real window: kept, found, put to use, changed and taken back; two windows.
#include "nodes/file/preset_folder.h"
#include "renderer/base/file.h"
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

constexpr char kGraph[] = R"({"pileus": 1, "settings": {"size": [96, 54]}, "nodes": {
  "Ball": {"type": "volume.sphere", "at": [0, 0], "params": {"density": 3}},
  "Sun": {"type": "light.sun", "at": [0, 130], "params": {"elevation": 12.5}},
  "Render": {"type": "render.volume", "at": [300, 0], "params": {"samples": 1}},
  "View": {"type": "output.view", "at": [560, 0], "params": {}}},
  "links": ["Ball.volume -> Render.volumes", "Sun.light -> Render.lights", "Render.image -> View.image"]})";

fs::path graphFile() {
  const fs::path path = scratchFolder() / "scene.json";
  std::ofstream(path) << kGraph;
  return path;
}

fs::path ownFolder(const UiSession& ui) { return ui.folder() / "config" / "pileus" / "presets"; }

void menu(const UiSession& ui, const std::string& command) {
  ui.click("menubar/File");
  ASSERT_TRUE(ui.waitRect("menu/Presets"));
  ui.click("menu/Presets");
  ASSERT_TRUE(ui.waitRect("menu/" + command)) << command;
  ui.click("menu/" + command);
}

/// The dialog is open: these words into it, and Enter.
void keep(const UiSession& ui, const std::string& name, const std::string& about, const std::string& tags) {
  ASSERT_TRUE(ui.waitRect("preset dialog/name"));
  ui.click("preset dialog/name");
  ui.key("ctrl+a");
  ui.type(name);
  ui.click("preset dialog/about");
  ui.type(about);
  ui.click("preset dialog/tags");
  ui.type(tags);
  ui.settle();
  ui.screenshot("presets-dialog-" + name);
  ui.click("dialog/preset/save");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("preset dialog/name"); }));
}

bool has(const std::vector<nodes::PresetEntry>& all, const std::string& name) {
  return nodes::findPreset(all, name) != nullptr;
}

TEST(PresetsWindow, KeptFoundUsedChangedAndTakenBack) {
  UiSession ui({1440, 900}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  const fs::path own = ownFolder(ui);

  // The scene, a node's parameters and two nodes.
  menu(ui, "presets.keep_document");
  keep(ui, "Ball at dusk", "A ball in low light", "dusk, ball");
  ui.click("header/Sun");
  ui.click("header/Sun", 3);
  ASSERT_TRUE(ui.waitRect("menu/presets"));
  ui.move(ui.center("menu/presets"));
  ASSERT_TRUE(ui.waitRect("menu/presets.keep_parameters"));
  ui.settle();
  ui.screenshot("presets-node-menu");
  ui.click("menu/presets.keep_parameters");
  keep(ui, "Low key", "A low sun", "dusk");
  std::vector<nodes::PresetEntry> all = nodes::presetsIn(own);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(has(all, "Ball at dusk") && has(all, "Low key"));
  EXPECT_TRUE(fs::exists(own / "ball-at-dusk.png"));

  // The values, after they were changed, from the node's menu; one undo.
  ui.move(ui.emptySpot());
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitRect("param/elevation"));
  const Point p = ui.center("param/elevation");
  ui.drag(p, {p.x + 12, p.y});
  ASSERT_TRUE(ui.waitFor([&](const json&) { return param(ui, "Sun", "elevation") != 12.5; }));
  ui.click("header/Sun", 3);
  ASSERT_TRUE(ui.waitRect("menu/presets"));
  ui.move(ui.center("menu/presets"));
  ASSERT_TRUE(ui.waitRect("menu/preset/0"));
  ui.click("menu/preset/0");
  EXPECT_TRUE(becomes(ui, "Sun", "elevation", 12.5));

  // In the search that adds nodes.
  ui.move(ui.emptySpot());
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("search/field"));
  ui.type("low key");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].value("search/0", "") == "Low key"; }));
  ui.settle();
  ui.screenshot("presets-search");
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Low key"); }));
  EXPECT_EQ(param(ui, "Low key", "elevation"), 12.5);

  // The gallery: by words and by tag; renamed, deleted, and both taken back.
  menu(ui, "presets.gallery");
  const std::string scene = "start/preset/" + (own / "ball-at-dusk.json").string();
  ASSERT_TRUE(ui.waitRect(scene));
  ui.settle();
  ui.screenshot("presets-gallery");
  ui.click("gallery/search");
  ui.type("low sun");
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return !t["rects"].contains(scene) &&
           t["rects"].contains("start/preset/" + (own / "low-key.json").string());
  }));
  ui.key("ctrl+a");
  ui.key("BackSpace");
  ui.click("gallery/tag/ball");
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return t["rects"].contains(scene) && !t["rects"].contains("start/preset/default.json");
  }));
  ui.click(scene, 3);
  ASSERT_TRUE(ui.waitRect("gallery/menu/describe"));
  ui.settle();
  ui.screenshot("presets-card-menu");
  ui.click("gallery/menu/describe");
  ASSERT_TRUE(ui.waitRect("preset dialog/name"));
  ui.click("preset dialog/name");
  ui.key("ctrl+a");
  ui.type("Night / ball");
  ui.click("dialog/preset/save");
  ASSERT_TRUE(ui.waitFor([&](const json&) { return has(nodes::presetsIn(own), "Night / ball"); }));
  ASSERT_TRUE(ui.waitRect(scene));
  ui.click(scene, 3);
  ASSERT_TRUE(ui.waitRect("gallery/menu/delete"));
  ui.click("gallery/menu/delete");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return !t["rects"].contains(scene); }));
  EXPECT_FALSE(fs::exists(own / "ball-at-dusk.json"));
  ui.click(Point{8, 500});
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("start"); }));
  menu(ui, "presets.undo");
  ASSERT_TRUE(ui.waitFor([&](const json&) { return has(nodes::presetsIn(own), "Night / ball"); }));
  EXPECT_TRUE(fs::exists(own / "ball-at-dusk.png"));
  ui.settle();
  menu(ui, "presets.undo");
  ASSERT_TRUE(ui.waitFor([&](const json&) { return has(nodes::presetsIn(own), "Ball at dusk"); }));
}

TEST(PresetsWindow, TwoWindowsLoseNothing) {
  const fs::path graph = graphFile();
  UiSession one({1440, 900}, {graph.string()});
  ASSERT_TRUE(one.running()) << one.log();
  one.finishPicture();
  menu(one, "presets.keep_document");
  keep(one, "Mine", "of one", "");
  // The other keeps its own home; the library is the first one's, as a show's would be.
  UiSession two({1440, 900}, {graph.string()}, json{{"presetFolders", {ownFolder(one).string()}}});
  ASSERT_TRUE(two.running()) << two.log();
  two.finishPicture();
  menu(two, "presets.keep_document");
  ASSERT_TRUE(two.waitRect("preset dialog/folder"));
  two.click("preset dialog/folder");
  ASSERT_TRUE(two.waitRect("preset dialog/folder/1"));
  two.click("preset dialog/folder/1");
  keep(two, "Mine", "of two", "");
  EXPECT_EQ(nodes::loadPreset(ownFolder(one) / "mine.json")->preset.about, "of two");
  // The first one's undo would take away the other's work.
  one.focus();
  one.expectLogged("written by another program");
  menu(one, "presets.undo");
  EXPECT_TRUE(
      one.waitFor([&](const json&) { return one.log().find("another program") != std::string::npos; }));
  EXPECT_EQ(nodes::loadPreset(ownFolder(one) / "mine.json")->preset.about, "of two");
  two.focus();
  menu(two, "presets.undo");
  EXPECT_TRUE(two.waitFor([&](const json&) {
    return nodes::loadPreset(ownFolder(one) / "mine.json")->preset.about == "of one";
  }));
}

TEST(PresetsWindow, ADamagedOneAndADiskThatIsFullAreSaid) {
  UiSession ui({1440, 900}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  const fs::path own = ownFolder(ui);
  fs::create_directories(own);
  std::ofstream(own / "broken.json") << "{ \"pileus\": ";
  menu(ui, "presets.gallery");
  const std::string broken = "start/preset/" + (own / "broken.json").string();
  ASSERT_TRUE(ui.waitRect(broken));
  ui.move(ui.center("start/preset/default.json"));
  ui.settle();
  ui.screenshot("presets-damaged");
  ui.key("Escape");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("start"); }));
  EXPECT_EQ(textOf(own / "broken.json"), "{ \"pileus\": ");

  // No folder can be made where a file lies.
  fs::remove_all(own);
  std::ofstream(own) << "in the way";
  menu(ui, "presets.keep_document");
  ASSERT_TRUE(ui.waitRect("preset dialog/name"));
  ui.click("preset dialog/name");
  ui.key("ctrl+a");
  ui.type("Lost?");
  ui.click("dialog/preset/save");
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("preset dialog", "").find("cannot be written") != std::string::npos;
  }));
  EXPECT_TRUE(ui.shows("preset dialog/name")) << "what was typed is still there";
  ui.settle();
  ui.screenshot("presets-not-written");
  fs::remove(own);
  ui.click("dialog/preset/save");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("preset dialog/name"); }));
  EXPECT_TRUE(has(nodes::presetsIn(own), "Lost?"));
}

}  // namespace
}  // namespace pileus::test
