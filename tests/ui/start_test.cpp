// The first minutes and the safety of work in a real window: start view, tour, volumes that become clouds,
// saving, and what is left after a kill.
#include "nodes/file/serialize.h"
#include "renderer/image/exr.h"
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [96, 54] },
  "nodes": {
    "Ball": { "type": "volume.sphere", "at": [0, 0], "params": { "density": 3 } },
    "Sun": { "type": "light.sun", "at": [0, 130], "params": {} },
    "Render": { "type": "render.volume", "at": [300, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [560, 0], "params": {} }
  },
  "links": ["Ball.volume -> Render.volumes", "Sun.light -> Render.lights", "Render.image -> View.image"]
}
)";

fs::path graphFile(const std::string& name = "scene.json") {
  const fs::path path = scratchFolder() / name;
  std::ofstream(path) << kGraph;
  return path;
}

bool hasRect(const json& t, const std::string& name) { return t["rects"].contains(name); }

/// Drags a slider of the Sun, so that there is something to save.
void change(const UiSession& ui) {
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitRect("param/elevation"));
  const Point p = ui.center("param/elevation");
  ui.drag(p, {p.x + 12, p.y});  // three times fit below its end
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["dirty"] == true; }));
  ui.move(ui.emptySpot());
}

std::size_t recoveryFiles(const UiSession& ui) {
  std::size_t count = 0;
  std::error_code ec;
  for (fs::recursive_directory_iterator it(ui.folder() / "state" / "pileus" / "recovery", ec), end;
       !ec && it != end; it.increment(ec))
    if (it->path().extension() == ".json" && it->path().filename() != "about.json") ++count;
  return count;
}

bool waitUntil(const std::function<bool()>& condition, double seconds = 15) {
  for (double t = 0; t < seconds; t += 0.1) {
    if (condition()) return true;
    pause(0.1);
  }
  return false;
}

TEST(Start, GalleryRecentFilesAndTour) {
  const fs::path kept = graphFile("kept.json");
  UiSession ui({1440, 900}, {},
               {{"showStart", true}, {"recentFiles", {kept.string(), "/nowhere/gone.json"}}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitRect("start")) << ui.log();
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Clouds"); }))
      << "the default preset lies below";
  ui.screenshot("start-view");
  for (const char* preset : {"default.json", "cumulus.json", "smoke-column.json", "light-shafts.json",
                             "two-lights.json", "sea-of-clouds.json"})
    EXPECT_TRUE(ui.waitRect(std::string("start/preset/") + preset)) << preset;

  // A click beside it closes it, Help opens it again, Esc closes it.
  ui.click(Point{8, 500});
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !hasRect(t, "start"); }));
  const auto reopen = [&] {
    ui.click("menubar/Help");
    ASSERT_TRUE(ui.waitRect("menu/help.start"));
    ui.click("menu/help.start");
    ASSERT_TRUE(ui.waitRect("start"));
  };
  reopen();
  ui.key("Escape");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !hasRect(t, "start"); }));
  EXPECT_FALSE(ui.trace()["notes"].contains("paused")) << "Esc closed the view and nothing else";

  // A missing recent file does nothing; one that is there opens.
  reopen();
  ui.click("start/recent/1");
  EXPECT_TRUE(hasRect(ui.trace(), "start"));
  ui.click("start/recent/0");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["path"] == kept.string() && !hasRect(t, "start"); }));

  // A preset.
  reopen();
  ui.click("start/preset/cumulus.json");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Cloud Medium"); }));

  // The tour, forward, back and to its end.
  reopen();
  ui.click("start/tour");
  const auto at = [&](const std::string& title) {
    return ui.waitFor([&](const json& t) { return t["notes"].value("tour", "") == title; }, 8);
  };
  ASSERT_TRUE(at("The picture"));
  ui.settle();
  ui.screenshot("tour-1");
  ui.click("tour/next");
  ASSERT_TRUE(at("The graph"));
  ui.settle();
  ui.screenshot("tour-2");
  ui.click("tour/back");
  ASSERT_TRUE(at("The picture"));
  ui.key("Return");
  ASSERT_TRUE(at("The graph"));
  ui.settle();
  ui.click("tour/next");
  ASSERT_TRUE(at("The parameters"));
  ui.settle();
  ui.click("tour/next");
  ASSERT_TRUE(at("Compare with the truth"));
  ui.settle();
  ui.screenshot("tour-4");
  ui.click("tour/next");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["notes"].contains("tour"); }));

  // The switch is remembered.
  reopen();
  ui.click("start/show");
  ui.key("Escape");
  ui.move(ui.emptySpot());
  ui.key("ctrl+q");
  EXPECT_EQ(ui.waitExit(), 0) << ui.log();
  const json settings = json::parse(textOf(ui.folder() / "config" / "pileus" / "settings.json"));
  EXPECT_EQ(settings["showStart"], false);
  EXPECT_EQ(settings["tourSeen"], true);
}

