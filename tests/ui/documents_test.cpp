// Documents one after the other, questions upon questions, and what is kept when the program is killed.
#include <signal.h>

#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

fs::path graphFile(const std::string& name, const std::string& size = "[96, 54]", int density = 4) {
  const fs::path file = scratchFolder() / name;
  std::ofstream(file) << R"({ "pileus": 1, "settings": { "size": )" << size
                      << R"(, "frames": [1, 48], "fps": 24, "ocio": "", "workingSpace": "ACEScg" },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": )"
                      << density << R"( } },
    "Sun": { "type": "light.sun", "at": [0, 150],
             "params": { "elevation": { "keys": [[1, 20, "linear"], [48, 70, "linear"]] } } },
    "Render": { "type": "render.volume", "at": [300, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [560, 0] } },
  "links": [ "Box.volume -> Render.volumes", "Sun.light -> Render.lights", "Render.image -> View.image" ] })";
  return file;
}

void open(const UiSession& ui, const fs::path& file) {
  ui.key("ctrl+o");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type(file.string());
  ui.key("Return");
}

TEST(Documents, FiftyInARowEachHaveTheirPicture) {
  // The canvas draws pictures too: nothing that a frame has drawn with goes while it is drawn.
  UiSession ui({1280, 800}, {graphFile("0.json").string()}, json::object({{"showThumbnails", true}}));
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  for (int i = 1; i <= 50; ++i) {
    const fs::path file = graphFile(std::to_string(i) + ".json", "[96, 54]", 1 + i % 7);
    open(ui, file);
    ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["path"] == file.string(); })) << i;
    ASSERT_TRUE(ui.waitFor([](const json& t) {
      return t["complete"] == true && t["notes"].contains("picture") && t["error"] == "";
    })) << i
        << ": " << ui.trace()["error"] << ui.trace()["notes"];
    ASSERT_EQ(ui.trace()["glFaults"], 0) << i;
  }
}

TEST(Documents, QuestionsComeOneAfterTheOther) {
  UiSession ui({1280, 800}, {graphFile("scene.json").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Sun"}; }));
  ui.key("Delete");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["dirty"] == true; }));
  // Over a notice.
  ui.click("menubar/Help");
  ui.click("menu/help.about");
  ASSERT_TRUE(ui.waitRect("dialog/copy"));
  ui.close();
  ASSERT_TRUE(ui.waitRect("dialog/discard", 8)) << "two at once close each other";
  EXPECT_FALSE(ui.shows("dialog/copy"));
  ui.click("dialog/cancel");
  ASSERT_TRUE(ui.waitRect("dialog/copy", 8)) << "and the first is still there";
  ui.key("Escape");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("dialog/copy"); }, 8));
  // Over the file dialog.
  ui.key("ctrl+shift+s");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.close();
  ASSERT_TRUE(ui.waitRect("dialog/discard", 8));
  ui.click("dialog/cancel");
  ASSERT_TRUE(ui.waitRect("browser/cancel", 8));
  ui.click("browser/cancel");
  ui.close();
  ui.click("dialog/discard");
  EXPECT_EQ(ui.waitExit(), 0);
}

TEST(Documents, SettingsSurviveAKill) {
  const fs::path file = graphFile("killed.json");
  fs::path folder;
  {
    UiSession ui({1280, 800}, {file.string()});
    ASSERT_TRUE(ui.running()) << ui.log();
    folder = ui.folder();
    const fs::path settings = folder / "config" / "pileus" / "settings.json";
    ASSERT_TRUE(ui.waitFor(
        [&](const json&) { return textOf(settings).find(file.string()) != std::string::npos; }, 20))
        << textOf(settings);
  }  // killed
  const json kept = json::parse(textOf(folder / "config" / "pileus" / "settings.json"));
  EXPECT_EQ(kept["recentFiles"], json{file.string()});
}

TEST(Documents, QuittingAsksForARunningExport) {
  UiSession ui({1280, 800}, {graphFile("large.json", "[3840, 2160]").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  const fs::path target = scratchFolder() / "large.exr";
  ui.key("ctrl+e");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type(target.string());
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["exporting"] == true; }));
  ui.key("ctrl+q");
  ASSERT_TRUE(ui.waitRect("dialog/exporting/2", 8)) << "quits in the middle of an export";
  ui.click("dialog/exporting/2");
  // Another export does not end the first in silence.
  ui.key("ctrl+e");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type((scratchFolder() / "other.exr").string());
  ui.key("Return");
  ASSERT_TRUE(ui.waitRect("dialog/export running/1", 8));
  ui.click("dialog/export running/1");
  ui.key("ctrl+q");
  ASSERT_TRUE(ui.waitRect("dialog/exporting/0", 8));
  ui.click("dialog/exporting/0");
  EXPECT_EQ(ui.waitExit(120), 0);
  EXPECT_TRUE(fs::exists(target));
}

TEST(Documents, ADragDuringPlaybackSetsOneKey) {
  UiSession ui({1280, 800}, {graphFile("animated.json").string()}, json::object({{"showTimeline", true}}));
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitRect("param/elevation"));
  const Point slider = ui.center("param/elevation");
  ui.move(ui.emptySpot());
  ui.click("timeline/play");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == 1; }));
  ui.press(slider);
  for (int i = 0; i < 4; ++i) {
    ui.dragTo({slider.x + 5 * i, slider.y}, {slider.x + 5 * (i + 1), slider.y});
    pause(0.1);  // frames pass
  }
  ui.release();
  const json t = ui.trace();
  const json keys = t["document"]["nodes"]["Sun"]["params"]["elevation"]["keys"];
  EXPECT_LE(keys.size(), 3u) << keys;
  EXPECT_EQ(t["undo"], "Set Sun.elevation");
  EXPECT_EQ(t["playing"], 0) << "it is the frame that was seen";
}

