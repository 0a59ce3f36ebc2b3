// Animated parameters in the viewport: handles, camera and lights show the current frame and set keys there.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [480, 270], "frames": [1, 20] },
  "nodes": {
    "Ball": { "type": "volume.sphere", "at": [0, 0], "params": { "radius": 0.5, "density": 3,
      "center": { "keys": [[1, [-1.5, 0, 0], "linear"], [11, [1.5, 0, 0], "linear"]] } } },
    "Sun": { "type": "light.sun", "at": [0, 260], "params": {
      "azimuth": { "keys": [[1, 40, "linear"], [11, 60, "linear"]] }, "elevation": 50 } },
    "Camera": { "type": "camera.perspective", "at": [0, 400], "params": {
      "eye": { "keys": [[1, [0, 1, 8], "linear"], [11, [0, 1, 6], "linear"]] } } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [780, 0] }
  },
  "links": [ "Ball.volume -> Render.volumes", "Sun.light -> Render.lights", "Camera.camera -> Render.camera",
             "Render.image -> View.image" ]
}
)";

std::filesystem::path graphFile() {
  const std::filesystem::path path = scratchFolder() / "animated.json";
  std::ofstream(path) << kGraph;
  return path;
}

json keys(const json& t, const char* node, const char* id) {
  return t["document"]["nodes"][node]["params"][id]["keys"];
}
bool settled(const json& t) { return t["complete"] == true; }
Point at(const UiSession& ui, double x, double y) {
  const json r = ui.trace()["rects"]["viewport"];
  return {r[0].get<double>() + x * (r[2].get<double>() - r[0].get<double>()),
          r[1].get<double>() + y * (r[3].get<double>() - r[1].get<double>())};
}
void goTo(const UiSession& ui, int frame) {
  ui.move(ui.center("timeline/ruler"));
  for (int f = ui.trace()["frame"]; f < frame; ++f) ui.key("period");
  for (int f = ui.trace()["frame"]; f > frame; --f) ui.key("comma");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["frame"] == frame && settled(t); }, 40));
}

TEST(AnimatedView, AHandleFollowsTheFrameAndItsDragSetsAKey) {
  UiSession ui({1440, 900}, {graphFile().string()}, {{"showTimeline", true}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  ui.click("header/Ball");
  ui.move(at(ui, 0.5, 0.9));
  ui.key("w");
  ASSERT_TRUE(ui.waitRect("gizmo/axis/1"));
  const Point first = ui.center("gizmo/axis/1");
  goTo(ui, 6);
  const Point middle = ui.center("gizmo/axis/1");
  EXPECT_GT(middle.x, first.x + 60) << "where the ball is at frame 6";
  ui.screenshot("animated-gizmo");
  ui.drag(middle, {middle.x, middle.y - 50});
  ASSERT_TRUE(ui.waitFor([](const json& t) { return keys(t, "Ball", "center").size() == 3; }, 5))
      << keys(ui.trace(), "Ball", "center");
  const json key = keys(ui.trace(), "Ball", "center")[1];
  EXPECT_EQ(key[0], 6);
  EXPECT_NEAR(key[1][0].get<double>(), 0, 1e-9);
  EXPECT_GT(key[1][1].get<double>(), 0.2);
  EXPECT_EQ(key[2], "linear");
  EXPECT_EQ(ui.trace()["undo"], "Move Ball");
  ui.key("ctrl+z");
  EXPECT_TRUE(
      ui.waitFor([](const json& t) { return keys(t, "Ball", "center").size() == 2 && t["undo"] == ""; }, 5))
      << "one drag is one step";
}

TEST(AnimatedView, OverlaysFollowWhatMoves) {
  UiSession ui({1440, 900}, {graphFile().string()}, {{"showTimeline", true}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  // The sun's mark is beside the volumes: in one place, from whichever side a frame is come to.
  const auto markAt = [&](int frame) {
    goTo(ui, frame);
    ui.settle();
    return ui.center("light/Sun").x;
  };
  const double first = markAt(1), forward = markAt(6);
  EXPECT_GT(forward, first + 60);
  markAt(8);
  EXPECT_NEAR(markAt(6), forward, 1);
  ui.screenshot("animated-overlays");
}

TEST(AnimatedView, TheCameraLooksFromItsFrameAndItsMoveSetsAKey) {
  UiSession ui({1440, 900}, {graphFile().string()}, {{"showTimeline", true}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  goTo(ui, 11);
  const Point from = at(ui, 0.5, 0.85);
  ui.input({"keydown", "alt"});
  ui.drag(from, {from.x + 60, from.y});
  ui.input({"keyup", "alt"});
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) {
        return keys(t, "Camera", "eye")[1][1] != json::array({0, 1, 6});
      },
      5));
  const json eye = keys(ui.trace(), "Camera", "eye");
  ASSERT_EQ(eye.size(), 2u) << eye;
  EXPECT_EQ(eye[0][1], json::array({0, 1, 8})) << "the other key stays";
  EXPECT_NEAR(std::hypot(eye[1][1][0].get<double>(), eye[1][1][2].get<double>()), 6, 0.6)
      << "it orbited from where it is at frame 11: " << eye;
  EXPECT_EQ(ui.trace()["undo"], "Orbit camera");
  ui.screenshot("animated-camera");
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        return keys(t, "Camera", "eye")[1][1] == json::array({0, 1, 6}) && t["undo"] == "";
      },
      5));
}

TEST(AnimatedView, ThroughALightADragSetsItsKey) {
  UiSession ui({1440, 900}, {graphFile().string()}, {{"showTimeline", true}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  goTo(ui, 6);
  ui.click("header/Sun");
  ui.move(at(ui, 0.5, 0.85));
  ui.key("l");
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].value("viewport light", "") == "Sun" && settled(t); }, 40));
  const Point from = at(ui, 0.5, 0.85);
  ui.drag(from, {from.x + 40, from.y});
  ASSERT_TRUE(ui.waitFor([](const json& t) { return keys(t, "Sun", "azimuth").size() == 3; }, 5))
      << ui.trace()["undo"];
  const json key = keys(ui.trace(), "Sun", "azimuth")[1];
  EXPECT_EQ(key[0], 6);
  EXPECT_NE(key[1].get<double>(), 50);
  EXPECT_NEAR(key[1].get<double>(), 50, 30);
  EXPECT_EQ(ui.trace()["undo"], "Move Sun");
  ui.screenshot("animated-light");
}

}  // namespace
}  // namespace pileus::test
