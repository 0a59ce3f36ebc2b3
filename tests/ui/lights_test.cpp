// The list of lights and the mixer in a real window, in both themes and at both scales.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

constexpr char kGraph[] = R"({"pileus": 3, "settings": {"size": [96, 54]}, "nodes": {
  "Ball": {"type": "volume.sphere", "at": [0, 0], "params": {"density": 3}},
  "Key": {"type": "light.sun", "at": [0, 130], "params": {"elevation": 30, "group": "Suns"}},
  "Fill": {"type": "light.sun", "at": [0, 260], "params": {"azimuth": -120, "color": [0.3, 0.5, 1]}},
  "Lamp": {"type": "light.point", "at": [0, 390], "params": {"position": [-2, 1, 1]}},
  "Render": {"type": "render.volume", "at": [300, 0], "params": {"samples": 1, "grid_cells": 16}},
  "View": {"type": "output.view", "at": [560, 0], "params": {}}},
  "links": ["Ball.volume -> Render.volumes", "Key.light -> Render.lights", "Fill.light -> Render.lights",
    "Lamp.light -> Render.lights", "Render.image -> View.image"]})";

std::string state(const json& t) { return t["notes"].value("lights/state", ""); }

struct Look {
  const char* theme;
  ivec2 size;
  const char* scale;
};

class LightsWindow : public testing::TestWithParam<Look> {};

TEST_P(LightsWindow, ListMixAndApply) {
  const Look look = GetParam();
  const fs::path file = scratchFolder() / "scene.json";
  std::ofstream(file) << kGraph;
  UiSession ui(look.size, {file.string()}, json{{"theme", look.theme}, {"viewportResolution", 0.25}}, {},
               {std::string("PILEUS_UI_SCALE=") + look.scale});
  const auto shot = [&](const std::string& name) {
    ui.settle();
    ui.screenshot(fmt::format("lights-{}-{}-{}", look.theme, look.scale, name));
  };
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ui.move(ui.emptySpot());
  ui.key("alt+8");
  ASSERT_TRUE(ui.waitRect("lights/name/Key"));

  // A group is typed; a click on a name selects the node.
  ui.click("lights/group/Fill");
  ui.type("Suns");
  ui.key("Return");
  EXPECT_TRUE(becomes(ui, "Fill", "group", "Suns"));
  ui.click("lights/name/Lamp");
  EXPECT_TRUE(ui.waitRect("param/intensity"));
  // Mute is of the viewport alone.
  ui.click("lights/mute/Lamp");
  ui.finishPicture();
  shot("list");
  EXPECT_EQ(param(ui, "Lamp", "intensity"), json());
  ui.click("lights/mute/Lamp");

  // The mixer: layers, then at once.
  ui.click("lights/mixer");
  ASSERT_TRUE(ui.waitRect("mixer/exposure/Suns"));
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return state(t).empty() && t["rects"].contains("mixer/mute/Lamp"); }, 60));
  const Point p = ui.center("mixer/exposure/Suns");
  ui.drag(p, {p.x + 30, p.y});
  EXPECT_TRUE(
      ui.waitFor([](const json& t) { return state(t).starts_with("The viewport shows the mix"); }, 60));
  ui.click("mixer/solo/Suns");
  shot("mixer");
  ui.click("mixer/solo/Suns");
  ui.click("lights/apply");
  EXPECT_TRUE(ui.waitFor([&](const json&) {
    const json key = param(ui, "Key", "irradiance"), fill = param(ui, "Fill", "irradiance");
    return key.is_number() && key == fill && key > 10;
  }));
  ui.move(ui.emptySpot());
  ui.key("ctrl+z");
  EXPECT_TRUE(becomes(ui, "Key", "irradiance", json()));
  EXPECT_EQ(param(ui, "Fill", "irradiance"), json()) << "one step";
}

INSTANTIATE_TEST_SUITE_P(All, LightsWindow,
                         testing::Values(Look{"dark", {1440, 900}, "1"}, Look{"light", {1440, 900}, "1"},
                                         Look{"dark", {2560, 1440}, "2"}, Look{"light", {2560, 1440}, "2"}),
                         [](const auto& which) {
                           return std::string(which.param.theme) + "_" + which.param.scale;
                         });

}  // namespace
}  // namespace pileus::test
