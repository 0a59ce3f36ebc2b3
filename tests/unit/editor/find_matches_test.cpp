#include "editor/graph_view/search/find_matches.h"

#include <gtest/gtest.h>

#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

nodes::Graph graph() {
  nodes::Graph g;
  const auto add = [&](const char* type, const char* name) { g = *nodes::addNode(g, type, dvec2(0), name); };
  add("volume.cloud", "Clouds");
  add("volume.box", "Haze");
  add("light.sun", "Evening");
  add("render.volume", "Render");
  g = *nodes::setParam(g, "Clouds", "coverage", 0.3625);
  return g;
}

std::vector<std::string> names(const std::vector<FindMatch>& matches) {
  std::vector<std::string> out;
  for (const FindMatch& m : matches) out.push_back(m.node);
  return out;
}

TEST(Find, AnimatedValuesAreThoseOfTheFrame) {
  nodes::Graph g = graph();
  g = *nodes::setKey(g, "Evening", "elevation", 1, 10.0, nodes::Interpolation::Linear);
  g = *nodes::setKey(g, "Evening", "elevation", 11, 40.0, nodes::Interpolation::Linear);
  EXPECT_EQ(findMatches(g, "evening elevation", 6).at(0).where.substr(0, 12), "Elevation 25");
  EXPECT_EQ(findMatches(g, "evening elevation").at(0).where.substr(0, 12), "Elevation 10");
}

TEST(Find, NamesTypesParametersAndValues) {
  const nodes::Graph g = graph();
  EXPECT_EQ(names(findMatches(g, "haz")), std::vector<std::string>{"Haze"});
  EXPECT_EQ(names(findMatches(g, "light.sun")), std::vector<std::string>{"Evening"});
  EXPECT_EQ(findMatches(g, "coverage").at(0).node, "Clouds");
  const std::vector<FindMatch> value = findMatches(g, "0.3625");
  ASSERT_EQ(value.size(), 1u);
  EXPECT_EQ(value[0].where, "Coverage 0.3625");
}

TEST(Find, EveryWordHasToBeThere) {
  const nodes::Graph g = graph();
  EXPECT_EQ(names(findMatches(g, "clouds COVERAGE")), std::vector<std::string>{"Clouds"});
  EXPECT_TRUE(findMatches(g, "clouds elevation").empty());
  EXPECT_TRUE(findMatches(g, "  ").empty());
  EXPECT_TRUE(findMatches(g, "no such thing").empty());
}

TEST(Find, NamesComeBeforeTypes) {
  nodes::Graph g = graph();
  g = *nodes::addNode(g, "volume.box", dvec2(0), "Zebra sun");
  EXPECT_EQ(findMatches(g, "sun").at(0).node, "Zebra sun");
  EXPECT_EQ(findMatches(g, "sun").at(1).node, "Evening");
}

TEST(Find, InsideGroupsToo) {
  std::string name;
  const Result<nodes::Graph> g = nodes::groupNodes(graph(), {"Clouds"}, &name);
  ASSERT_TRUE(g) << g.error().message;
  const std::vector<FindMatch> found = findMatches(*g, "clouds");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].node, "Clouds");
  EXPECT_EQ(found[0].scope, std::vector<std::string>{name});
}

}  // namespace
}  // namespace pileus::editor
