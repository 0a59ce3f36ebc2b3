// Navigation, gizmos and the tools of the viewport in a real window with real input.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [480, 270], "frames": [1, 1], "fps": 24, "ocio": "", "workingSpace": "ACEScg" },
  "nodes": {
    "Ball": { "type": "volume.sphere", "at": [0, 0], "params": { "radius": 0.6, "density": 3 } },
    "Place": { "type": "volume.transform", "at": [220, 0], "params": { "translate": [-0.8, 0.3, 0] } },
    "Low": { "type": "volume.box", "at": [0, 140], "params": { "center": [0.6, -1.2, 0], "size": [3, 0.5, 1.6], "density": 2 } },
    "Sun": { "type": "light.sun", "at": [0, 260], "params": { "azimuth": 40, "elevation": 50 } },
    "Spot": { "type": "light.spot", "at": [0, 380], "params": { "position": [2, 1.6, 0.5], "target": [0.8, -0.8, 0], "cone": 40 } },
    "Camera": { "type": "camera.perspective", "at": [0, 500], "params": { "eye": [0.5, 0.8, 7] } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 2 } },
    "View": { "type": "output.view", "at": [780, 0] }
  },
  "links": [
    "Ball.volume -> Place.volume",
    "Place.volume -> Render.volumes",
    "Low.volume -> Render.volumes",
    "Sun.light -> Render.lights",
    "Spot.light -> Render.lights",
    "Camera.camera -> Render.camera",
    "Render.image -> View.image"
  ]
}
)";

std::filesystem::path graphFile() {
  const std::filesystem::path path = scratchFolder() / "gizmos.json";
  std::ofstream(path) << kGraph;
  return path;
}

json param(const json& t, const char* node, const char* id) {
  const json& params = t["document"]["nodes"][node]["params"];
  return params.contains(id) ? params[id] : json();
}

bool settled(const json& t) { return t["complete"] == true; }
bool selected(const json& t, const char* node) { return t["selection"] == json::array({node}); }

/// A point of the picture by its part of the rectangle.
Point at(const UiSession& ui, double x, double y) {
  const json r = ui.trace()["rects"]["viewport"];
  return {r[0].get<double>() + x * (r[2].get<double>() - r[0].get<double>()),
          r[1].get<double>() + y * (r[3].get<double>() - r[1].get<double>())};
}

TEST(Gizmo, PicksMovesTurnsAndTakesBack) {
  UiSession ui({1440, 900}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  ui.screenshot("60-viewport");

  // A click on the ball chooses the transform that places it; one beside everything nothing.
  const json camera = ui.trace()["document"]["nodes"]["Camera"];
  ui.click(at(ui, 0.385, 0.44));
  ASSERT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Place"); })) << ui.trace()["selection"];
  EXPECT_EQ(ui.trace()["document"]["nodes"]["Camera"], camera) << "a click moves no camera";
  ui.key("w");
  ASSERT_TRUE(ui.waitRect("gizmo/axis/0"));
  ui.screenshot("61-move");

  const Point x = ui.center("gizmo/axis/0");
  ui.press(x);
  ui.dragTo(x, {x.x + 60, x.y + 20});
  EXPECT_TRUE(
      ui.waitFor([](const json& t) { return t["notes"].value("gizmo readout", "").starts_with("X +"); }));
  ui.screenshot("62-moving");
  ui.release();
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    const json p = param(t, "Place", "translate");
    return p[0].get<double>() > -0.6 && p[1] == 0.3 && p[2] == 0.0 && t["undo"] == "Move Place";
  })) << ui.trace()["document"]["nodes"]["Place"];
  ui.key("ctrl+z");
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    return param(t, "Place", "translate") == json::array({-0.8, 0.3, 0}) && t["undo"] == "";
  })) << "one drag is one step: "
      << ui.trace()["undo"];

  // Esc takes back a drag without a trace.
  ASSERT_TRUE(ui.waitRect("gizmo/axis/1"));
  const Point y = ui.center("gizmo/axis/1");
  ui.press(y);
  ui.dragTo(y, {y.x, y.y - 40});
  EXPECT_TRUE(
      ui.waitFor([](const json& t) { return param(t, "Place", "translate")[1].get<double>() > 0.4; }));
  ui.key("Escape");
  ui.release();
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return param(t, "Place", "translate") == json::array({-0.8, 0.3, 0}) && t["undo"] == "";
  }));

  ui.key("e");
  ASSERT_TRUE(ui.waitRect("gizmo/ring/1"));
  ui.screenshot("63-rotate");
  const Point ring = ui.center("gizmo/view_ring/0");
  ui.drag(ring, {ring.x + 8, ring.y + 50});
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["undo"] == "Turn Place" && !param(t, "Place", "rotate").is_null();
  })) << ui.trace()["undo"];
  ui.key("r");
  ASSERT_TRUE(ui.waitRect("gizmo/scale_axis/1"));
  ui.screenshot("64-scale");
  const Point grow = ui.center("gizmo/scale_axis/1");
  ui.drag(grow, {grow.x, grow.y - 30});
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return param(t, "Place", "scale").is_array() && param(t, "Place", "scale")[1].get<double>() > 1.1;
  }));

  // The sun by its disc, the spot by its cone.
  ui.click("light/Sun");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Sun"); }));
  ASSERT_TRUE(ui.waitRect("gizmo/sun_disc/0"));
  ui.screenshot("65-sun");
  const Point disc = ui.center("gizmo/sun_disc/0");
  ui.drag(disc, {disc.x - 50, disc.y + 20});
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return param(t, "Sun", "azimuth").is_number() && param(t, "Sun", "azimuth").get<double>() < 35 &&
           t["undo"] == "Turn Sun";
  }));
  ui.click("light/Spot");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Spot"); }));
  ui.key("w");
  ASSERT_TRUE(ui.waitRect("gizmo/cone/0"));
  ui.screenshot("66-spot");

  // A volume that cannot be turned: a transform is offered, one step.
  ui.click("header/Low");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Low"); }));
  ui.move(at(ui, 0.5, 0.2));
  ui.key("e");
  ASSERT_TRUE(ui.waitRect("viewport/insert_transform"));
  ui.screenshot("67-insert");
  ui.click("viewport/insert_transform");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["undo"] == "Insert Transform" && t["document"]["nodes"].contains("Transform") &&
           t["rects"].contains("gizmo/ring/0");
  }));
}

