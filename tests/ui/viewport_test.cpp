// What the viewport shows of a picture and how, in a real window with real input.
#include <cmath>

#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

/// A box before a plane, a sun and a point light.
constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [480, 270] },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "center": [0, 0.4, 0], "size": [1.8, 0.9, 1.4], "density": 2 } },
    "Ground": { "type": "solid.plane", "at": [0, 120], "params": { "center": [0, -0.6, 0] } },
    "Sun": { "type": "light.sun", "at": [0, 260], "params": { "elevation": 50 } },
    "Lamp": { "type": "light.point", "at": [0, 330], "params": { "position": [1.6, 1.2, 1.4], "intensity": 8 } },
    "Camera": { "type": "camera.perspective", "at": [0, 420], "params": { "eye": [2.2, 1.2, 5] } },
    "Map": { "type": "shadow.extinction", "at": [260, 60], "params": { "resolution": 128, "basis": "fourier", "coefficients": 5 } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 2 } },
    "View": { "type": "output.view", "at": [780, 0] }
  },
  "links": [
    "Box.volume -> Map.volumes", "Sun.light -> Map.light", "Ground.solid -> Map.solids",
    "Box.volume -> Render.volumes", "Ground.solid -> Render.solids",
    "Map.light -> Render.lights", "Lamp.light -> Render.lights",
    "Camera.camera -> Render.camera", "Render.image -> View.image"
  ]
}
)";

std::filesystem::path graphFile() {
  const std::filesystem::path path = scratchFolder() / "box.json";
  std::ofstream(path) << kGraph;
  return path;
}

bool complete(const json& t) { return t["complete"] == true && t["notes"].contains("picture"); }
std::string note(const json& t, const char* name) { return t["notes"].value(name, ""); }

struct Corners {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  Point at(double u, double v) const { return {x0 + u * (x1 - x0), y0 + v * (y1 - y0)}; }
};
Corners corners(const UiSession& ui, const std::string& rect) {
  const json r = ui.trace()["rects"][rect];
  return {r[0].get<double>(), r[1].get<double>(), r[2].get<double>(), r[3].get<double>()};
}

