// Gestures and commands of the graph canvas, by real mouse and key events in the real window.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [96, 54], "frames": [1, 1], "fps": 24, "ocio": "", "workingSpace": "ACEScg" },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 3 } },
    "Sun": { "type": "light.sun", "at": [0, 140], "params": { "elevation": 30 } },
    "Lamp": { "type": "light.point", "at": [0, 280] },
    "Map": { "type": "shadow.extinction", "at": [300, 60], "params": { "resolution": 64 } },
    "Render": { "type": "render.volume", "at": [640, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [980, 0] }
  },
  "links": [
    "Box.volume -> Map.volumes",
    "Sun.light -> Map.light",
    "Box.volume -> Render.volumes",
    "Map.light -> Render.lights",
    "Render.image -> View.image"
  ]
}
)";

std::filesystem::path graphFile() {
  const std::filesystem::path path = scratchFolder() / "canvas.json";
  std::ofstream(path) << kGraph;
  return path;
}

bool isMuted(const json& trace, const std::string& link) {
  for (const json& l : trace["document"].value("muted", json::array()))
    if (l == link) return true;
  return false;
}

/// Opened, rendered, and zoomed out so that there is room around the nodes.
struct Canvas {
  UiSession ui;
  explicit Canvas(int notches = 1) : ui({1280, 800}, {graphFile().string()}) {
    if (!ui.running()) return;
    ui.finishPicture();
    ui.move(ui.emptySpot());
    for (int i = 0; i < notches; ++i) ui.input({"click", "5"});
    ui.settle();
  }
  json nodes() const { return ui.trace()["document"]["nodes"]; }
  json links() const { return ui.trace()["document"]["links"]; }
  bool until(const std::function<bool(const json&)>& condition) const { return ui.waitFor(condition, 8); }
  Point out(const std::string& node, const std::string& socket) const {
    return ui.center("socket/" + node + "/out/" + socket);
  }
  Point in(const std::string& node, const std::string& socket) const {
    return ui.center("socket/" + node + "/in/" + socket);
  }
  Point middle(Point a, Point b) const { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }
  Point sunToMap() const { return middle(out("Sun", "light"), in("Map", "light")); }
  Point renderToView() const { return middle(out("Render", "image"), in("View", "image")); }
  /// The document as it was before, and one step less.
  void undo(const json& before) const {
    ui.move(ui.emptySpot());
    ui.key("ctrl+z");
    EXPECT_TRUE(until([&](const json& t) { return t["document"] == before; })) << ui.trace()["redo"];
  }
  json document() const { return ui.trace()["document"]; }
};

