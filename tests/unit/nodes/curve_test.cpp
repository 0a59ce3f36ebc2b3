// Curves and ramps as parameter values: what they are at a position, what is refused, files and texts.
#include "nodes/declare/curve.h"

#include <gtest/gtest.h>

#include <random>

#include "nodes/file/serialize.h"
#include "nodes/graph/graph.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

Curve randomCurve(std::mt19937_64& rng, CurveShape shape) {
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<double> xs(2 + rng() % 8);
  for (double& x : xs) x = u(rng);
  std::sort(xs.begin(), xs.end());
  Curve curve{{}, shape};
  for (const double x : xs)
    if (curve.points.empty() || x > curve.points.back().x)
      curve.points.push_back({x, rng() % 4 == 0 && !curve.points.empty() ? curve.points.back().y : u(rng)});
  return curve;
}

TEST(Curve, PassesThroughItsPointsAndNeverBeyondThoseAround) {
  std::mt19937_64 rng(3);
  for (int round = 0; round < 400; ++round) {
    const Curve c = randomCurve(rng, round % 2 ? CurveShape::Smooth : CurveShape::Linear);
    ASSERT_TRUE(checkCurve(c));
    for (const dvec2& p : c.points) ASSERT_EQ(curveAt(c, p.x), p.y);
    EXPECT_EQ(curveAt(c, -1), c.points.front().y);
    EXPECT_EQ(curveAt(c, 2), c.points.back().y);
    for (std::size_t i = 0; i + 1 < c.points.size(); ++i) {
      const dvec2 a = c.points[i], b = c.points[i + 1];
      double last = a.y;
      for (int k = 1; k <= 200; ++k) {
        const double y = curveAt(c, std::min(b.x, a.x + (b.x - a.x) * k / 200));
        ASSERT_GE(y, std::min(a.y, b.y));
        ASSERT_LE(y, std::max(a.y, b.y));
        if (b.y >= a.y)
          ASSERT_GE(y, last - 1e-12) << "falls between rising points";
        else
          ASSERT_LE(y, last + 1e-12) << "rises between falling points";
        last = y;
      }
    }
  }
}

TEST(Curve, SmoothHasNoCornersAndIsTheLineWhereThePointsAre) {
  const Curve c{{{0, 0}, {0.3, 0.2}, {0.6, 0.8}, {1, 1}}, CurveShape::Smooth};
  for (const double x : {0.3, 0.6}) {
    const double e = 1e-6, left = (curveAt(c, x) - curveAt(c, x - e)) / e,
                 right = (curveAt(c, x + e) - curveAt(c, x)) / e;
    EXPECT_NEAR(left, right, 1e-3);
  }
  const Curve corner{c.points, CurveShape::Linear};
  EXPECT_GT(std::abs(curveAt(c, 0.15) - curveAt(corner, 0.15)), 0.005);
  EXPECT_NEAR(curveAt(corner, 0.45), 0.5, 1e-15);
  Curve line{{{0, 0}, {0.1, 0.1}, {0.7, 0.7}, {1, 1}}, CurveShape::Smooth};
  EXPECT_TRUE(isIdentity(line));
  for (int k = 0; k <= 100; ++k) EXPECT_NEAR(curveAt(line, k / 100.0), k / 100.0, 1e-15);
  line.points[1].y = 0.11;
  EXPECT_FALSE(isIdentity(line));
  EXPECT_FALSE(isIdentity({{{0.1, 0.1}, {1, 1}}, CurveShape::Linear})) << "level before its first point";
}

TEST(Ramp, ShapesBetweenStops) {
  Ramp r{{{0.2, dvec3(0)}, {0.6, dvec3(1, 0.5, 0)}}, RampShape::Linear};
  EXPECT_EQ(rampAt(r, 0), dvec3(0));
  EXPECT_EQ(rampAt(r, 1), dvec3(1, 0.5, 0));
  EXPECT_NEAR(rampAt(r, 0.3).x, 0.25, 1e-12);
  r.shape = RampShape::Smooth;
  EXPECT_NEAR(rampAt(r, 0.3).x, 0.25 * 0.25 * 2.5, 1e-12);
  r.shape = RampShape::Constant;
  EXPECT_EQ(rampAt(r, 0.59), dvec3(0));
  EXPECT_EQ(rampAt(r, 0.6), dvec3(1, 0.5, 0));
  EXPECT_TRUE(isWhite({}));
  EXPECT_FALSE(isWhite(r));
}

Graph remap() { return *addNode({}, "volume.remap", {0, 0}, "Remap"); }

std::string refusal(const std::string& param, const ParamValue& value) {
  const auto graph = setParam(remap(), "Remap", param, value);
  return graph ? "" : graph.error().message;
}

