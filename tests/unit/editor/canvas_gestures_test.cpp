// What canvas gestures decide without a window: frames, links under dragged nodes, what can be viewed.
#include <gtest/gtest.h>

#include "editor/graph_view/frames.h"
#include "editor/graph_view/layout/hit_test.h"
#include "editor/graph_view/move_gesture.h"
#include "editor/graph_view/node_colors.h"
#include "editor/picture/viewed_node.h"
#include "editor/preferences/settings.h"

namespace pileus::editor {
namespace {

nodes::Graph scene() {
  nodes::Graph graph = *nodes::addNode({}, "light.sun", {0, 0}, "Sun");
  graph = *nodes::addNode(graph, "shadow.extinction", {320, 0}, "Map");
  graph = *nodes::addNode(graph, "render.volume", {900, 0}, "Render");
  graph = *nodes::addNode(graph, "light.point", {0, 400}, "Lamp");
  graph = *nodes::connect(graph, {"Sun", "light", "Map", "light"});
  return *nodes::connect(graph, {"Map", "light", "Render", "lights"});
}

TEST(Frames, AreHeldByHeaderAndSides) {
  nodes::Graph graph;
  graph.frames.push_back({"Lights", "", {0, 0}, {300, 200}, {}});
  ASSERT_TRUE(frameAt(graph, {150, 15}, 1));
  EXPECT_FALSE(frameAt(graph, {150, 15}, 1)->sides.any());
  EXPECT_FALSE(frameAt(graph, {150, 100}, 1)) << "the room inside belongs to the canvas";
  const auto corner = frameAt(graph, {299, 199}, 1);
  ASSERT_TRUE(corner);
  EXPECT_TRUE(corner->sides.right && corner->sides.bottom && !corner->sides.left && !corner->sides.top);
  EXPECT_TRUE(frameAt(graph, {150, 80}, 0.2f)) << "far away the header is as tall as a pointer needs";
  EXPECT_FALSE(frameAt(graph, {500, 500}, 1));
}

TEST(Frames, ResizeKeepsTheOtherSidesAndASmallestSize) {
  const nodes::Frame frame{"", "", {0, 0}, {300, 200}, {}};
  FrameSides right;
  right.right = true;
  EXPECT_EQ(resized(frame, right, {50, 90}).size, dvec2(350, 200));
  FrameSides left;
  left.left = true;
  const nodes::Frame small = resized(frame, left, {1000, 0});
  EXPECT_EQ(small.at.x + small.size.x, 300);
  EXPECT_GT(small.size.x, 20);
}

TEST(MoveGesture, FindsTheLinkUnderANodeThatFits) {
  nodes::Graph graph = *nodes::addNode(scene(), "shadow.extinction", {0, 0}, "Second");
  const auto under = [&](const std::string& name, dvec2 at) {
    const nodes::Graph moved = nodes::moveNodes(graph, {name}, at - nodes::findNode(graph, name)->at);
    return linkUnder(layoutGraph(moved, {}), moved, name);
  };
  const nodes::Link link{"Map", "light", "Render", "lights"};
  EXPECT_EQ(under("Second", {610, -20}), link);
  EXPECT_FALSE(under("Second", {610, 600}));
  EXPECT_FALSE(under("Lamp", {610, -20})) << "a light takes no light";
  EXPECT_FALSE(under("Sun", {610, -20})) << "it has links already";
}

TEST(ViewedNode, FindsThePictureANodeTakesPartIn) {
  const nodes::Graph graph = scene();
  EXPECT_EQ(imageOutput(graph, "Render"), "image");
  EXPECT_EQ(imageOutput(graph, "Sun"), "");
  EXPECT_TRUE(viewable(graph, "Render"));
  EXPECT_FALSE(viewable(graph, "Sun"));
  EXPECT_EQ(nearestPicture(graph, "Sun"), "Render");
  EXPECT_EQ(nearestPicture(graph, "Lamp"), "");
  EXPECT_EQ(nearestPicture(graph, "Nobody/At all"), "");
  ViewSlots slots;
  slots[2] = "Render";
  EXPECT_EQ(slotOf(slots, "Render"), 3);
  EXPECT_EQ(slotOf(slots, "Sun"), 0);
}

TEST(NodeColors, AreReadFromAnyHexadecimalColour) {
  EXPECT_NE(nodeColor("#ff8000"), 0u);
  EXPECT_NE(nodeColor("#ff8000"), nodeColor("#0080ff"));
  for (const char* bad : {"", "#ff80", "ff8000", "#gg0000", "#ff80001"}) EXPECT_EQ(nodeColor(bad), 0u) << bad;
  for (const NodeColor& c : nodeColors()) EXPECT_TRUE(!*c.id || nodeColor(c.id)) << c.label;
}

TEST(Bookmarks, AreKeptPerFileAndDamageIsLeftOut) {
  Settings settings;
  settings.bookmarks = {{"/a/b.json", {}}};
  settings.bookmarks[0].places[3] = CanvasPlace{{"Group"}, {12.5, -3}, 4};
  EXPECT_EQ(settingsFromText(settingsText(settings)).bookmarks, settings.bookmarks);
  settings.bookmarks.push_back({"", {}});
  settings.bookmarks[1].places[0] = CanvasPlace{};
  EXPECT_EQ(settingsFromText(settingsText(settings)).bookmarks.size(), 1u)
      << "an unsaved document is forgotten";
  EXPECT_TRUE(settingsFromText(R"({"bookmarks": {"/a": 3}})").bookmarks.empty());
  const Settings odd = settingsFromText(R"({"bookmarks": {"/a": {"0": {}, "12": {}, "2": {"x": "no"}}}})");
  ASSERT_EQ(odd.bookmarks.size(), 1u);
  EXPECT_TRUE(odd.bookmarks[0].places[1]);
  EXPECT_FALSE(odd.bookmarks[0].places[0]);
}

}  // namespace
}  // namespace pileus::editor
