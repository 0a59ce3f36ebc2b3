#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <tuple>

#include "editor/commands/actions.h"
#include "editor/commands/menu.h"
#include "editor/picture/camera_control.h"
#include "editor/preferences/settings.h"
#include "editor/preferences/settings_file.h"
#include "editor/toolkit/number_field.h"
#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus::editor {
namespace {

TEST(Actions, IdsLabelsAndMenusAreSane) {
  std::set<std::string> ids;
  for (const Action& a : allActions()) {
    EXPECT_TRUE(ids.insert(a.id).second) << a.id << " occurs twice";
    EXPECT_NE(std::string(a.label), "") << a.id;
    EXPECT_NE(a.run, nullptr) << a.id;
    EXPECT_EQ(findAction(a.id), &a);
    const std::string menu = std::string(menuOf(a)).substr(0, menuOf(a).find('/'));
    EXPECT_TRUE(menu.empty() || std::find(std::begin(kMenus), std::end(kMenus), menu) != std::end(kMenus))
        << a.id << " is in no menu: " << a.menu;
    for (const Shortcut& s : a.keys)
      if (s.key) {
        EXPECT_EQ(shortcutText(s).find('?'), std::string::npos) << a.id << " has a key without a name";
      }
  }
  EXPECT_EQ(findAction("no.such"), nullptr);
}

TEST(Actions, NoShortcutMeansTwoThingsInOnePanel) {
  std::map<std::tuple<Panel, int, bool, bool, bool>, std::string> seen;
  for (const Action& a : allActions())
    for (const Shortcut& s : a.keys) {
      if (!s.key) continue;
      const auto [it, fresh] = seen.emplace(std::tuple{a.panel, s.key, s.ctrl, s.shift, s.alt}, a.id);
      EXPECT_TRUE(fresh) << shortcutText(s) << " is both " << it->second << " and " << a.id;
      EXPECT_EQ(shortcutText(s).find('?'), std::string::npos) << a.id << " has a key without a name";
    }
  for (const auto& [key, id] : seen) {
    const auto& [panel, code, ctrl, shift, alt] = key;
    if (panel == Panel::Global) continue;
    const auto global = seen.find({Panel::Global, code, ctrl, shift, alt});
    if (global == seen.end()) continue;
    // Copy, cut and paste of what a panel shows go before those of the graph, and only those of the same
    // name.
    EXPECT_EQ(id.substr(id.find('.')), global->second.substr(global->second.find('.')))
        << shortcutText({code, ctrl, shift, alt}) << " of " << id << " hides " << global->second;
  }
}

TEST(Actions, TheFixedKeysAreThere) {
  const auto text = [](const char* id) { return shortcutText(findAction(id)->keys[0]); };
  EXPECT_EQ(text("graph.add"), "Tab");
  EXPECT_EQ(text("edit.undo"), "Ctrl+Z");
  EXPECT_EQ(text("edit.redo"), "Ctrl+Shift+Z");
  EXPECT_EQ(text("file.save_as"), "Ctrl+Shift+S");
  EXPECT_EQ(text("graph.bypass"), "D");
  EXPECT_EQ(text("viewport.exposure_up"), "]");
}

TEST(Settings, RoundTripThroughTheFile) {
  Settings s;
  s.window = {1600, 1000};
  s.viewportShare = 0.4;
  s.parametersWidth = 400;
  s.showTimes = true;
  s.recentFiles = {"/a/b.json", "/c \"quoted\".json"};
  s.recentNodes = {"light.sun"};
  const std::filesystem::path folder = test::scratchFolder();
  ASSERT_TRUE(saveSettings(folder, s));
  EXPECT_EQ(loadSettings(folder), s);
  EXPECT_EQ(loadSettings(folder / "missing"), Settings{});
}

TEST(Settings, AreWrittenAMomentAfterAChange) {
  const std::filesystem::path folder = test::scratchFolder();
  Settings s;
  SettingsFile file(folder, s, 0);
  ASSERT_TRUE(file.watch(s));
  EXPECT_FALSE(std::filesystem::exists(folder / kSettingsName)) << "nothing has changed";
  EXPECT_LT(file.dueSeconds(), 0);
  s.showHud = true;
  ASSERT_TRUE(file.watch(s));
  EXPECT_TRUE(loadSettings(folder).showHud);
  SettingsFile patient(folder, s, 1000);
  s.showHud = false;
  ASSERT_TRUE(patient.watch(s));
  EXPECT_GT(patient.dueSeconds(), 900);
  EXPECT_TRUE(loadSettings(folder).showHud);
}

TEST(Settings, TwoWindowsKeepWhatEachHasChanged) {
  const std::filesystem::path folder = test::scratchFolder();
  std::ofstream(folder / kSettingsName) << R"({ "ofALaterVersion": [1, 2], "recentFiles": ["/a"] })";
  Settings first = loadSettings(folder), second = first;
  SettingsFile one(folder, first), two(folder, second);
  first.showHud = true;
  remember(first.recentFiles, "/one");
  second.draftMs = 80;
  remember(second.recentFiles, "/two");
  ASSERT_TRUE(one.save(first));
  ASSERT_TRUE(two.save(second));
  const Settings both = loadSettings(folder);
  EXPECT_TRUE(both.showHud);
  EXPECT_EQ(both.draftMs, 80);
  EXPECT_EQ(both.recentFiles, (std::vector<std::string>{"/two", "/a", "/one"}));
  EXPECT_NE(readFile(folder / kSettingsName)->find("ofALaterVersion"), std::string::npos);
}

TEST(Settings, ADamagedFileIsSetAside) {
  const std::filesystem::path folder = test::scratchFolder();
  std::ofstream(folder / kSettingsName) << "{ \"showHud\": tru";
  const test::ExpectLogged expected;
  EXPECT_EQ(loadSettings(folder), Settings{});
  EXPECT_EQ(*readFile((folder / kSettingsName).string() + ".bad"), "{ \"showHud\": tru");
  EXPECT_FALSE(std::filesystem::exists(folder / kSettingsName));
}

TEST(Settings, DamageNeverGetsThrough) {
  EXPECT_EQ(settingsFromText("not json"), Settings{});
  EXPECT_EQ(settingsFromText("[]"), Settings{});
  const Settings s = settingsFromText(
      R"({"window": [1, -5], "viewportShare": "wide", "parametersWidth": 1e99, "recentFiles": [3, "x"], "new": 1})");
  EXPECT_EQ(s.window, ivec2(720, 480));
  EXPECT_EQ(s.viewportShare, Settings{}.viewportShare);
  EXPECT_EQ(s.parametersWidth, 900);
  EXPECT_EQ(s.recentFiles, std::vector<std::string>{"x"});
}

TEST(Settings, RecentListsAreShortAndNewestFirst) {
  std::vector<std::string> list;
  for (int i = 0; i < 20; ++i) remember(list, std::to_string(i), 5);
  remember(list, "17", 5);
  EXPECT_EQ(list, (std::vector<std::string>{"17", "19", "18", "16", "15"}));
}

TEST(NumberField, DragsThroughTheSoftRangeAndRoundsLikeAPerson) {
  NumberField f;
  f.softMin = 0, f.softMax = 10, f.hardMax = 1000;
  EXPECT_NEAR(draggedValue(2, 100, 200, f, false), 7, 1e-12);
  EXPECT_NEAR(draggedValue(2, 100, 200, f, true), 2.5, 1e-12);
  EXPECT_EQ(tidiedValue(7.01234, f, false, false), 7.02);
  EXPECT_EQ(tidiedValue(7.01234, f, false, true), 7);
  EXPECT_EQ(tidiedValue(55, f, false, false), 10) << "dragging stops at the soft range";
  f.integer = true;
  EXPECT_EQ(tidiedValue(7.4, f, false, false), 7);
  EXPECT_EQ(numberText(0.1 + 0.2, false), "0.3");
  EXPECT_EQ(numberText(-0.0, false), "0");
  EXPECT_EQ(numberText(1e6, false), "1000000");
  EXPECT_EQ(numberText(1e-7, false), "1e-07");
}

TEST(NumberField, LogarithmicDragsMultiply) {
  NumberField f;
  f.softMin = 0.01, f.softMax = 100, f.logarithmic = true;
  EXPECT_NEAR(draggedValue(1, 100, 200, f, false), 100, 1e-9);
  EXPECT_NEAR(draggedValue(1, -50, 200, f, false), 0.1, 1e-9);
  EXPECT_EQ(tidiedValue(12.3456, f, false, false), 12.3);
  f.softMin = 0;
  EXPECT_EQ(tidiedValue(draggedValue(0.02, -400, 200, f, false), f, false, false), 0)
      << "the lower end of a range from zero is zero";
}

TEST(CameraControl, OrbitKeepsDistanceAndAvoidsThePoles) {
  const scene::Camera camera{{3, 4, 12}, {1, 1, 1}, {0, 1, 0}, 40};
  const scene::Camera turned = orbited(camera, {0.3, -0.2});
  EXPECT_NEAR(glm::length(turned.eye - turned.target), glm::length(camera.eye - camera.target), 1e-9);
  EXPECT_EQ(turned.target, camera.target);
  const scene::Camera back = orbited(turned, {-0.3, 0.2});
  EXPECT_NEAR(glm::length(back.eye - camera.eye), 0, 1e-9);
  const scene::Camera top = orbited(camera, {0, 10});
  EXPECT_LT(glm::dot(glm::normalize(top.eye - top.target), dvec3(0, 1, 0)), 1.0);
}

TEST(CameraControl, PanFollowsThePointerAndDollyKeepsTheTarget) {
  const scene::Camera camera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 90};
  // 90 degrees at distance 10: the picture is 20 high at the target.
  const scene::Camera moved = panned(camera, {0.1, 0});
  EXPECT_NEAR(glm::length(moved.target - dvec3(-2, 0, 0)), 0, 1e-9);
  EXPECT_NEAR(glm::length(moved.eye - dvec3(-2, 0, 10)), 0, 1e-9);
  EXPECT_NEAR(panned(camera, {0, 0.1}).target.y, 2, 1e-9);
  EXPECT_NEAR(dollied(camera, 0.5).eye.z, 5, 1e-9);
  EXPECT_EQ(dollied(camera, 0.5).target, camera.target);
}

}  // namespace
}  // namespace pileus::editor