TEST(Navigation, ToolsOfTheViewport) {
  UiSession ui({1440, 900}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  const json start = ui.trace()["document"]["nodes"]["Camera"];
  const auto camera = [&] { return ui.trace()["document"]["nodes"]["Camera"]; };
  const auto moved = [&](const json& from) {
    return ui.waitFor([&](const json& t) { return t["document"]["nodes"]["Camera"] != from; });
  };

  // Axis cross, from the other side, and back.
  ui.click("axis/x");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return param(t, "Camera", "eye")[0].get<double>() > 6.9; }))
      << camera();
  ui.screenshot("70-from-x");
  ui.click("axis/back", 3);
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"]["Camera"] == start; }))
      << camera();

  // Bookmarks; the wheel goes to the pointer.
  ui.move(at(ui, 0.5, 0.75));
  ui.key("ctrl+shift+3");
  ui.input({"click", "4"});
  ASSERT_TRUE(moved(start));
  EXPECT_NE(camera()["params"].value("target", json()), start["params"].value("target", json()))
      << "not straight to the target";
  ui.key("ctrl+3");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"]["Camera"] == start; }))
      << camera();

  // Frame the selection, frame all.
  ui.click("header/Place");
  ui.move(at(ui, 0.5, 0.8));
  ui.key("f");
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    return t["undo"] == "Frame selection" &&
           std::abs(param(t, "Camera", "target")[0].get<double>() + 0.8) < 0.01;
  }));
  ui.key("a");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Frame volumes"; }));
  ui.key("ctrl+3");

  // Through the sun: orbiting turns it; Esc comes back to the same camera.
  ui.click("header/Sun");
  ui.move(at(ui, 0.5, 0.8));
  ui.key("l");
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].value("viewport light", "") == "Sun" && settled(t); }, 40));
  ui.screenshot("71-through-sun");
  const Point free = at(ui, 0.5, 0.9);
  ui.drag(free, {free.x + 60, free.y});
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["undo"] == "Move Sun" && param(t, "Sun", "azimuth") != 40;
  })) << ui.trace()["undo"];
  ui.key("Escape");
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return !t["notes"].contains("viewport light") && t["document"]["nodes"]["Camera"] == start;
  })) << camera();

  // Placed by its shadow: what casts, then where it should fall.
  ui.key("v");
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].value("viewport hint", "").starts_with("Click what casts"); }));
  ASSERT_TRUE(ui.waitFor(settled, 40));
  ui.click(at(ui, 0.385, 0.44));
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].value("viewport hint", "").starts_with("Point at where"); }));
  const json sun = ui.trace()["document"]["nodes"]["Sun"];
  ui.move(at(ui, 0.5, 0.73));
  ui.screenshot("72-by-shadow");
  ui.click(at(ui, 0.52, 0.73));
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return t["document"]["nodes"]["Sun"] != sun && !t["notes"].contains("viewport hint") &&
           t["undo"] == "Place Sun by its shadow";
  })) << ui.trace()["undo"];

  // Overlays from their little menu.
  for (const char* id :
       {"menu/viewport.show_grid", "menu/viewport.show_bounds", "menu/viewport.show_safe_frame"}) {
    ui.click("viewport/overlays");
    ASSERT_TRUE(ui.waitRect(id));
    ui.click(id);
  }
  ui.move(at(ui, 0.5, 0.9));
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["notes"].value("overlay grid", "").ends_with(" m"); }));
  ui.screenshot("73-overlays");
}