TEST(Canvas, LinksAreDraggedDuplicatedMovedAndCut) {
  Canvas c;
  ASSERT_TRUE(c.ui.running()) << c.ui.log();
  const json start = c.document();

  // Shift at an input draws a second link from the same source.
  c.ui.drag(c.in("Map", "light"), c.in("Render", "lights"), {"shift"});
  EXPECT_TRUE(c.until([](const json& t) {
    return hasLink(t, "Sun.light -> Render.lights") && hasLink(t, "Sun.light -> Map.light");
  })) << c.links();
  c.undo(start);

  // Ctrl at an output moves all of its links.
  c.ui.drag(c.out("Sun", "light"), c.out("Lamp", "light"), {"ctrl"}, 1,
            [&] { c.ui.screenshot("canvas-01-move-links"); });
  EXPECT_TRUE(c.until([](const json& t) { return hasLink(t, "Lamp.light -> Map.light"); })) << c.links();
  EXPECT_FALSE(hasLink(c.ui.trace(), "Sun.light -> Map.light"));
  c.undo(start);

  // By the label, to a node's body: its first input that takes it.
  const Point dot = c.out("Lamp", "light");
  c.ui.drag({dot.x - 14, dot.y}, c.ui.center("header/Render"));
  EXPECT_TRUE(c.until([](const json& t) { return hasLink(t, "Lamp.light -> Render.lights"); })) << c.links();
  c.undo(start);

  // The knife, by right drag and by key; Esc ends it without a cut.
  const Point cut = c.sunToMap();
  const Point above{cut.x, cut.y - 24}, below{cut.x, cut.y + 24};
  c.ui.drag(above, below, {"ctrl"}, 3, [&] {
    EXPECT_TRUE(c.until([](const json& t) { return t["notes"].value("stroke", "") == "1 cut"; }));
    c.ui.screenshot("canvas-02-knife");
  });
  EXPECT_TRUE(c.until(
      [](const json& t) { return !hasLink(t, "Sun.light -> Map.light") && t["undo"] == "Cut link"; }));
  c.undo(start);
  c.ui.drag(above, below, {"y"});
  EXPECT_TRUE(c.until([](const json& t) { return !hasLink(t, "Sun.light -> Map.light"); }));
  c.undo(start);
  c.ui.drag(above, below, {"ctrl"}, 3, [&] { c.ui.key("Escape"); });
  EXPECT_EQ(c.document(), start);

  // Muted and back.
  c.ui.drag(above, below, {"ctrl", "alt"}, 3);
  EXPECT_TRUE(c.until([](const json& t) { return isMuted(t, "Sun.light -> Map.light"); })) << c.document();
  c.ui.drag(above, below, {"ctrl", "alt"}, 3);
  EXPECT_TRUE(c.until([](const json& t) { return !isMuted(t, "Sun.light -> Map.light"); }));

  // Dropping on nothing asks which node shall follow.
  c.ui.drag(c.out("Lamp", "light"), c.ui.emptySpot());
  ASSERT_TRUE(c.ui.waitRect("search/field"));
  c.ui.type("extinction");
  c.ui.key("Return");
  EXPECT_TRUE(c.until([](const json& t) { return hasLink(t, "Lamp.light -> Extinction Map.light"); }))
      << c.links();
}

TEST(Canvas, NodesDropOntoLinksAndLeaveThem) {
  Canvas c;
  ASSERT_TRUE(c.ui.running()) << c.ui.log();
  // A second map, unlinked, dropped on a link from light to light.
  c.ui.click("header/Map");
  c.ui.key("ctrl+d");
  ASSERT_TRUE(c.until([](const json& t) { return t["document"]["nodes"].contains("Map 2"); }));
  const json before = c.document();
  const Point grab = c.ui.center("header/Map 2");
  const Point target = c.middle(c.out("Map", "light"), c.in("Render", "lights"));
  c.ui.press(grab);
  c.ui.dragTo(grab, {target.x, target.y});
  EXPECT_TRUE(c.until([](const json& t) { return t["notes"].value("drop link", "") == "Map -> Render"; }))
      << c.ui.trace()["notes"];
  EXPECT_EQ(c.document(), before) << "nothing changes before the drop";
  c.ui.screenshot("canvas-03-drop-on-link");
  c.ui.release();
  EXPECT_TRUE(c.until([](const json& t) {
    return hasLink(t, "Map.light -> Map 2.light") && hasLink(t, "Map 2.light -> Render.lights") &&
           t["undo"] == "Insert Map 2 on a link";
  })) << c.links();
  c.undo(before);

  // Esc takes a drag back.
  c.ui.press(c.ui.center("header/Lamp"));
  c.ui.dragTo(c.ui.center("header/Lamp"), c.ui.emptySpot());
  c.ui.key("Escape");
  c.ui.release();
  EXPECT_EQ(c.document(), before);

  // Delete and reconnect, extract, cut.
  c.ui.click("header/Map");
  c.ui.key("shift+Delete");
  EXPECT_TRUE(c.until([](const json& t) {
    return !t["document"]["nodes"].contains("Map") && hasLink(t, "Sun.light -> Render.lights");
  })) << c.links();
  c.undo(before);
  c.ui.click("header/Map");
  c.ui.key("ctrl+shift+x");
  EXPECT_TRUE(c.until([](const json& t) {
    return t["document"]["nodes"].contains("Map") && hasLink(t, "Sun.light -> Render.lights");
  })) << c.links();
  c.undo(before);
  c.ui.click("header/Map");
  c.ui.key("ctrl+x");
  EXPECT_TRUE(c.until([](const json& t) {
    return !t["document"]["nodes"].contains("Map") && hasLink(t, "Sun.light -> Render.lights");
  }));
  c.undo(before);

  // A copy that keeps what feeds it; bypass and disable.
  c.ui.click("header/Map");
  c.ui.key("ctrl+shift+d");
  EXPECT_TRUE(c.until([](const json& t) {
    return hasLink(t, "Sun.light -> Map 3.light") && t["selection"] == json{"Map 3"};
  })) << c.links();
  c.undo(before);
  c.ui.click("header/Map");
  c.ui.key("m");
  EXPECT_TRUE(c.until([](const json& t) { return t["document"]["nodes"]["Map"].value("bypass", false); }));
  c.ui.key("ctrl+m");
  EXPECT_TRUE(c.until([](const json& t) { return t["document"]["nodes"]["Map"].value("disabled", false); }))
      << c.nodes()["Map"];
  c.ui.screenshot("canvas-04-disabled");
}

