#include "editor/graph_view/layout/layout.h"

#include <gtest/gtest.h>

#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_edits.h"

namespace pileus::editor {
namespace {

nodes::Graph graph() {
  nodes::Graph g;
  g = *nodes::addNode(g, "light.sun", dvec2(0, 0), "Sun");
  g = *nodes::addNode(g, "volume.cloud", dvec2(0, 300), "Clouds");
  g = *nodes::addNode(g, "shadow.pseudometric", dvec2(300, 0), "Metric");
  g = *nodes::addNode(g, "render.volume", dvec2(600, 0), "Render");
  g = *nodes::connect(g, {"Sun", "light", "Metric", "light"});
  g = *nodes::connect(g, {"Clouds", "volume", "Metric", "volumes"});
  return g;
}

TEST(Layout, LinksEndAtTheirSockets) {
  const nodes::Graph g = graph();
  const Layout layout = layoutGraph(g, {"Clouds"});
  ASSERT_EQ(layout.links.size(), 2u);
  EXPECT_EQ(layout.nodes.back().name, "Clouds");  // raised
  for (const LinkPlace& l : layout.links) {
    const nodes::Link& link = g.links[static_cast<std::size_t>(l.link)];
    const NodePlace* from = findPlace(layout, link.fromNode);
    ASSERT_NE(from, nullptr);
    EXPECT_EQ(findSocket(*from, link.fromSocket, false)->at, l.a);
    EXPECT_TRUE(findSocket(*from, link.fromSocket, false)->linked);
    EXPECT_EQ(&layout.nodes[static_cast<std::size_t>(l.from)], from);
  }
  EXPECT_EQ(findPlace(layout, "Nobody"), nullptr);
  EXPECT_FALSE(findSocket(*findPlace(layout, "Render"), "volumes", true)->linked);
}

TEST(Layout, PicturesMakeRoomBelowTheSocketsAlone) {
  const nodes::Graph g = graph();
  const Layout plain = layoutGraph(g, {}), all = layoutGraph(g, {}, {true, {"Render"}});
  EXPECT_EQ(findPlace(all, "Sun")->max, findPlace(plain, "Sun")->max);        // makes none
  EXPECT_EQ(findPlace(all, "Render")->max, findPlace(plain, "Render")->max);  // the exception
  const NodePlace *before = findPlace(plain, "Metric"), *after = findPlace(all, "Metric");
  EXPECT_EQ(after->thumbnail, Thumbnail::Map);
  EXPECT_GT(after->max.y, before->max.y);
  EXPECT_GE(after->pictureMin.y, before->sockets.back().at.y);
  EXPECT_LE(after->pictureMax.y, after->max.y);
  EXPECT_EQ(findSocket(*after, "light", true)->at, findSocket(*before, "light", true)->at);
  EXPECT_EQ(findPlace(layoutGraph(g, {}, {false, {"Render"}}), "Render")->thumbnail, Thumbnail::Image);
  EXPECT_EQ(thumbnailKind(*nodes::findNodeType("light.sky")), Thumbnail::Environment);
  EXPECT_EQ(thumbnailKind(*nodes::findNodeType("light.environment")), Thumbnail::Environment);
}

TEST(Layout, AnExposedParameterIsASocketWithItsValue) {
  nodes::Graph g = graph();
  g = *nodes::setParam(g, "Sun", "elevation", 25.0);
  g = *nodes::exposeParam(g, "Sun", "elevation", true);
  const Layout layout = layoutGraph(g, {});
  const SocketPlace* s = findSocket(*findPlace(layout, "Sun"), "elevation", true);
  ASSERT_NE(s, nullptr);
  EXPECT_TRUE(s->value.starts_with("25")) << s->value;
  EXPECT_EQ(s->type, nodes::SocketType::Number);
  EXPECT_FALSE(layout.animated);

  g = *nodes::setKey(g, "Sun", "elevation", 1, 10.0, nodes::Interpolation::Linear);
  g = *nodes::setKey(g, "Sun", "elevation", 11, 40.0, nodes::Interpolation::Linear);
  const Layout later = layoutGraph(g, {}, {}, 6);
  EXPECT_TRUE(later.animated);
  EXPECT_TRUE(findSocket(*findPlace(later, "Sun"), "elevation", true)->value.starts_with("25"));
  EXPECT_TRUE(findSocket(*findPlace(layoutGraph(g, {}), "Sun"), "elevation", true)->value.starts_with("10"));
}

TEST(Layout, ADotIsSmallWithASocketAtEitherSide) {
  std::string name;
  const nodes::Graph g = *nodes::addDot(graph(), {"Sun", "light", "Metric", "light"}, dvec2(250, 40), &name);
  const Layout layout = layoutGraph(g, {});
  const NodePlace* dot = findPlace(layout, name);
  ASSERT_NE(dot, nullptr);
  EXPECT_TRUE(dot->dot);
  ASSERT_EQ(dot->sockets.size(), 2u);
  EXPECT_EQ(dot->sockets[0].at.y, dot->sockets[1].at.y);
  EXPECT_LT(dot->max.x - dot->min.x, kNodeWidth / 2);
}

}  // namespace
}  // namespace pileus::editor