TEST(Start, AVolumeBecomesACloudInOneStep) {
  PILEUS_NEEDS_DATA();
  UiSession ui({1280, 800}, {(*dataFolder() / "vdb" / "smoke1.vdb").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("smoke1"); }, 40))
      << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("picture"); }, 60)) << ui.log();
  ui.screenshot("vdb-opened");
  const json t = ui.trace();
  EXPECT_EQ(t["error"], "");
  EXPECT_EQ(t["undo"], "Import smoke1.vdb");
  EXPECT_EQ(t["selection"], json{"smoke1"}) << "the volume, whose notes say what was guessed";
  EXPECT_NE(t["document"]["nodes"]["smoke1 Medium"]["params"]["extinction"], nullptr);
  EXPECT_TRUE(t["document"]["nodes"].contains("Sky")) << "it is lit by a sky";
  ui.move(ui.emptySpot());
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([](const json& now) { return now["document"]["nodes"].empty(); })) << "one step";
}

TEST(Start, APictureOfLightLightsTheScene) {
  image::Image sky;
  sky.size = {64, 32};
  sky.layers.push_back({"", 4, std::vector<float>(64 * 32 * 4, 0.5f)});
  const fs::path file = scratchFolder() / "dome.exr";
  ASSERT_TRUE(image::writeExr(file, sky));
  UiSession ui({1280, 800}, {graphFile("lit.json").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ui.click("menubar/File");
  ui.click("menu/file.import_vdb");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type(file.string());
  ui.settle();
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("dome"); }, 40))
      << ui.log();
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"dome"}; }));
  ui.finishPicture();
  ui.screenshot("environment-dropped");
  EXPECT_EQ(ui.trace()["error"], "");
}

TEST(Start, SavesSafelyAndAsksBeforeItReplacesAStrangersWork) {
  const fs::path file = graphFile();
  UiSession ui({1280, 800}, {file.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  change(ui);
  ui.key("ctrl+s");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["dirty"] == false; }));
  EXPECT_TRUE(waitUntil([&] { return fs::exists(ui.folder() / "cache" / "pileus" / "thumbnails"); }))
      << "a small picture is kept";

  // Another program writes the file.
  const std::string foreign = std::string(kGraph) + "\n";
  pause(0.05);
  std::ofstream(file) << foreign;
  change(ui);
  ui.key("ctrl+s");
  ASSERT_TRUE(ui.waitRect("dialog/changed/2")) << ui.trace()["message"];
  ui.screenshot("changed-on-disk");
  ui.click("dialog/changed/2");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !hasRect(t, "dialog/changed/2"); }));
  EXPECT_EQ(textOf(file), foreign) << "cancelled: nothing was written";
  EXPECT_EQ(ui.trace()["dirty"], true);
  ui.key("ctrl+s");
  ASSERT_TRUE(ui.waitRect("dialog/changed/0"));
  ui.click("dialog/changed/0");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["dirty"] == false; }));
  EXPECT_NE(textOf(file), foreign);

  // The folder goes: the message says so, and the work is still there.
  change(ui);
  fs::remove_all(file.parent_path());
  ui.expectLogged("scene.json: cannot be written");
  ui.key("ctrl+s");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("dialog error"); }))
      << ui.trace()["message"];
  EXPECT_EQ(ui.trace()["dirty"], true);
}