TEST(Canvas, SelectsWithBoxLassoAndAlongLinks) {
  Canvas c;
  ASSERT_TRUE(c.ui.running()) << c.ui.log();
  const auto selection = [&](const json& wanted) {
    return c.until([&](const json& t) { return t["selection"] == wanted; });
  };
  c.ui.click("header/Map");
  c.ui.key("ctrl+l");
  EXPECT_TRUE(selection({"Box", "Map", "Sun"})) << c.ui.trace()["selection"];
  c.ui.click("header/Map");
  c.ui.key("ctrl+shift+l");
  EXPECT_TRUE(selection({"Map", "Render", "View"})) << c.ui.trace()["selection"];
  // A lasso around the lamp.
  const json r = c.ui.trace()["rects"]["node/Lamp"];
  const double x0 = r[0].get<double>() - 8, y0 = r[1].get<double>() - 5, x1 = r[2].get<double>() + 8,
               y1 = r[3].get<double>() + 8;
  for (const char* k : {"ctrl", "alt"}) c.ui.input({"keydown", k});
  c.ui.press({x0, y0});
  c.ui.dragTo({x0, y0}, {x1, y0});
  c.ui.dragTo({x1, y0}, {x1, y1});
  c.ui.dragTo({x1, y1}, {x0, y1});
  c.ui.screenshot("canvas-05-lasso");
  c.ui.release();
  for (const char* k : {"ctrl", "alt"}) c.ui.input({"keyup", k});
  EXPECT_TRUE(selection(json{"Lamp"})) << c.ui.trace()["selection"];
  c.ui.click(c.ui.center("header/Sun"), {"shift"});
  EXPECT_TRUE(selection({"Lamp", "Sun"}));
  c.ui.click(c.ui.center("header/Lamp"), {"ctrl"});
  EXPECT_TRUE(selection(json{"Sun"}));

  // Colour by the mouse alone.
  c.ui.click("header/Sun", 3);
  ASSERT_TRUE(c.ui.waitRect("menu/color"));
  c.ui.screenshot("canvas-06-node-menu");
  c.ui.move(c.ui.center("menu/color"));
  ASSERT_TRUE(c.ui.waitRect("menu/color/#36766f"));
  c.ui.screenshot("canvas-07-colours");
  c.ui.click("menu/color/#36766f");
  EXPECT_TRUE(
      c.until([](const json& t) { return t["document"]["nodes"]["Sun"].value("color", "") == "#36766f"; }));

  // The canvas's own menu through the search.
  c.ui.click(c.ui.emptySpot(), 3);
  ASSERT_TRUE(c.ui.waitRect("search/more"));
  c.ui.click("search/more");
  ASSERT_TRUE(c.ui.waitRect("menu/tool/cut"));
  c.ui.screenshot("canvas-08-canvas-menu");
  c.ui.click("menu/tool/cut");
  const Point cut = c.sunToMap();
  c.ui.drag({cut.x, cut.y - 24}, {cut.x, cut.y + 24});
  EXPECT_TRUE(c.until([](const json& t) { return !hasLink(t, "Sun.light -> Map.light"); }))
      << "the knife without keys";
}

