// Variations: kept in the document, blended, and exact at their ends.
#include "nodes/file/variations.h"

#include <gtest/gtest.h>

#include "nodes/file/serialize.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::nodes {
namespace {

Graph scene() {
  Graph g = *addNode({}, "light.sun", {0, 0}, "Sun");
  g = *addNode(g, "render.volume", {300, 0}, "Render");
  g = *connect(g, {"Sun", "light", "Render", "lights"});
  g = *addNode(g, "light.point", {0, 200}, "Lamp");
  return *groupNodes(g, {"Lamp"});
}

Graph set(Graph g, const std::string& node, const std::string& param, const ParamValue& value) {
  const auto changed = setParamAt(g, node, param, value, 1);
  EXPECT_TRUE(changed) << (changed ? "" : changed.error().message);
  return changed ? *changed : g;
}

ParamValue value(const Graph& g, const std::string& path, const std::string& id) {
  const Node* node = findNodeAt(g, path);
  return paramValue(*node, *findNodeType(node->type)->param(id));
}

TEST(Variations, AreKeptInTheDocument) {
  Graph a = scene(), b = set(scene(), "Sun", "elevation", 5.0);
  b = *setKey(b, "Sun", "irradiance", 3, 7.0);
  b = set(b, "Group/Lamp", "intensity", 0.1);
  const Graph kept = withVariations(a, {{"Noon", valuesOf(a)}, {"D\xc3\xa4mmerung / 2", valuesOf(b)}});
  const std::string text = graphText(kept);
  const auto loaded = parseGraph(text);
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->faults.empty()) << faultText(loaded->faults.front());
  EXPECT_EQ(graphText(loaded->graph), text);
  const auto read = variationsOf(loaded->graph);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[1].name, "D\xc3\xa4mmerung / 2");
  EXPECT_TRUE((*read)[0].values == valuesOf(a));
  EXPECT_TRUE((*read)[1].values == valuesOf(b));
  EXPECT_TRUE(withVariations(kept, {}) == a);
  EXPECT_EQ(freeVariationName({{"Variation 2", {}}}), "Variation 3");

  // What cannot be understood is said, and stays.
  for (const char* bad : {"3", "[3]", R"([{"name":"a"}])", R"([{"graph":{},"name":"a"}])"}) {
    Graph broken = a;
    broken.unknown["variations"] = bad;
    EXPECT_FALSE(variationsOf(broken)) << bad;
    EXPECT_TRUE(parseGraph(graphText(broken))->graph == broken) << bad;
  }
}

TEST(Variations, BlendsAreExactAtTheirEnds) {
  Graph a = set(scene(), "Sun", "elevation", 0.1), b = set(scene(), "Sun", "elevation", 33.3);
  a = set(a, "Sun", "color", dvec3(0.1, 0.2, 0.3));
  b = set(b, "Group/Lamp", "position", dvec3(1.0 / 3, 2, 3));
  a = set(a, "Sun", "disc_samples", 3);
  const Graph va = valuesOf(a), vb = valuesOf(b);
  EXPECT_TRUE(blendedValues(va, vb, 0) == va);
  EXPECT_TRUE(blendedValues(va, vb, 1) == vb);
  // Put into a document they are that document again.
  EXPECT_TRUE(withValues(b, blendedValues(va, vb, 0)) == a);
  EXPECT_TRUE(withValues(a, blendedValues(va, vb, 1)) == b);
  const std::vector<Variation> row{{"a", va}, {"b", vb}, {"c", va}};
  EXPECT_TRUE(blendedValues(row, -1) == va);
  EXPECT_TRUE(blendedValues(row, 1) == vb);
  EXPECT_TRUE(blendedValues(row, 2) == va);
  EXPECT_TRUE(blendedValues(row, 7) == va);
  EXPECT_TRUE(blendedValues({{"a", va}}, 0.5) == va);
  EXPECT_TRUE(blendedValues({}, 0.5).nodes.empty());
}

TEST(Variations, EachKindGoesItsWay) {
  Graph a = scene(), b = scene();
  a = set(a, "Sun", "azimuth", 350.0), b = set(b, "Sun", "azimuth", 20.0);
  a = set(a, "Sun", "elevation", -80.0), b = set(b, "Sun", "elevation", 80.0);
  a = set(a, "Sun", "color", dvec3(1, 0, 0)), b = set(b, "Sun", "color", dvec3(0, 0.5, 0));
  a = set(a, "Sun", "disc_samples", 2), b = set(b, "Sun", "disc_samples", 5);
  b = set(b, "Render", "scattering", std::string("single"));
  b = *setKey(b, "Sun", "irradiance", 3, 7.0);
  const auto at = [&](double t) { return withValues(a, blendedValues(valuesOf(a), valuesOf(b), t)); };
  EXPECT_NEAR(std::get<double>(value(at(0.5), "Sun", "azimuth")), 365, 1e-9) << "the short way";
  EXPECT_NEAR(std::get<double>(value(at(0.5), "Sun", "elevation")), 0, 1e-9) << "not over the zenith";
  EXPECT_EQ(std::get<dvec3>(value(at(0.5), "Sun", "color")), dvec3(0.5, 0.25, 0));
  EXPECT_EQ(std::get<int>(value(at(0.5), "Sun", "disc_samples")), 4);
  EXPECT_EQ(std::get<std::string>(value(at(0.49), "Render", "scattering")), "grid");
  EXPECT_EQ(std::get<std::string>(value(at(0.5), "Render", "scattering")), "single");
  EXPECT_FALSE(findNode(at(0.49), "Sun")->animated.contains("irradiance"));
  EXPECT_TRUE(findNode(at(0.5), "Sun")->animated.contains("irradiance"));
  // A value that is the default half way is not written out.
  Graph c = set(scene(), "Sun", "irradiance", 0.0), d = set(scene(), "Sun", "irradiance", 20.0);
  EXPECT_TRUE(withValues(c, blendedValues(valuesOf(c), valuesOf(d), 0.5)) == scene());
}

TEST(Variations, NodesThatCameOrWentAreLeftAlone) {
  const Graph a = set(scene(), "Sun", "elevation", 1.0);
  Graph now = *addNode(scene(), "light.sun", {0, 0}, "New");
  now = set(now, "New", "elevation", 2.0);
  now = removeNodes(now, {"Render"});
  const Graph after = withValues(now, valuesOf(a));
  EXPECT_EQ(std::get<double>(value(after, "Sun", "elevation")), 1.0);
  EXPECT_EQ(std::get<double>(value(after, "New", "elevation")), 2.0);
  EXPECT_EQ(findNode(after, "Render"), nullptr);
  // A name that stands for another type now.
  Graph other = *addNode({}, "light.point", {0, 0}, "Sun");
  EXPECT_TRUE(withValues(other, valuesOf(a)) == other);
  EXPECT_TRUE(blendedValues(valuesOf(other), valuesOf(a), 0.5).nodes.empty());
}

}  // namespace
}  // namespace pileus::nodes
