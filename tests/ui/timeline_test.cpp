// The timeline in a real window: scrubbing, keys, playing, range and speed.
#include "renderer/image/exr.h"
#include "renderer/image/metrics.h"
#include "tests/ui/ui_session.h"

#include <set>

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

constexpr char kSettings[] = R"("settings": { "frames": [1, 48], "fps": 24 })";

fs::path graphFile() {
  const fs::path file = scratchFolder() / "timeline.json";
  std::ofstream(file) << R"({ "pileus": 1, )" << kSettings << R"(, "links": [], "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": { "keys": [
      [1, 1, "linear"], [25, 4, "linear"] ] } } },
    "Sun": { "type": "light.sun", "at": [260, 0] } } })";
  return file;
}

const json kOpen = {{"showTimeline", true}};

struct Rect {
  double left, top, right, bottom;
};
Rect rectOf(const UiSession& ui, const std::string& name) {
  EXPECT_TRUE(ui.waitRect(name));
  const json r = ui.trace()["rects"][name];
  return {r[0].get<double>(), r[1].get<double>(), r[2].get<double>(), r[3].get<double>()};
}

TEST(TimelineWindow, ScrubbingShowsAnotherFrameAndChangesNothing) {
  UiSession ui({1440, 900}, {graphFile().string()}, kOpen);
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitRect("timeline/ruler"));
  EXPECT_EQ(ui.trace()["frame"], 1);
  const Rect ruler = rectOf(ui, "timeline/ruler");
  const double y = 0.5 * (ruler.top + ruler.bottom);
  ui.drag({ruler.left + 60, y}, {0.5 * (ruler.left + ruler.right), y});
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["frame"] > 15 && t["frame"] == t["pictureFrame"]; }))
      << ui.trace()["frame"];
  EXPECT_FALSE(ui.trace()["dirty"].get<bool>());
  EXPECT_EQ(ui.trace()["undo"], "");
  const int frame = ui.trace()["frame"];
  ui.key("period");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["frame"] == frame + 1; }));
  ui.key("comma");
  ui.key("comma");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["frame"] == frame - 1; }));
  ui.key("Home");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["frame"] == 1; }));
  ui.key("greater");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["frame"] == 25; })) << "the next key";
  ui.screenshot("timeline");
}

TEST(TimelineWindow, KeysAreDraggedSetAndDeletedInOneStepEach) {
  UiSession ui({1440, 900}, {graphFile().string()}, kOpen);
  ASSERT_TRUE(ui.running()) << ui.log();
  const Point key = ui.center("key/Box.density/25");
  const Rect first = rectOf(ui, "key/Box.density/1");
  const double perFrame = (key.x - 0.5 * (first.left + first.right)) / 24;
  ui.drag(key, {key.x + 5 * perFrame, key.y});
  EXPECT_TRUE(ui.waitRect("key/Box.density/30", 5));
  EXPECT_EQ(ui.trace()["undo"], "Move key");
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitRect("key/Box.density/25", 5));
  EXPECT_EQ(ui.trace()["undo"], "") << "the whole drag was one step";

  ui.key("i");
  ui.key("period");
  ui.key("i");
  EXPECT_TRUE(ui.waitRect("key/Box.density/2", 5)) << "I over the timeline";
  ui.click("key/Box.density/2");
  ui.screenshot("timeline_keys");
  ui.key("Delete");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("key/Box.density/2"); }, 5));
  EXPECT_EQ(ui.trace()["undo"], "Delete key");

  ui.click("key/Box.density/25", 3);
  ui.click("timeline/menu/constant");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Interpolate key"; }, 5));
}