TEST(Documents, PlaybackOnASlowMachineShowsPictures) {
  // A draft takes several of these frames, each longer than the patience of anyone.
  std::string nodes, links;
  for (int i = 0; i < 12; ++i) {
    const std::string n = std::to_string(i);
    nodes +=
        R"("S)" + n + R"(": { "type": "light.sun", "at": [0, )" + std::to_string(150 + 120 * i) +
        R"(], "params": { "elevation": { "keys": [[1, 20, "linear"], [240, 70, "linear"]] }, "azimuth": )" +
        std::to_string(30 * i) + R"( } }, "M)" + n + R"(": { "type": "shadow.ray_march", "at": [150, )" +
        std::to_string(150 + 120 * i) + "] },";
    links += R"("S)" + n + R"(.light -> M)" + n + R"(.light", "Box.volume -> M)" + n + R"(.volumes", "M)" +
             n + R"(.light -> Render.lights",)";
  }
  const fs::path file = scratchFolder() / "slow.json";
  std::ofstream(file) << R"({ "pileus": 1, "settings": { "size": [640, 360], "frames": [1, 240], "fps": 24 },
  "nodes": { "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 20 } },)"
                      << nodes << R"("Render": { "type": "render.volume", "at": [300, 0] },
    "View": { "type": "output.view", "at": [560, 0] } },
  "links": [)" << links
                      << R"("Box.volume -> Render.volumes", "Render.image -> View.image" ] })";
  UiSession ui({1280, 800}, {file.string()}, json::object({{"showTimeline", true}}), {},
               {"PILEUS_UI_FRAME_MS=450"});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("timeline/play");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == 1; }));
  const auto answered = ui.trace()["answered"].get<int>();
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["answered"].get<int>() >= answered + 3; }, 30))
      << "every frame takes the last one's picture away";
}

TEST(Documents, MissingFilesAreListedAndFoundTogether) {
  const fs::path folder = scratchFolder();
  const fs::path file = folder / "missing.json";
  std::ofstream(file) << R"({ "pileus": 2, "nodes": {
    "Smoke": { "type": "volume.vdb_file", "at": [0, 0], "params": { "file": "/nowhere/old/smoke.vdb" } },
    "Rig": { "type": "group", "at": [0, 150], "graph": { "nodes": {
      "Fire": { "type": "volume.vdb_file", "at": [0, 0], "params": { "file": "fire_####.vdb" } } } } },
    "Gone": { "type": "volume.vdb_file", "at": [0, 300], "params": {
      "file": { "keys": [[1, "gone.vdb"], [9, "old/smoke.vdb"]] } } } } })";
  fs::create_directories(folder / "moved" / "deep");
  for (const char* name : {"moved/smoke.vdb", "moved/deep/smoke.vdb", "moved/deep/fire_0012.vdb"})
    std::ofstream(folder / name) << "not looked into";
  UiSession ui({1280, 800}, {file.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["message"] == "4 files are missing"; }))
      << ui.trace()["message"];
  ui.click("menubar/File");
  ui.click("menu/file.missing");
  ASSERT_TRUE(ui.waitRect("dialog/relink"));
  EXPECT_EQ(ui.trace()["notes"]["missing Smoke.file"], "/nowhere/old/smoke.vdb");
  EXPECT_EQ(ui.trace()["notes"]["missing Rig/Fire.file"], (folder / "fire_####.vdb").string());
  ui.screenshot("documents-missing");
  ui.click("dialog/relink");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type((folder / "moved").string());
  ui.click("browser/ok");
  EXPECT_TRUE(becomes(ui, "Smoke", "file", (folder / "moved" / "smoke.vdb").string()))
      << param(ui, "Smoke", "file");
  const json t = ui.trace();
  EXPECT_EQ(t["document"]["nodes"]["Rig"]["graph"]["nodes"]["Fire"]["params"]["file"],
            (folder / "moved" / "deep" / "fire_####.vdb").string());
  EXPECT_EQ(t["undo"], "Find missing files");
  // What is left is listed again.
  ASSERT_TRUE(ui.waitRect("dialog/relink"));
  EXPECT_TRUE(ui.trace()["notes"].contains("missing Gone.file, frame 1"));
  EXPECT_FALSE(ui.trace()["notes"].contains("missing Gone.file, frame 9")) << "files of keys, too";
  EXPECT_FALSE(ui.trace()["notes"].contains("missing Smoke.file"));
  ui.click("dialog/close");
  ui.move(ui.emptySpot());
  ui.key("ctrl+z");
  EXPECT_TRUE(becomes(ui, "Smoke", "file", "/nowhere/old/smoke.vdb"));
  EXPECT_EQ(ui.trace()["undo"], "") << "one step";
}

TEST(Documents, WhatArrivesInTheMiddleOfADragStays) {
  PILEUS_NEEDS_DATA();
  UiSession ui({1280, 800}, {graphFile("drag.json").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ui.click("menubar/File");
  ui.click("menu/file.import_vdb");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type((*dataFolder() / "vdb" / "smoke1.vdb").string());
  ui.settle();
  const Point header = ui.center("header/Sun");
  ui.key("Return");
  ui.press(header);
  ui.dragTo(header, {header.x + 30, header.y + 20});
  pause(3);  // it is read by now
  ui.dragTo({header.x + 30, header.y + 20}, {header.x + 60, header.y + 30});
  ui.release();
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    for (const auto& [name, node] : t["document"]["nodes"].items())
      if (node["type"] == "volume.vdb_file") return true;
    return false;
  })) << ui.trace()["undo"];
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["selection"].size() == 1; }))
      << "the volume, whose notes say what was found";
}

}  // namespace
}  // namespace pileus::test
