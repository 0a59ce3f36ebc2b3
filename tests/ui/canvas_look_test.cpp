// What the graph canvas shows, looked at in the real window: states of nodes, the map, finding, arranging,
// pictures, and what 500 nodes cost.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/cli/big_graph.h"
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

std::filesystem::path fileOf(const std::string& name, const std::string& text) {
  const std::filesystem::path path = scratchFolder() / name;
  std::ofstream(path) << text;
  return path;
}

json nodeRect(const UiSession& ui, const std::string& node) {
  return ui.trace()["rects"].value("node/" + node, json());
}

bool done(const json& t) { return t["complete"] == true; }

constexpr char kStates[] = R"({
  "pileus": 1,
  "settings": { "size": [160, 90], "frames": [1, 1], "fps": 24, "ocio": "", "workingSpace": "ACEScg" },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 3 } },
    "Smoke": { "type": "volume.vdb_file", "at": [0, 160], "params": { "file": "missing.vdb" } },
    "Sun": { "type": "light.sun", "at": [0, 330], "params": { "elevation": 30 }, "expose": ["elevation"] },
    "Thicker": { "type": "volume.medium", "at": [270, 0], "bypass": true },
    "Metric": { "type": "shadow.pseudometric", "at": [540, 260], "params": { "resolution": 64 } },
    "Map": { "type": "shadow.extinction", "at": [810, 260], "params": { "resolution": 64 }, "color": "#36766f" },
    "Render": { "type": "render.volume", "at": [1080, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [1350, 0] },
    "Broken": { "type": "render.volume", "at": [540, 560] },
    "Broken View": { "type": "output.view", "at": [810, 560] }
  },
  "links": [
    "Box.volume -> Thicker.volume",
    "Thicker.volume -> Metric.volumes",
    "Sun.light -> Metric.light",
    "Metric.metric -> Map.metric",
    "Thicker.volume -> Render.volumes",
    "Map.light -> Render.lights",
    "Render.image -> View.image",
    "Smoke.volume -> Broken.volumes",
    "Broken.image -> Broken View.image"
  ]
}
)";

TEST(CanvasLook, StatesErrorsPicturesAndCosts) {
  UiSession ui({1600, 1000}, {fileOf("states.json", kStates).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(done, 60)) << ui.log();
  ui.move(ui.center("canvas"));
  ui.key("a");
  ui.settle();
  ui.screenshot("look-states");

  // A node whose input failed names the node it waits for; a click goes there.
  ui.click("header/Broken View");
  ui.key("ctrl+shift+1");
  ui.move(ui.center("canvas"));
  ui.click("header/Broken View");
  ui.key("1");
  ui.key("f");  // near enough to read
  ui.settle();
  ui.screenshot("look-follower");
  ASSERT_TRUE(ui.waitRect("waits/Broken View")) << ui.trace()["rects"];
  ui.move(ui.center("waits/Broken View"));
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("tooltip", "").starts_with("Waits for Smoke");
  })) << ui.trace()["notes"];
  ui.screenshot("look-error");
  ui.click("waits/Broken View");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Smoke"}; }))
      << ui.trace()["selection"];

  // Pictures on the selected nodes make room for themselves, and are no change of the document.
  ui.move(ui.center("canvas"));
  ui.key("a");
  ui.settle();
  const json before = nodeRect(ui, "Metric"), document = ui.trace()["document"];
  ui.click("header/Metric");
  ui.key("shift+h");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["rects"]["node/Metric"][3] > before[3]; }));
  ui.key("shift+h");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["rects"]["node/Metric"][3] == before[3]; }));
  ui.click("menubar/View");
  ui.click("menu/view.thumbnails");
  ui.click("menubar/View");
  ui.click("menu/view.times");
  ui.move(ui.center("canvas"));
  ui.key("a");
  ui.settle();
  ui.screenshot("look-pictures");
  EXPECT_EQ(ui.trace()["document"], document);
}