TEST(Canvas, ViewsAnyNodeAndComesBackToPlaces) {
  Canvas c;
  ASSERT_TRUE(c.ui.running()) << c.ui.log();
  const json before = c.document();
  const auto message = [&](const std::string& part) {
    return c.until(
        [&](const json& t) { return t["message"].get<std::string>().find(part) != std::string::npos; });
  };
  c.ui.click(c.ui.center("header/Render"), {"ctrl", "shift"});
  EXPECT_TRUE(message("Viewing Render")) << c.ui.trace()["message"];
  ASSERT_TRUE(c.ui.waitFor(
      [](const json& t) { return t["complete"] == true && t["notes"].contains("picture"); }, 30));
  c.ui.screenshot("canvas-09-viewing-render");
  // Without the View's link there is still a picture.
  const Point cut = c.renderToView();
  c.ui.drag({cut.x, cut.y - 24}, {cut.x, cut.y + 24}, {"ctrl"}, 3);
  ASSERT_TRUE(c.until([](const json& t) { return !hasLink(t, "Render.image -> View.image"); }));
  EXPECT_TRUE(c.ui.waitFor(
      [](const json& t) { return t["complete"] == true && t["notes"].contains("picture"); }, 30));
  c.undo(before);
  // A light has no picture of its own: the nearest one is shown, and it says so.
  c.ui.click(c.ui.center("header/Sun"), {"ctrl", "shift"});
  EXPECT_TRUE(message("viewing Render")) << c.ui.trace()["message"];
  c.ui.click(c.ui.center("header/Lamp"), {"ctrl", "shift"});
  EXPECT_TRUE(message("Lamp has no picture")) << c.ui.trace()["message"];
  // Slots.
  c.ui.click("header/Render");
  c.ui.key("1");
  EXPECT_TRUE(message("Viewing Render"));
  c.ui.click("header/View");
  c.ui.key("2");
  EXPECT_TRUE(message("Viewing View"));
  c.ui.key("1");
  EXPECT_TRUE(message("Viewing Render"));
  const json badges = c.ui.trace()["notes"];
  EXPECT_NE(badges.value("badge/Render", "").find('1'), std::string::npos) << badges.dump();
  EXPECT_NE(badges.value("badge/View", "").find('2'), std::string::npos) << badges.dump();
  c.ui.screenshot("canvas-10-slots");
  EXPECT_EQ(c.document(), before) << "viewing changes no document";

  // Bookmarks.
  const json node = c.ui.trace()["rects"]["node/Map"];
  c.ui.move(c.ui.emptySpot());
  c.ui.key("ctrl+shift+1");
  EXPECT_TRUE(message("Bookmark 1 saved")) << c.ui.trace()["message"];
  c.ui.drag(c.ui.emptySpot(), c.ui.center("header/Map"), {}, 2);
  ASSERT_TRUE(c.until([&](const json& t) { return t["rects"]["node/Map"] != node; }));
  c.ui.key("ctrl+1");
  EXPECT_TRUE(c.until([&](const json& t) { return t["rects"]["node/Map"] == node; }));
  EXPECT_EQ(c.document(), before);
}

