// What of the canvas is under a point, and what a line across it meets.
#include "editor/graph_view/layout/hit_test.h"

#include <gtest/gtest.h>

#include "editor/graph_view/layout/path_geometry.h"

namespace pileus::editor {
namespace {

nodes::Graph twoNodes() {
  nodes::Graph graph = *nodes::addNode({}, "light.sun", {0, 0}, "Sun");
  return *nodes::addNode(graph, "shadow.extinction", {300, 0}, "Map");
}

TEST(HitTest, FindsBodiesDotsAndLabels) {
  const nodes::Graph graph = *nodes::connect(twoNodes(), {"Sun", "light", "Map", "light"});
  const Layout layout = layoutGraph(graph, {});
  const NodePlace& sun = *findPlace(layout, "Sun");
  const SocketPlace& out = *findSocket(sun, "light", false);
  const SocketPlace& in = *findSocket(*findPlace(layout, "Map"), "light", true);
  EXPECT_EQ(hitTest(layout, graph, sun.min + vec2(60, 10), 1, {}).kind, Hit::Kind::Node);
  EXPECT_EQ(hitTest(layout, graph, out.at, 1, {}).kind, Hit::Kind::Output);
  EXPECT_EQ(hitTest(layout, graph, out.at - vec2(30, 0), 1, {}).kind, Hit::Kind::Output)
      << "the label belongs to the socket";
  EXPECT_EQ(hitTest(layout, graph, in.at + vec2(30, 0), 1, {}).kind, Hit::Kind::Input);
  EXPECT_EQ(hitTest(layout, graph, 0.5f * (out.at + in.at), 1, {}).kind, Hit::Kind::Link);
  EXPECT_EQ(hitTest(layout, graph, {-500, -500}, 1, {}).kind, Hit::Kind::Canvas);
  EXPECT_EQ(nodesInside(layout, {-10, -10}, {10, 10}), std::set<std::string>{"Sun"});
}

TEST(HitTest, SocketsKnowTheirLinks) {
  const nodes::Link link{"Sun", "light", "Map", "light"};
  const nodes::Graph graph = *nodes::connect(twoNodes(), link);
  const Layout layout = layoutGraph(graph, {});
  const SocketPlace& out = *findSocket(*findPlace(layout, "Sun"), "light", false);
  const SocketPlace& in = *findSocket(*findPlace(layout, "Map"), "light", true);
  EXPECT_EQ(hitTest(layout, graph, out.at, 1, {}).links, std::vector<nodes::Link>{link});
  EXPECT_EQ(hitTest(layout, graph, in.at, 1, {}).links, std::vector<nodes::Link>{link});
  EXPECT_EQ(hitTest(layout, graph, in.at, 1, {}).taken, link);
  Interaction dragging;
  dragging.state = Interaction::State::DraggingLink;
  dragging.link = {true, "Other", "light", {}};
  EXPECT_EQ(hitTest(layout, graph, out.at - vec2(30, 0), 1, dragging).kind, Hit::Kind::Node)
      << "the label of a socket that cannot be meant is a part of the node";
}

TEST(Paths, CrossLinksAndSurroundNodes) {
  const nodes::Link link{"Sun", "light", "Map", "light"};
  const nodes::Graph graph = *nodes::connect(twoNodes(), link);
  const Layout layout = layoutGraph(graph, {});
  const vec2 a = findSocket(*findPlace(layout, "Sun"), "light", false)->at;
  const vec2 b = findSocket(*findPlace(layout, "Map"), "light", true)->at;
  const vec2 middle = 0.5f * (a + b);
  const auto crossed = crossings(layout, graph, {middle - vec2(0, 100), middle + vec2(0, 100)});
  ASSERT_EQ(crossed.size(), 1u);
  EXPECT_EQ(crossed[0].link, link);
  EXPECT_NEAR(crossed[0].at.x, middle.x, 1);
  EXPECT_NEAR(crossed[0].at.y, middle.y, 2);
  EXPECT_TRUE(crossings(layout, graph, {middle + vec2(0, 50), middle + vec2(0, 100)}).empty());
  const std::vector<vec2> round{{-30, -30}, {220, -30}, {220, 200}, {-30, 200}};
  EXPECT_EQ(nodesAround(layout, round), std::set<std::string>{"Sun"});
  EXPECT_TRUE(nodesAround(layout, {{-90, -90}, {-50, -90}, {-50, -50}}).empty());
  float distance = 0;
  EXPECT_TRUE(passesThrough(linkCurve(a, b), middle - 10.0f, middle + 10.0f, distance));
  EXPECT_LT(distance, 10);
  EXPECT_FALSE(passesThrough(linkCurve(a, b), middle + vec2(0, 100), middle + vec2(10, 110), distance));
}

}  // namespace
}  // namespace pileus::editor