TEST(Gizmo, OnAPreset) {
  UiSession ui({1440, 900}, {std::string(PILEUS_SOURCE_DIR) + "/presets/two-lights.json"});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].contains("picture") && t["rects"].contains("light/Sky"); }, 60));
  ui.click("light/Sky");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Sky"); }));
  if (wantsScreenshots()) ui.finishPicture();
  ui.screenshot("75-preset-light");
  ui.click("header/Cloud");
  ui.move(at(ui, 0.5, 0.8));
  ui.key("w");
  ASSERT_TRUE(ui.waitRect("gizmo/axis/1"));
  ui.screenshot("76-preset-move");
  ui.click("viewport/overlays");
  ASSERT_TRUE(ui.waitRect("menu/viewport.show_bricks"));
  ui.click("menu/viewport.show_bricks");
  ui.move(at(ui, 0.5, 0.9));
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("overlay bricks", "").find(" bricks of level ") != std::string::npos;
  })) << ui.trace()["notes"];
  ui.screenshot("77-preset-bricks");
}

/// A keyed sun in a group, and its key at frame 1.
constexpr char kGrouped[] = R"({
  "pileus": 1,
  "settings": { "size": [480, 270], "frames": [1, 10] },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0] },
    "Rig": { "type": "group", "at": [0, 200], "graph": {
      "nodes": {
        "Sun": { "type": "light.sun", "at": [0, 0],
                 "params": { "azimuth": { "keys": [[1, 40, "linear"], [9, 60, "linear"]] }, "elevation": 35 } },
        "light": { "type": "group.output", "at": [260, 0] } },
      "links": [ "Sun.light -> light.in" ] } },
    "Camera": { "type": "camera.perspective", "at": [0, 500], "params": { "eye": [0.5, 0.8, 7] } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [780, 0] } },
  "links": [ "Box.volume -> Render.volumes", "Rig.light -> Render.lights", "Camera.camera -> Render.camera",
             "Render.image -> View.image" ]
})";

TEST(Gizmo, HandlesReachIntoGroups) {
  const std::filesystem::path path = scratchFolder() / "grouped.json";
  std::ofstream(path) << kGrouped;
  UiSession ui({1380, 860}, {path.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  // The light in the group has its mark, and a click there shows its handles.
  ASSERT_TRUE(ui.waitRect("light/Rig/Sun"));
  ui.click("light/Rig/Sun");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Rig"); })) << ui.trace()["selection"];
  ASSERT_TRUE(ui.waitRect("gizmo/sun_disc/0"));
  ui.screenshot("74-handle-in-group");
  const Point disc = ui.center("gizmo/sun_disc/0");
  ui.drag(disc, {disc.x - 50, disc.y + 10});
  const auto sun = [](const json& t) {
    return t["document"]["nodes"]["Rig"]["graph"]["nodes"]["Sun"]["params"];
  };
  EXPECT_TRUE(ui.waitFor([&](const json& t) {
    return t["undo"] == "Turn Rig/Sun" && sun(t)["azimuth"]["keys"].size() == 2 &&
           sun(t)["azimuth"]["keys"][0][1] != 40;
  })) << ui.trace()["undo"]
      << sun(ui.trace());
  ui.move(at(ui, 0.5, 0.9));
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return sun(t)["azimuth"]["keys"][0][1] == 40; }));

  // So they do in the group itself.
  ui.doubleClick(ui.center("header/Rig"));
  ASSERT_TRUE(ui.waitRect("header/Sun"));
  ui.click("header/Sun");
  EXPECT_TRUE(ui.waitRect("gizmo/sun_disc/0"));
}