TEST(Canvas, DotsFramesAndGroups) {
  Canvas c;
  ASSERT_TRUE(c.ui.running()) << c.ui.log();
  const json before = c.document();
  const std::size_t count = before["nodes"].size();
  const auto nodeCount = [&](std::size_t n) {
    return c.until([&](const json& t) { return t["document"]["nodes"].size() == n; });
  };
  c.ui.click(c.sunToMap(), {"ctrl"});
  EXPECT_TRUE(nodeCount(count + 1)) << c.nodes();
  c.undo(before);
  c.ui.click(c.sunToMap());
  c.ui.key("period");
  EXPECT_TRUE(nodeCount(count + 1));
  c.undo(before);
  // Both links of the box get one dot together.
  const Point box = c.out("Box", "volume");
  c.ui.drag({box.x + 14, box.y - 60}, {box.x + 14, box.y + 60}, {"shift"}, 3,
            [&] { c.ui.screenshot("canvas-11-dots"); });
  EXPECT_TRUE(nodeCount(count + 1)) << c.nodes();
  c.ui.screenshot("canvas-12-dot");
  c.undo(before);

  // A frame around two nodes, named at once; its header moves them.
  c.ui.click("header/Sun");
  c.ui.click(c.ui.center("header/Lamp"), {"shift"});
  c.ui.key("ctrl+j");
  ASSERT_TRUE(c.ui.waitRect("frame title"));
  c.ui.type("Lights");
  c.ui.key("Return");
  ASSERT_TRUE(c.until([](const json& t) {
    return t["document"]["frames"].size() == 1 && t["document"]["frames"][0]["title"] == "Lights";
  })) << c.document();
  c.ui.screenshot("canvas-13-frame");
  const json framed = c.document();
  const json sun = c.ui.trace()["rects"]["node/Sun"];
  const json frame = c.ui.trace()["rects"]["frame/0"];
  const Point header{c.ui.center("frame/0").x, frame[1].get<double>() + 12};
  c.ui.drag(header, {header.x + 20, header.y + 12});
  EXPECT_TRUE(c.until(
      [&](const json& t) { return t["document"]["nodes"]["Sun"]["at"] != framed["nodes"]["Sun"]["at"]; }));
  c.undo(framed);
  c.ui.drag(header, {header.x + 20, header.y + 12}, {"ctrl"});
  EXPECT_TRUE(c.until([&](const json& t) {
    return t["document"]["frames"] != framed["frames"] && t["document"]["nodes"] == framed["nodes"];
  }));
  c.undo(framed);
  c.ui.click(header);
  c.ui.key("Delete");
  EXPECT_TRUE(c.until([&](const json& t) {
    return t["document"].value("frames", json::array()).empty() && t["document"]["nodes"] == framed["nodes"];
  }));

  // A group and what it held.
  c.ui.click("header/Map");
  const json flat = c.document();
  c.ui.key("ctrl+g");
  ASSERT_TRUE(c.until([](const json& t) { return t["document"]["nodes"].contains("Group"); })) << c.nodes();
  c.ui.screenshot("canvas-14-group");
  c.ui.key("ctrl+shift+g");
  EXPECT_TRUE(c.until([&](const json& t) {
    return t["document"]["links"].size() == flat["links"].size() && t["document"]["nodes"].contains("Map");
  })) << c.document();
}

TEST(Canvas, CopiesThroughTheSystemClipboardToAnotherWindow) {
  UiSession first({1280, 1460}, {graphFile().string()}, {{"window", {1280, 720}}});
  ASSERT_TRUE(first.running()) << first.log();
  UiSession second(first, 730, {1280, 720}, {graphFile().string()});
  ASSERT_TRUE(second.running()) << second.log();
  first.focus();
  first.click("header/Sun");
  first.click(first.center("header/Map"), {"shift"});
  first.key("ctrl+c");
  ASSERT_TRUE(
      first.waitFor([](const json& t) { return t["message"].get<std::string>().starts_with("Copied"); }));
  second.focus();
  second.move(second.emptySpot());
  second.key("ctrl+v");
  ASSERT_TRUE(second.waitFor([](const json& t) {
    return t["document"]["nodes"].contains("Sun 2") && hasLink(t, "Sun 2.light -> Map 2.light");
  })) << second.trace()["message"];
  EXPECT_EQ(second.trace()["document"]["nodes"]["Sun 2"]["params"],
            first.trace()["document"]["nodes"]["Sun"]["params"]);
  second.key("ctrl+v");
  ASSERT_TRUE(second.waitFor([](const json& t) { return t["document"]["nodes"].contains("Sun 3"); }));
  const json nodes = second.trace()["document"]["nodes"];
  EXPECT_NE(nodes["Sun 2"]["at"], nodes["Sun 3"]["at"])
      << "a further paste in the same place lies beside the first";
  first.screenshot("canvas-15-two-windows");
}

}  // namespace
}  // namespace pileus::test
