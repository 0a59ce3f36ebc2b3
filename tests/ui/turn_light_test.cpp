// Light from everywhere in the window: turned by a drag over the picture, seen on its node, there in a new
// document.
#include <cmath>

#include "renderer/image/exr.h"
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

/// Bright on one side, so that turning it is seen.
fs::path dome() {
  image::Image sky;
  sky.size = {64, 32};
  std::vector<float> texels;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const float v = x < 32 ? 1.0f : 0.05f;
      texels.insert(texels.end(), {v, 0.6f * v, 0.3f * v, 1});
    }
  sky.layers.push_back({"", 4, std::move(texels)});
  const fs::path file = scratchFolder() / "dome.exr";
  EXPECT_TRUE(image::writeExr(file, sky));
  return file;
}

fs::path graphFile(const std::string& light) {
  const fs::path path = scratchFolder() / "turn.json";
  std::ofstream(path) << R"({
  "pileus": 1,
  "settings": { "size": [320, 180], "frames": [1, 1] },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0] },
    "Place": { "type": "volume.transform", "at": [260, 0] },
    "Light": )" + light + R"(,
    "Camera": { "type": "camera.perspective", "at": [260, 330], "params": { "eye": [0.5, 0.8, 7] } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [780, 0] } },
  "links": [ "Box.volume -> Place.volume", "Place.volume -> Render.volumes", "Light.light -> Render.lights",
             "Camera.camera -> Render.camera", "Render.image -> View.image" ]
})";
  return path;
}

json param(const json& t, const char* node, const char* id) {
  const json& params = t["document"]["nodes"][node]["params"];
  return params.contains(id) ? params[id] : json();
}

Point at(const UiSession& ui, double x, double y) {
  const json r = ui.trace()["rects"]["viewport"];
  return {r[0].get<double>() + x * (r[2].get<double>() - r[0].get<double>()),
          r[1].get<double>() + y * (r[3].get<double>() - r[1].get<double>())};
}

double height(const UiSession& ui) {
  const json r = ui.trace()["rects"]["viewport"];
  return r[3].get<double>() - r[1].get<double>();
}

TEST(TurnLight, ADragSidewaysTurnsTheSelectedEnvironment) {
  UiSession ui({1280, 800}, {graphFile(R"({ "type": "light.environment", "at": [0, 200],
    "params": { "file": ")" + dome().string() +
                                       R"(", "rotation": 30 } })")
                                 .string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  const json camera = ui.trace()["document"]["nodes"]["Camera"];
  const Point from = at(ui, 0.5, 0.15), to{from.x + 0.25 * height(ui), from.y + 30};

  // Not selected: the camera's.
  ui.drag(from, to);
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Orbit camera"; })) << ui.trace()["undo"];
  ui.key("ctrl+z");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"]["Camera"] == camera; }));

  ui.click("header/Light");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Light"}; }));
  ui.move(from);
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("status", "").starts_with("A drag sideways turns Light");
  })) << ui.trace()["notes"];
  const auto answered = ui.trace()["answered"];
  ui.drag(from, to, {}, 1, [&] {
    EXPECT_TRUE(ui.waitFor([&](const json& t) {
      return t["notes"].value("turn readout", "").starts_with("-15.") && t["answered"] > answered;
    })) << "a picture while it is held: "
        << ui.trace()["notes"];
    ui.screenshot("turn-environment");
  });
  // A quarter of the picture's height is an eighth of a turn, and what is behind goes with the pointer.
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["undo"] == "Turn Light" && std::abs(param(t, "Light", "rotation").get<double>() + 15) < 1;
  })) << ui.trace()["undo"]
      << param(ui.trace(), "Light", "rotation");
  EXPECT_EQ(ui.trace()["document"]["nodes"]["Camera"], camera) << "the camera stays";
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return param(t, "Light", "rotation") == 30 && t["undo"] == "";
  })) << "one drag is one step: "
      << ui.trace()["undo"];

  // By steps with Ctrl; Esc takes it back without a trace; a click selects what is there as always.
  ui.drag(from, to, {"ctrl"});
  EXPECT_TRUE(ui.waitFor([](const json& t) { return param(t, "Light", "rotation") == -15; }))
      << param(ui.trace(), "Light", "rotation");
  ui.key("ctrl+z");
  ui.press(from);
  ui.dragTo(from, to);
  EXPECT_TRUE(ui.waitFor([](const json& t) { return param(t, "Light", "rotation") != 30; }));
  ui.key("Escape");
  ui.release();
  EXPECT_TRUE(
      ui.waitFor([](const json& t) { return param(t, "Light", "rotation") == 30 && t["undo"] == ""; }));
  // Alt orbits, whatever is selected.
  ui.drag(from, to, {"alt"});
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Orbit camera"; })) << ui.trace()["undo"];
  ui.key("ctrl+z");

  // A locked camera changes nothing of it.
  ui.click("viewport/button/viewport.lock_camera");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return param(t, "Camera", "lock") == true; }));
  ui.drag(from, to);
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Turn Light"; })) << ui.trace()["undo"];
  EXPECT_FALSE(ui.trace()["notes"].contains("looking around"));
  // Handles go before it, and a click goes to what is below it.
  ui.click(at(ui, 0.45, 0.5));
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Place"}; }))
      << ui.trace()["selection"];
}