TEST(TimelineWindow, KeysGoThroughTheClipboard) {
  UiSession ui({1440, 900}, {graphFile().string()}, kOpen);
  ASSERT_TRUE(ui.running()) << ui.log();
  const auto keys = [](const json& t) { return t["document"]["nodes"]["Box"]["params"]["density"]["keys"]; };
  ui.move(ui.center("timeline/keys"));
  ui.key("a");
  ui.key("ctrl+c");
  ui.click("timeline/frame", 1);
  ui.move(ui.center("timeline/keys"));
  ui.key("Home");
  for (int i = 0; i < 5; ++i) ui.key("period");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["frame"] == 6; }, 5));
  ui.key("ctrl+v");
  EXPECT_TRUE(ui.waitFor(
      [&](const json& t) {
        return t["undo"] == "Paste 2 keys at frame 6" &&
               keys(t) == json::parse(R"([[1,1,"linear"],[6,1,"linear"],[25,4,"linear"],[30,4,"linear"]])");
      },
      5))
      << keys(ui.trace());
  EXPECT_EQ(ui.trace()["notes"]["timeline row 1"], "Box \xc2\xb7 Density");
  ui.screenshot("timeline_pasted");
  ui.key("ctrl+x");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["undo"] == "Cut 2 keys" && keys(t).size() == 2; }, 5));
  ui.key("ctrl+z");
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["undo"] == "" && keys(t).size() == 2; }, 5))
      << "one step each";

  // Nodes on the clipboard are no keys.
  ui.expectLogged("the clipboard holds no keys");
  ui.click("header/Box");
  ui.move(ui.emptySpot());
  ui.key("ctrl+c");
  ui.move(ui.center("timeline/keys"));
  ui.key("ctrl+v");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        return t["message"].get<std::string>().find("the clipboard holds no keys") != std::string::npos;
      },
      5))
      << ui.trace()["message"];
  ui.screenshot("timeline_refused");
  EXPECT_EQ(ui.trace()["undo"], "");
}

TEST(TimelineWindow, PlaysInRealTimeAndStops) {
  UiSession ui({1440, 900}, {graphFile().string()}, kOpen);
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("timeline/play");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == 1; }));
  // Frames since one that was seen, the loop counted. A busy machine may show one late, but not every time.
  const auto now = [] { return std::chrono::steady_clock::now(); };
  double off = 48;
  for (int attempt = 0; attempt < 4 && off > 6; ++attempt) {
    const int from = ui.trace()["frame"];
    const auto start = now();
    pause(1.2);
    const int to = ui.trace()["frame"];
    const double seconds = std::chrono::duration<double>(now() - start).count();
    off = std::abs((to - from + 48) % 48 - std::fmod(seconds * 24, 48));
    off = std::min(off, 48 - off);
  }
  EXPECT_LE(off, 6) << "frames ahead or behind";
  EXPECT_FALSE(ui.trace()["dirty"].get<bool>());
  EXPECT_EQ(ui.trace()["undo"], "");
  ui.move(ui.center("timeline/ruler"));
  ui.key("k");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == 0; }));
  ui.settle();
  const int stopped = ui.trace()["frame"];
  pause(1);
  const double before = cpuSeconds(ui.process());
  pause(3);
  EXPECT_LT((cpuSeconds(ui.process()) - before) / 3, 0.03) << "the window sleeps";
  EXPECT_EQ(ui.trace()["frame"], stopped);
  ui.key("j");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == -1; }));
  ui.key("l");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == 1; }));
}

TEST(TimelineWindow, RangeAndSpeedAreTyped) {
  UiSession ui({1440, 900}, {graphFile().string()}, kOpen);
  ASSERT_TRUE(ui.running()) << ui.log();
  const auto enter = [&](const std::string& rect, const std::string& text) {
    ui.click(ui.center(rect), {"ctrl"});
    ui.type(text);
    ui.key("Return");
  };
  enter("timeline/end", "72");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        return t["document"]["settings"]["frames"] == json{1, 72};
      },
      5))
      << ui.trace()["document"]["settings"];
  enter("timeline/fps", "30");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["settings"]["fps"] == 30; }, 5));
  ui.key("ctrl+z");
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == ""; }, 5)) << "one step each";
  enter("timeline/frame", "12");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["frame"] == 12; }, 5));
}

TEST(TimelineWindow, EscTakesADragBack) {
  UiSession ui({1440, 900}, {graphFile().string()}, kOpen);
  ASSERT_TRUE(ui.running()) << ui.log();
  const Point key = ui.center("key/Box.density/25");
  ui.press(key);
  ui.dragTo(key, {key.x + 120, key.y});
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("key/Box.density/25"); }, 5));
  ui.key("Escape");
  EXPECT_TRUE(ui.waitRect("key/Box.density/25", 5));
  ui.input({"mouseup", "1"});
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == ""; }, 5)) << ui.trace()["undo"];
}