TEST(Start, WorkSurvivesAKillAndATermination) {
  const fs::path file = graphFile();
  const std::string before = textOf(file);
  fs::path home;
  double elevation = 0;
  {
    UiSession ui({1280, 800}, {file.string()});
    ASSERT_TRUE(ui.running()) << ui.log();
    home = ui.folder();
    ui.finishPicture();
    change(ui);
    elevation = ui.trace()["document"]["nodes"]["Sun"]["params"]["elevation"];
    EXPECT_EQ(recoveryFiles(ui), 0u) << "not while one works";
    ASSERT_TRUE(waitUntil([&] { return recoveryFiles(ui) == 1; })) << "some seconds after the last change";
    EXPECT_EQ(textOf(file), before);
  }  // SIGKILL
  {
    UiSession ui({1440, 900}, {}, json::object(), home);
    ASSERT_TRUE(ui.running()) << ui.log();
    ASSERT_TRUE(ui.waitRect("start/lost/0/open")) << "offered even though the start view is off";
    ui.screenshot("recovery-offer");
    ui.click("start/lost/0/open");
    ASSERT_TRUE(ui.waitFor([&](const json& t) {
      return t["document"]["nodes"].contains("Sun") &&
             t["document"]["nodes"]["Sun"]["params"].value("elevation", 0.0) == elevation;
    }));
    EXPECT_EQ(ui.trace()["dirty"], true);
    EXPECT_EQ(ui.trace()["path"], file.string());
    EXPECT_EQ(textOf(file), before) << "the file is touched by saving only";
    // Ended from outside: what is unsaved is kept at once.
    ::kill(ui.process(), SIGTERM);
    EXPECT_EQ(ui.waitExit(), 0) << ui.log();
    EXPECT_EQ(recoveryFiles(ui), 2u) << "as it was opened and as it was left";
  }
  {
    // A file that is asked for is what one sees: its picture, and a notice of the work.
    UiSession ui({1440, 900}, {graphFile("other.json").string()}, {{"showStart", true}}, home);
    ASSERT_TRUE(ui.running()) << ui.log();
    ASSERT_TRUE(ui.waitRect("toast/1/button"));
    EXPECT_TRUE(ui.trace()["message"].get<std::string>().starts_with("Unsaved work of scene.json"))
        << ui.trace()["message"];
    EXPECT_FALSE(ui.shows("start")) << "nothing covers the file";
    ui.screenshot("recovery-notice");
    ui.click("toast/1/button");
    ASSERT_TRUE(ui.waitRect("start/lost/0/open"));
    ui.key("Escape");
    ui.key("ctrl+q");
    EXPECT_EQ(ui.waitExit(), 0) << ui.log();
    EXPECT_EQ(recoveryFiles(ui), 2u) << "it stays until it is opened or discarded";
  }
  {
    UiSession ui({1440, 900}, {}, json::object(), home);
    ASSERT_TRUE(ui.running()) << ui.log();
    ASSERT_TRUE(ui.waitRect("start/lost/0/discard"));
    ui.click("start/lost/0/discard");
    EXPECT_TRUE(ui.waitFor([](const json& t) { return !hasRect(t, "start/lost/0/discard"); }))
        << ui.trace()["rects"]["start/lost/0/discard"] << ui.trace()["message"];
    ui.screenshot("recovery-discarded");
    EXPECT_EQ(recoveryFiles(ui), 0u);
    ui.key("Escape");
    ui.key("ctrl+q");
    EXPECT_EQ(ui.waitExit(), 0) << ui.log();
  }
}

TEST(Start, ADamagedFileKeepsTheDocument) {
  const fs::path bad = scratchFolder() / "bad.json";
  std::ofstream(bad) << "{ \"pileus\": 1, \"nodes\": ";
  UiSession ui({1280, 800}, {bad.string()});
  ui.expectLogged("bad.json: line 1");
  ASSERT_TRUE(ui.running()) << ui.log();
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("dialog error"); }));
  ui.key("Return");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["notes"].contains("dialog error"); }));
}

}  // namespace
}  // namespace pileus::test