TEST(CurveParam, BadOnesAreRefusedWithNodeAndKey) {
  const auto curve = [](std::vector<dvec2> points) { return Curve{std::move(points), CurveShape::Linear}; };
  EXPECT_EQ(refusal("curve", curve({})), "Remap.curve: 0 points are not 1 to 64");
  EXPECT_EQ(refusal("curve", curve({{0, 0}, {1.5, 0}})), "Remap.curve: point 2: x = 1.5 is outside 0..1");
  EXPECT_EQ(refusal("curve", curve({{0, -0.5}})), "Remap.curve: point 1: y = -0.5 is outside 0..1");
  EXPECT_EQ(refusal("curve", curve({{0, std::nan("")}})).substr(0, 24), "Remap.curve: point 1: y ");
  EXPECT_EQ(refusal("curve", curve({{0.5, 0}, {0.5, 1}})),
            "Remap.curve: point 2: x = 0.5 is not above 0.5, that of the point before");
  EXPECT_EQ(refusal("curve", 0.5), "Remap.curve: 0.5 is not a curve: [\"smooth\", [x, y], ...]");
  EXPECT_EQ(refusal("color", Ramp{{{0, dvec3(0.5, 2, 0)}}, RampShape::Linear}),
            "Remap.color: stop 1: g = 2 is outside 0..1");
  EXPECT_EQ(refusal("color", Ramp{{{0.5, dvec3(0)}, {0.2, dvec3(1)}}, RampShape::Linear}),
            "Remap.color: stop 2: position 0.2 lies before 0.5, that of the stop before");
  EXPECT_EQ(refusal("color", curve({{0, 0}})).substr(0, 23), "Remap.color: linear 0 0");
  EXPECT_EQ(refusal("strength", curve({{0, 0}})), "Remap.strength: linear 0 0 is not a number");
}

TEST(CurveParam, TakesNeitherKeysNorLinks) {
  Graph graph = *addNode(remap(), "value.number", {0, 0}, "Number");
  EXPECT_EQ(setKey(graph, "Remap", "curve", 1, Curve{}).error().message, "Remap.curve takes no keys");
  EXPECT_EQ(exposeParam(graph, "Remap", "color", true).error().message, "Remap.color takes no link");
  EXPECT_EQ(*linkRefusal(graph, {"Number", "value", "Remap", "curve", false}), "Remap.curve takes no link");
  EXPECT_FALSE(linkRefusal(graph, {"Number", "value", "Remap", "strength", false}));
}

TEST(CurveParam, FilesHoldReadableListsAndReadBack) {
  const Curve curve{{{0, 0.1}, {1.0 / 3, 0.25}, {1, 1}}, CurveShape::Linear};
  const Ramp ramp{{{0, dvec3(1, 0.5, 0.25)}, {0.75, dvec3(0)}}, RampShape::Smooth};
  const Graph graph = *setParam(*setParam(remap(), "Remap", "curve", curve), "Remap", "color", ramp);
  const std::string text = graphText(graph);
  EXPECT_NE(text.find("\"curve\": [\"linear\", [0, 0.1], [0.3333333333333333, 0.25], [1, 1]]"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\"color\": [\"smooth\", [0, 1, 0.5, 0.25], [0.75, 0, 0, 0]]"), std::string::npos)
      << text;
  const auto read = parseGraph(text);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(read->faults.empty());
  const Node& node = *findNode(read->graph, "Remap");
  EXPECT_EQ(node.params.at("curve"), ParamValue(curve));
  EXPECT_EQ(node.params.at("color"), ParamValue(ramp));
  EXPECT_EQ(graphText(read->graph), text);
}

TEST(CurveParam, FaultsInFilesNameNodeAndKey) {
  const auto fault = [](const std::string& value) {
    const auto read =
        parseGraph(R"({ "pileus": 1, "links": [], "nodes": { "Remap": { "type": "volume.remap", "at": [0, 0],
      "params": { "curve": )" +
                   value + " } } } }");
    return !read || read->faults.empty() ? std::string()
                                         : read->faults[0].where + ": " + read->faults[0].text;
  };
  EXPECT_EQ(fault(R"(["smooth", [0, 0], [1, 1.5]])"), "Remap.curve: point 2: y = 1.5 is outside 0..1");
  for (const char* bad :
       {R"(["bumpy", [0, 0]])", R"(["smooth"])", R"(["smooth", [0, 0], [1]])", R"({ "points": [] })"})
    EXPECT_TRUE(fault(bad).ends_with("is not a value this parameter takes")) << fault(bad);
  EXPECT_EQ(fault(R"({ "keys": [[1, ["smooth", [0, 0]]]] })"), "Remap.curve: takes no keys");
  EXPECT_EQ(fault(R"(["linear", [0, 1, 1, 1]])").substr(0, 13), "Remap.curve: ");
}

TEST(CurveParam, TextReadsBackAndTakesJsonToo) {
  const NodeType& type = *findNodeType("volume.remap");
  const Curve curve{{{0, 0}, {0.25, 1}}, CurveShape::Linear};
  const Ramp ramp{{{0.5, dvec3(1, 0, 0.5)}}, RampShape::Constant};
  EXPECT_EQ(formatParam(*type.param("curve"), curve), "linear 0 0, 0.25 1");
  for (const char* text : {"linear 0 0, 0.25 1", "[\"linear\", [0, 0], [0.25, 1]]"})
    EXPECT_EQ(*parseParam(*type.param("curve"), text), ParamValue(curve)) << text;
  EXPECT_EQ(*parseParam(*type.param("curve"), "0 0 1 1"), ParamValue(Curve{}));
  EXPECT_EQ(formatParam(*type.param("color"), ramp), "constant 0.5 1 0 0.5");
  EXPECT_EQ(*parseParam(*type.param("color"), "constant 0.5 1 0 0.5"), ParamValue(ramp));
  for (const char* text : {"", "bumpy 0 0", "0 0 1", "linear", "0 a"})
    EXPECT_FALSE(parseParam(*type.param("curve"), text)) << text;
}

}  // namespace
}  // namespace pileus::nodes