/// Camera, light and render in a group, the camera in one of its own.
constexpr char kShot[] = R"({
  "pileus": 1,
  "settings": { "size": [480, 270], "frames": [1, 10] },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0] },
    "Shot": { "type": "group", "at": [260, 0], "graph": {
      "nodes": {
        "volume": { "type": "group.input", "at": [0, 0] },
        "Rig": { "type": "group", "at": [0, 120], "graph": {
          "nodes": {
            "Camera": { "type": "camera.perspective", "at": [0, 0], "params": { "eye": [0.5, 0.8, 7],
                        "fov": { "keys": [[1, 40, "linear"], [9, 50, "linear"]] } } },
            "camera": { "type": "group.output", "at": [260, 0] } },
          "links": [ "Camera.camera -> camera.in" ] } },
        "Sun": { "type": "light.sun", "at": [0, 240], "params": { "azimuth": 40, "elevation": 35 } },
        "Render": { "type": "render.volume", "at": [260, 0], "params": { "samples": 1 } },
        "image": { "type": "group.output", "at": [520, 0] } },
      "links": [ "volume.out -> Render.volumes", "Rig.camera -> Render.camera", "Sun.light -> Render.lights",
                 "Render.image -> image.in" ] } },
    "View": { "type": "output.view", "at": [780, 0] } },
  "links": [ "Box.volume -> Shot.volume", "Shot.image -> View.image" ]
})";

TEST(Navigation, ACameraInAGroupIsTheOneThatIsLookedThrough) {
  const std::filesystem::path path = scratchFolder() / "shot.json";
  std::ofstream(path) << kShot;
  UiSession ui({1380, 860}, {path.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(settled, 60)) << ui.log();
  const auto camera = [](const json& t) {
    return t["document"]["nodes"]["Shot"]["graph"]["nodes"]["Rig"]["graph"]["nodes"]["Camera"]["params"];
  };
  const json start = camera(ui.trace());
  ui.screenshot("78-camera-in-group");
  // Moves are edits of that node, not of a free camera.
  const Point from = at(ui, 0.5, 0.15);
  ui.drag(from, {from.x + 60, from.y});
  ASSERT_TRUE(ui.waitFor([&](const json& t) {
    return t["undo"] == "Orbit camera" && camera(t)["eye"] != start["eye"];
  })) << ui.trace()["undo"];
  EXPECT_EQ(camera(ui.trace())["fov"], start["fov"]) << "what did not move gets no key";
  ui.key("ctrl+z");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return camera(t) == start; }));
  // Its volume is seen, picked and framed by its path.
  ui.click(at(ui, 0.5, 0.55));
  EXPECT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Box"); })) << ui.trace()["selection"];

  // The lock: looking around leaves it alone, and goes back.
  ui.click("viewport/button/viewport.lock_camera");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return camera(t).value("lock", false); }))
      << camera(ui.trace());
  const json locked = camera(ui.trace());
  ui.drag(from, {from.x + 60, from.y});
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].value("looking around", "") == "Shot/Rig/Camera" && settled(t); },
      40))
      << ui.trace()["notes"];
  EXPECT_EQ(camera(ui.trace()), locked);
  EXPECT_EQ(ui.trace()["error"], "");
  ui.screenshot("79-around-group");
  // From beside it, it has a handle.
  ui.click("header/Shot");
  ui.doubleClick(ui.center("header/Shot"));
  ASSERT_TRUE(ui.waitRect("header/Rig"));
  ui.doubleClick(ui.center("header/Rig"));
  ASSERT_TRUE(ui.waitRect("header/Camera"));
  ui.click("header/Camera");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return selected(t, "Camera"); }));
  ui.move(at(ui, 0.5, 0.9));
  ui.key("BackSpace");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["notes"].contains("looking around"); }));
  // Its keys, by the timeline, in the group it was entered.
  ui.key("alt+7");
  ASSERT_TRUE(ui.waitRect("timeline"));
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    for (const auto& [name, rect] : t["rects"].items())
      if (name.starts_with("key/") && name.ends_with("Camera.fov/1")) return true;
    return false;
  })) << ui.trace()["rects"];
}

}  // namespace
}  // namespace pileus::test