TEST(TurnLight, ADragSidewaysTurnsTheSelectedSkyAlsoInAGroup) {
  const fs::path path = graphFile(R"({ "type": "group", "at": [0, 200], "graph": {
      "nodes": { "Sky": { "type": "light.sky", "at": [0, 0], "params": { "azimuth": 170 } },
                 "light": { "type": "group.output", "at": [260, 0] } },
      "links": [ "Sky.light -> light.in" ] } })");
  UiSession ui({1280, 800}, {path.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  const auto azimuth = [](const json& t) {
    return t["document"]["nodes"]["Light"]["graph"]["nodes"]["Sky"]["params"]["azimuth"].get<double>();
  };
  ui.click("header/Light");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Light"}; }));
  const Point from = at(ui, 0.6, 0.15);
  ui.drag(from, {from.x - 0.25 * height(ui), from.y});
  // Beyond half a turn it goes on from the other side.
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return t["undo"] == "Turn Light/Sky" && std::abs(azimuth(t) + 145) < 1;
  })) << ui.trace()["undo"]
      << azimuth(ui.trace());
  ui.finishPicture();
  ui.screenshot("turn-sky");
}

TEST(TurnLight, ANewDocumentHasASkyAndItsNodeShowsIt) {
  UiSession ui({1280, 800}, {graphFile(R"({ "type": "light.sun", "at": [0, 200] })").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.move(ui.emptySpot());
  ui.key("ctrl+n");
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    return t["document"]["nodes"].contains("Sky") && t["path"] == "" && t["dirty"] == false &&
           t["undo"] == "";
  })) << ui.trace();
  ui.finishPicture();
  EXPECT_EQ(ui.trace()["error"], "");
  EXPECT_TRUE(ui.trace()["notes"].contains("picture")) << "the sky is seen";
  ui.screenshot("new-document");
  const json before = ui.trace()["rects"]["node/Sky"];
  ui.click("header/Sky");
  // Its sun has the handles of any sun, and they go before a turn.
  ASSERT_TRUE(ui.waitRect("gizmo/sun_disc/0"));
  const json sky = ui.trace()["document"]["nodes"]["Sky"]["params"];
  const Point disc = ui.center("gizmo/sun_disc/0");
  ui.drag(disc, {disc.x, disc.y + 20});
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return param(t, "Sky", "elevation").get<double>() < sky["elevation"].get<double>() - 2;
  })) << ui.trace()["document"]["nodes"]["Sky"];
  ui.key("ctrl+z");
  ui.move(ui.center("header/Sky"));
  ui.key("shift+h");
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return t["rects"]["node/Sky"][3] > before[3] && t["notes"].value("thumbnail Sky", "0") != "0";
  })) << ui.trace()["notes"];
  ui.screenshot("sky-on-its-node");
}

}  // namespace
}  // namespace pileus::test
