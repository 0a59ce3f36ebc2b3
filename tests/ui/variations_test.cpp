// Variations of a document in a real window: taken, blended by typing and by dragging, put back.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

constexpr char kGraph[] = R"({"pileus": 4, "settings": {"size": [96, 54]}, "nodes": {
  "Ball": {"type": "volume.sphere", "at": [0, 0], "params": {"density": 3}},
  "Key": {"type": "light.sun", "at": [0, 130], "params": {"elevation": 20}},
  "Render": {"type": "render.volume", "at": [300, 0], "params": {"samples": 1, "scattering": "single"}},
  "View": {"type": "output.view", "at": [560, 0], "params": {}}},
  "links": ["Ball.volume -> Render.volumes", "Key.light -> Render.lights", "Render.image -> View.image"]})";

TEST(VariationsWindow, TakenBlendedAndPutBack) {
  const std::filesystem::path file = scratchFolder() / "scene.json";
  std::ofstream(file) << kGraph;
  UiSession ui({1440, 900}, {file.string()}, json{{"viewportResolution", 0.25}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ASSERT_TRUE(ui.waitRect("variation/take"));
  ui.click("variation/take");
  ASSERT_TRUE(ui.waitRect("variation/0/use"));

  ui.click("header/Key");
  ASSERT_TRUE(ui.waitRect("param/elevation"));
  ui.doubleClick(ui.center("param/elevation"));
  ui.key("ctrl+a");
  ui.type("80");
  ui.key("Return");
  ASSERT_TRUE(becomes(ui, "Key", "elevation", 80));
  ui.click(ui.emptySpot());
  ASSERT_TRUE(ui.waitRect("variation/take"));
  ui.click("variation/take");
  ASSERT_TRUE(ui.waitRect("variation/blend"));

  // Typed, and one undo step.
  ui.doubleClick(ui.center("variation/blend"));
  ui.key("ctrl+a");
  ui.type("0.5");
  ui.key("Return");
  EXPECT_TRUE(becomes(ui, "Key", "elevation", 50));
  ui.screenshot("variations");
  ui.move(ui.emptySpot());
  ui.key("ctrl+z");
  EXPECT_TRUE(becomes(ui, "Key", "elevation", 80));

  // The first as it was; dragged to, and undone at once.
  ui.click("variation/0/use");
  EXPECT_TRUE(becomes(ui, "Key", "elevation", 20));
  const Point p = ui.center("variation/blend");
  ui.drag(p, {p.x + 60, p.y});
  EXPECT_TRUE(ui.waitFor([&](const json&) { return param(ui, "Key", "elevation") > 20; }));
  ui.move(ui.emptySpot());
  ui.key("ctrl+z");
  EXPECT_TRUE(becomes(ui, "Key", "elevation", 20));
}

}  // namespace
}  // namespace pileus::test