TEST(Viewport, ChannelsLayersInspectorRegionAndStills) {
  UiSession ui({1280, 720}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(complete, 60)) << ui.log();
  const json before = ui.trace()["document"];
  ui.move(ui.center("viewport"));

  // A channel alone, and all of them again.
  const auto channel = [&](const std::string& wanted) {
    return ui.waitFor([&](const json& t) { return note(t, "viewport channel") == wanted; }, 5);
  };
  for (const auto& [key, name] :
       {std::pair("shift+r", "R"), std::pair("shift+g", "G"), std::pair("shift+b", "B"),
        std::pair("shift+a", "A"), std::pair("shift+l", "Y")}) {
    ui.key(key);
    EXPECT_TRUE(channel(name)) << key;
  }
  ui.screenshot("60-luminance");
  ui.key("shift+l");
  EXPECT_TRUE(channel("RGB"));

  // Layers: depth and the light's own picture are rendered, the document stays as it is.
  const auto layer = [&](const std::string& wanted) {
    return ui.waitFor(
        [&](const json& t) { return note(t, "viewport layer").starts_with(wanted) && complete(t); }, 30);
  };
  ui.key("Next");
  EXPECT_TRUE(layer("Alpha"));
  ui.key("Next");
  EXPECT_TRUE(layer("Depth"));
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) { return note(t, "viewport depth").find("(white) to") != std::string::npos; }, 5))
      << ui.trace()["notes"];
  ui.screenshot("61-depth");
  ui.key("Prior");
  ui.key("Prior");
  ui.key("Prior");
  EXPECT_TRUE(layer("Light 2, point")) << note(ui.trace(), "viewport layer");
  ui.screenshot("62-light");
  ui.key("Next");
  EXPECT_TRUE(layer("Beauty"));
  EXPECT_EQ(ui.trace()["document"], before);

  // The inspector follows the pointer; a click pins; the area is read as one.
  ui.key("p");
  const auto inspected = [&] { return note(ui.trace(), "inspector"); };
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !note(t, "inspector").empty(); }, 5));
  const Corners picture = corners(ui, "viewport");
  ui.move(picture.at(0.5, 0.5));
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) {
        return note(t, "inspector").starts_with("240 135 ") ||
               note(t, "inspector").find(" ") != std::string::npos;
      },
      5));
  ui.settle();
  const std::string middle = inspected();
  EXPECT_GT(std::atof(middle.substr(middle.find(' ', middle.find(' ') + 1)).c_str()), 0) << middle;
  ui.screenshot("63-inspector");
  ui.click(picture.at(0.4, 0.6));
  const std::string pinned = inspected();
  EXPECT_NE(pinned, middle);
  ui.move(picture.at(0.8, 0.2));
  pause(0.4);
  EXPECT_EQ(inspected(), pinned) << "a pinned sample stays";
  EXPECT_EQ(ui.trace()["document"], before) << "a click moves no camera";
  ui.input({"keydown", "ctrl"});
  ui.drag(picture.at(0.3, 0.3), picture.at(0.6, 0.7));
  ui.input({"keyup", "ctrl"});
  ASSERT_TRUE(ui.waitFor(
      [&](const json& t) { return t["rects"].contains("inspector/unpin") && note(t, "inspector") != pinned; },
      5));
  EXPECT_EQ(ui.trace()["document"], before) << "measuring an area moves no camera";
  ui.screenshot("64-area");
  ui.click("inspector/unpin");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("inspector/unpin"); }, 5));

  // Overlays.
  ui.move(picture.at(0.5, 0.5));
  ui.key("shift+p");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) { return note(t, "histogram").find("texels, peak") != std::string::npos; }, 5));
  ui.key("shift+f");
  EXPECT_TRUE(ui.waitRect("false colour legend", 5));
  ui.key("shift+i");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        return note(t, "hud Bricks").find("resident") != std::string::npos && t["rects"].contains("hud");
      },
      5));
  ASSERT_TRUE(ui.waitRect("histogram", 5));
  const json rects = ui.trace()["rects"];
  const json legend = rects["false colour legend"], histogram = rects["histogram"];
  EXPECT_TRUE(legend[3].get<double>() <= histogram[1].get<double>() ||
              legend[2].get<double>() <= histogram[0].get<double>())
      << "the legend " << legend.dump() << " stands on the histogram " << histogram.dump();
  ui.screenshot("65-false-colours-histogram-hud");
  for (const char* key : {"shift+f", "shift+p", "shift+i", "p"}) ui.key(key);
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        return !t["rects"].contains("hud") && !t["rects"].contains("histogram") &&
               !t["rects"].contains("inspector");
      },
      5));

  // Esc leaves the drawing of a region and pauses nothing; a drag makes one.
  ui.key("shift+c");
  ui.key("Escape");
  ui.key("shift+c");
  ui.drag(picture.at(0.3, 0.3), picture.at(0.7, 0.7));
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["rects"].contains("region") && complete(t); }, 20));
  EXPECT_NEAR(corners(ui, "region").x0, picture.at(0.3, 0.3).x, 3);
  EXPECT_NEAR(corners(ui, "region").y1, picture.at(0.7, 0.7).y, 3);
  EXPECT_EQ(ui.trace()["document"], before) << "drawing a region moves no camera";
  ui.screenshot("66-region");
  ui.key("alt+c");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("region") && complete(t); }, 20));

  // A still keeps its graph: after an edit one key and one drag compare, and the menu brings the graph back.
  ui.key("shift+Return");
  ASSERT_TRUE(ui.waitRect("still/0", 5));
  ui.move(ui.center("viewport"));
  for (int i = 0; i < 4; ++i) ui.key("bracketright");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["document"] != before && complete(t); }, 20));
  ui.key("shift+q");
  ASSERT_TRUE(ui.waitRect("stills/line", 5));
  const Point line = ui.center("stills/line");
  ui.drag(line, {line.x - 90, line.y});
  EXPECT_NEAR(ui.center("stills/line").x, line.x - 90, 3);
  EXPECT_EQ(note(ui.trace(), "stills wipe"), "Picture | Still 1");
  ui.screenshot("67-stills");
  ui.click("still/0", 3);
  ui.click("still/restore");
  EXPECT_TRUE(
      ui.waitFor([&](const json& t) { return t["document"] == before && t["undo"] == "Restore Still 1"; }, 5))
      << ui.trace()["undo"];
  ui.move(ui.center("viewport"));
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"] != before; }, 5)) << "one undo step";
  ui.click("still/0", 3);
  ui.click("still/delete");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) { return !t["rects"].contains("still/0") && !t["rects"].contains("stills/line"); },
      5));

  // Everything is there by mouse.
  ui.click("viewport/more");
  EXPECT_TRUE(ui.waitRect("menu/viewport.region_toggle", 5));
  ui.screenshot("68-more");
  ui.key("Escape");
}