TEST(TimelineWindow, PicturesOnNodesFollowTheFrame) {
  const fs::path file = scratchFolder() / "pictures.json";
  std::ofstream(file) << R"({ "pileus": 1, "settings": { "size": [64, 36], "frames": [1, 48] }, "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": { "keys": [
      [1, 0.2, "linear"], [48, 6, "linear"] ] } } },
    "Sun": { "type": "light.sun", "at": [0, 260] },
    "Map": { "type": "shadow.extinction", "at": [260, 260], "params": { "resolution": 64 } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [780, 0] } },
    "links": [ "Box.volume -> Map.volumes", "Sun.light -> Map.light", "Box.volume -> Render.volumes",
               "Map.light -> Render.lights", "Render.image -> View.image" ] })";
  UiSession ui({1440, 900}, {file.string()}, {{"showTimeline", true}, {"showThumbnails", true}});
  ASSERT_TRUE(ui.running()) << ui.log();
  const auto show = [](int frame) {
    return [=](const json& t) {
      const std::string f = std::to_string(frame);
      return t["frame"] == frame && t["notes"].value("thumbnail Render", "") == f &&
             t["notes"].value("thumbnail Map", "") == f;
    };
  };
  ASSERT_TRUE(ui.waitFor(show(1), 60)) << ui.trace()["notes"];
  ui.screenshot("timeline_thumbnails_1");
  const Rect ruler = rectOf(ui, "timeline/ruler");
  const double y = 0.5 * (ruler.top + ruler.bottom);
  ui.drag({ruler.left + 60, y}, {ruler.left + 0.9 * (ruler.right - ruler.left), y});
  const int rest = ui.trace()["frame"];
  EXPECT_GT(rest, 30);
  EXPECT_TRUE(ui.waitFor(show(rest), 20)) << "at rest: " << ui.trace()["notes"];
  ui.screenshot("timeline_thumbnails_2");
  ui.click("timeline/play");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == 1; }));
  std::set<std::string> seen, frames;
  for (int i = 0; i < 60; ++i, pause(0.05)) {
    const json t = ui.trace();
    seen.insert(t["notes"].value("thumbnail Render", ""));
    frames.insert(t["frame"].dump());
  }
  EXPECT_GE(seen.size(), 2u) << "they go along while it plays";
  EXPECT_LE(seen.size(), 6u) << "but not with every frame";
  EXPECT_GT(frames.size(), 6u);
  ui.move(ui.center("timeline/ruler"));
  ui.key("k");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["playing"] == 0; }));
  EXPECT_TRUE(ui.waitFor(show(ui.trace()["frame"]), 20)) << ui.trace()["notes"];
}

TEST(TimelineWindow, APictureOfItsFrameIsExported) {
  const fs::path folder = scratchFolder(), file = folder / "moving.json";
  std::ofstream(file) << R"({ "pileus": 1, "settings": { "size": [64, 36], "frames": [1, 48] }, "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": { "keys": [
      [1, 0.2, "linear"], [25, 6, "linear"] ] } } },
    "Sun": { "type": "light.sun", "at": [0, 200] },
    "Map": { "type": "shadow.extinction", "at": [260, 100], "params": { "resolution": 64 } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 2 } },
    "View": { "type": "output.view", "at": [780, 0] } },
    "links": [ "Box.volume -> Map.volumes", "Sun.light -> Map.light", "Box.volume -> Render.volumes",
               "Map.light -> Render.lights", "Render.image -> View.image" ] })";
  UiSession ui({1440, 900}, {file.string()}, kOpen);
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.move(ui.center("timeline/ruler"));
  ui.key("greater");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["frame"] == 25 && t["complete"] == true; }, 60));
  ui.screenshot("timeline-picture");
  ui.key("ctrl+e");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type((folder / "window.exr").string());
  ui.key("Return");
  ASSERT_TRUE(
      ui.waitFor([](const json& t) { return t["message"].get<std::string>().starts_with("Exported"); }, 60))
      << ui.trace()["message"];
  const auto render = [&](const std::string& frame) {
    const fs::path out = folder / ("frame" + frame + ".exr");
    const RunResult r = pileus({"render", file, "-o", out, "--frames", frame});
    EXPECT_EQ(r.exitCode, 0) << r.err;
    return image::readExr(out);
  };
  const auto window = image::readExr(folder / "window.exr"), at25 = render("25"), at1 = render("1");
  ASSERT_TRUE(window && at25 && at1);
  const auto same = image::compare(*window, *at25), other = image::compare(*window, *at1);
  ASSERT_TRUE(same && other);
  EXPECT_LT(same->maximum, 1e-3) << "the picture of frame 25";
  EXPECT_GT(other->maximum, 0.02) << "and not that of frame 1";
}

}  // namespace
}  // namespace pileus::test