TEST(CanvasLook, ArrangeAlignFindAndMap) {
  UiSession ui({1600, 1000}, {fileOf("sixty.json", cli::bigGraph(60)).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(done, 60)) << ui.log();
  ui.move(ui.center("canvas"));
  ui.key("a");
  ui.settle();
  ui.screenshot("look-60-far");

  // L arranges all: links run to the right, one step of undo.
  const json before = ui.trace()["document"]["nodes"];
  ui.key("l");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Arrange nodes"; })) << ui.trace()["undo"];
  const json after = ui.trace()["document"]["nodes"];
  EXPECT_NE(after, before);
  EXPECT_LT(after["Box"]["at"][0], after["Map"]["at"][0]);
  EXPECT_LT(after["Map"]["at"][0], after["Render"]["at"][0]);
  ui.key("a");
  ui.settle();
  ui.screenshot("look-60-arranged");
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"] == before; }));

  // Find by name; Enter goes there.
  ui.key("ctrl+f");
  ASSERT_TRUE(ui.waitRect("find/field"));
  ui.type("metric 3");
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("find/0", "").starts_with("Metric 3");
  })) << ui.trace()["notes"];
  ui.screenshot("look-find");
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Metric 3"}; }));
  ui.settle();
  const json canvas = ui.trace()["rects"]["canvas"];
  const Point at = ui.center("node/Metric 3");
  EXPECT_NEAR(at.x, 0.5 * (canvas[0].get<double>() + canvas[2].get<double>()), 40);
  ui.screenshot("look-60-near");

  // The map: a click goes there, and the rectangle drags.
  ASSERT_TRUE(ui.waitRect("minimap"));
  const json map = ui.trace()["rects"]["minimap"];
  const Point corner{map[0].get<double>() + 12, map[1].get<double>() + 50};
  ui.click(corner);
  EXPECT_TRUE(ui.waitFor(
      [&](const json& t) { return std::abs(t["rects"]["node/Metric 3"][0].get<double>() - at.x) > 200; }));
  ui.settle();
  const Point grip = ui.center("minimap/view"), box = ui.center("node/Box");
  ui.drag(grip, {grip.x + 20, grip.y});
  EXPECT_TRUE(
      ui.waitFor([&](const json& t) { return t["rects"]["node/Box"][0].get<double>() < box.x - 150; }));

  // Tops of the selected nodes on one line.
  ui.move({0.5 * (canvas[0].get<double>() + canvas[2].get<double>()), canvas[1].get<double>() + 30});
  ui.key("ctrl+a");
  ui.key("shift+Up");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["undo"] == "Align nodes"; }));
  for (const json& node : ui.trace()["document"]["nodes"]) EXPECT_EQ(node["at"][1], 0);
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"] == before; }));
}

TEST(CanvasLook, ZoomToAllFitsAThousandNodes) {
  // In one long row, farther than any group that was arranged.
  std::string nodes;
  for (int i = 0; i < 1000; ++i)
    nodes += fmt::format(R"({}"N{}": {{ "type": "volume.box", "at": [{}, {}] }})", i ? "," : "", i, 260 * i,
                         40 * (i % 7));
  UiSession ui({1280, 720}, {fileOf("row.json", R"({ "pileus": 2, "nodes": {)" + nodes + "} }").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.move(ui.center("canvas"));
  ui.key("a");
  ui.settle();
  const json t = ui.trace(), canvas = t["rects"]["canvas"];
  for (const char* node : {"node/N0", "node/N999"}) {
    ASSERT_TRUE(t["rects"].contains(node)) << node << " is out of view";
    EXPECT_GE(t["rects"][node][0], canvas[0]);
    EXPECT_LE(t["rects"][node][2], canvas[2]);
  }
}

TEST(CanvasLook, PicturesOfNodesThatAreGoneGo) {
  UiSession ui({1280, 800}, {fileOf("states.json", kStates).string()}, json{{"showThumbnails", true}});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(done, 60)) << ui.log();
  const auto count = [](const json& t) { return std::atoi(t["notes"].value("thumbnails", "0").c_str()); };
  ui.move(ui.center("canvas"));
  ui.key("a");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return count(t) >= 4; }));
  const int before = count(ui.trace());
  for (int i = 0; i < 5; ++i) {
    ui.click("header/Map");
    ui.key("Delete");
    EXPECT_TRUE(ui.waitFor([&](const json& t) { return count(t) == before - 1; })) << count(ui.trace());
    ui.key("ctrl+z");
    EXPECT_TRUE(ui.waitFor([&](const json& t) { return count(t) == before; })) << count(ui.trace());
  }
}

TEST(CanvasLook, SearchKeepsOneCategory) {
  UiSession ui({1280, 800}, {fileOf("states.json", kStates).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(done, 60)) << ui.log();
  ui.move(ui.emptySpot());
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("search/field"));
  ui.click("search/category/Light");
  ASSERT_TRUE(ui.waitFor([](const json& t) {
    return !t["notes"].value("search/0", "").empty() && !t["rects"].contains("search/6");
  }));
  ui.screenshot("look-search");
  EXPECT_EQ(ui.trace()["notes"].value("search/0", "").find("Volume"), std::string::npos);
  ui.key("Escape");
}

TEST(CanvasLook, FiveHundredNodes) {
  UiSession ui({1920, 1080}, {fileOf("big.json", cli::bigGraph(500)).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(done, 60)) << ui.log();
  ui.move(ui.center("canvas"));
  ui.key("a");
  ui.settle();
  ui.screenshot("look-500");
  const auto nodesShown = [](const json& t) {
    int count = 0;
    for (const auto& [name, r] : t["rects"].items()) count += name.starts_with("node/");
    return count;
  };
  EXPECT_EQ(nodesShown(ui.trace()), 500);
}

}  // namespace
}  // namespace pileus::test