TEST(Viewport, ALockedCameraIsLookedAroundFrom) {
  std::string text = kGraph;
  const std::string eye = R"("eye": [2.2, 1.2, 5])";
  text.replace(text.find(eye), eye.size(), eye + R"(, "lock": true)");
  const std::filesystem::path path = scratchFolder() / "locked.json";
  std::ofstream(path) << text;
  UiSession ui({1280, 720}, {path.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(complete, 60)) << ui.log();
  const json before = ui.trace()["document"];
  const std::string lock = "viewport/button/viewport.lock_camera";
  const auto around = [](const json& t) { return note(t, "looking around") == "Camera"; };
  EXPECT_FALSE(around(ui.trace()));
  const Corners picture = corners(ui, "viewport");
  const json axis = ui.trace()["rects"]["axis/x"];

  // A drag and the wheel leave the node and the history alone.
  ui.drag(picture.at(0.3, 0.85), picture.at(0.45, 0.8));
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return around(t) && complete(t); }, 60)) << ui.trace()["notes"];
  ui.input({"click", "4"});
  EXPECT_NE(ui.trace()["rects"]["axis/x"], axis) << "seen from elsewhere";
  EXPECT_EQ(ui.trace()["document"], before);
  EXPECT_EQ(ui.trace()["undo"], "");
  EXPECT_EQ(ui.trace()["dirty"], false);
  ui.screenshot("73-looking-around");

  // The chip and the key lead back.
  ui.click("viewport/around");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return !around(t) && t["rects"]["axis/x"] == axis; }, 10));
  ui.drag(picture.at(0.3, 0.85), picture.at(0.45, 0.8));
  ASSERT_TRUE(ui.waitFor(around, 10));
  ui.key("BackSpace");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return !around(t) && t["rects"]["axis/x"] == axis; }, 10));

  // Its place can be taken over, as one step.
  ui.drag(picture.at(0.3, 0.85), picture.at(0.45, 0.8));
  ASSERT_TRUE(ui.waitFor(around, 10));
  const json there = ui.trace()["rects"]["axis/x"];
  const auto isThere = [&](const json& t) {  // but for the rounding of its numbers
    return std::abs(t["rects"]["axis/x"][0].get<double>() - there[0].get<double>()) < 2 &&
           std::abs(t["rects"]["axis/x"][1].get<double>() - there[1].get<double>()) < 2;
  };
  ui.key("F3");
  ui.type("Move Camera Here");
  ui.key("Return");
  EXPECT_TRUE(ui.waitFor(
      [&](const json& t) { return !around(t) && t["undo"] == "Move Camera here" && isThere(t); }, 10))
      << ui.trace()["undo"];
  ui.move(picture.at(0.3, 0.85));
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"] == before; }, 10));

  // Unlocked, a drag is an edit of the node again; the padlock renders nothing anew.
  ASSERT_TRUE(ui.waitFor(complete, 60));
  ui.click(lock);
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Unlock Camera"; }, 10));
  EXPECT_TRUE(becomes(ui, "Camera", "lock", json()));
  ui.drag(picture.at(0.3, 0.85), picture.at(0.45, 0.8));
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["undo"] == "Orbit camera" && !around(t); }, 10))
      << ui.trace()["undo"];
}

TEST(Viewport, DraftsOfTheFirstScenePaceThemselves) {
  UiSession ui({1280, 720}, {});
  ASSERT_TRUE(ui.running()) << ui.log();
  if (ui.shows("start/close")) ui.key("Escape");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("picture"); }, 60));
  ui.move(ui.center("viewport"));
  ui.key("shift+i");
  ASSERT_TRUE(ui.waitRect("hud", 10));
  ui.screenshot("70-first-scene");
  const Corners picture = corners(ui, "viewport");
  ui.press(picture.at(0.6, 0.7));
  for (int i = 0; i < 30; ++i) {
    ui.move(picture.at(0.6 - 0.002 * i, 0.7));
    pause(0.06);
  }
  ui.screenshot("71-dragging");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !note(t, "hud Last draft").empty(); }));
  const std::string last = note(ui.trace(), "hud Last draft");
  ui.release();
  RecordProperty("draft", last);
  std::printf("last draft: %s; %s\n", last.c_str(), note(ui.trace(), "hud Draft scale").c_str());
  EXPECT_FALSE(last.empty());
  for (const char* key : {"p", "shift+p", "shift+f"}) ui.key(key);
  ui.move(picture.at(0.5, 0.4));
  ui.settle();
  ui.screenshot("72-first-scene-modes");
}

}  // namespace
}  // namespace pileus::test
