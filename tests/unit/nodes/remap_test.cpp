// volume.remap: what becomes of volumes, and when nothing does.
#include <gtest/gtest.h>

#include "nodes/declare/eval_context.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/graph.h"
#include "tests/support/noise_grid.h"

namespace pileus::nodes {
namespace {

/// The node alone, on these volumes.
Result<volume::InstanceList> remapped(const volume::InstanceList& volumes,
                                      const std::map<std::string, ParamValue>& values) {
  const NodeType& type = *findNodeType("volume.remap");
  std::vector<ParamValue> params;
  for (const ParamSpec& spec : type.params)
    params.push_back(values.contains(spec.id) ? values.at(spec.id) : spec.fallback);
  const EvalSettings settings;
  std::any state;
  const Stopwatch clock;
  EvalContext context(settings, nullptr, state, {}, clock);
  const std::vector<std::vector<SocketValue>> inputs{{VolumeValue{volumes}}};
  PILEUS_TRY(const auto out, type.evaluate(inputs, params, context));
  return std::get<VolumeValue>(out[0]).items;
}

volume::Instance boxOf(double density) {
  volume::Instance i;
  i.density = density;
  i.medium.albedo = vec3(0.8f, 0.5f, 0.5f);
  return i;
}

const volume::Instance kGrid = test::gridInstance(test::gridOf(40, test::blobs), 40, 1);
const Curve kHalf{{{0, 0}, {1, 0.5}}, CurveShape::Linear};

TEST(RemapNode, IdentityChangesNothingAtAll) {
  const auto plain = volume::contentKey({kGrid, boxOf(2)});
  EXPECT_EQ(volume::contentKey(*remapped({kGrid, boxOf(2)}, {})), plain);
  const Curve bent{{{0, 0}, {0.5, 0.5}, {1, 1}}, CurveShape::Smooth};
  const auto list = *remapped({kGrid, boxOf(2)}, {{"curve", bent}, {"input_max", 7.0}});
  EXPECT_EQ(volume::contentKey(list), plain) << "points on the line, a range that holds all";
  EXPECT_EQ(list[0].remap, nullptr);
  EXPECT_NE(volume::contentKey(*remapped({kGrid}, {{"input_max", 0.3}})), volume::contentKey({kGrid}))
      << "densities above 0.3 are cut";
  EXPECT_NE(volume::contentKey(*remapped({kGrid}, {{"strength", 2.0}})), volume::contentKey({kGrid}));
}

TEST(RemapNode, ShapesAreRemappedExactly) {
  auto list = *remapped({boxOf(1), boxOf(4)}, {{"curve", kHalf}, {"strength", 3.0}});
  EXPECT_NEAR(list[0].density, 3 * 4 * 0.125, 1e-12) << "one range for all: 0 to 4";
  EXPECT_NEAR(list[1].density, 3 * 4 * 0.5, 1e-12);
  list = *remapped({boxOf(1)}, {{"input_min", 0.5}, {"input_max", 2.5}, {"curve", Curve{{{0, 0}, {1, 1}}}}});
  EXPECT_NEAR(list[0].density, 2.5 * 0.25, 1e-12);
  const Ramp ramp{{{0, dvec3(1, 0, 0)}, {1, dvec3(0, 1, 1)}}, RampShape::Linear};
  list = *remapped({boxOf(1)}, {{"input_max", 4.0}, {"color", ramp}});
  EXPECT_EQ(list[0].medium.albedo, vec3(0.8f * 0.75f, 0.125f, 0.125f));
  EXPECT_NEAR(list[0].density, 1, 1e-12);
}

TEST(RemapNode, GridsKeepTheirVoxels) {
  const auto list = *remapped({kGrid}, {{"curve", kHalf}});
  EXPECT_EQ(list[0].grid, kGrid.grid);
  const dvec3 p(kGrid.worldFromLocal * dvec4(22, 24, 26, 1));
  EXPECT_NEAR(volume::sigmaAt(list[0], p), 0.5 * volume::sigmaAt(kGrid, p), 1e-6);
  const auto twice = *remapped(list, {{"curve", kHalf}});
  EXPECT_NEAR(volume::sigmaAt(twice[0], p), 0.25 * volume::sigmaAt(kGrid, p), 1e-6);
}

TEST(RemapNode, RefusesARangeThatIsNone) {
  EXPECT_EQ(remapped({boxOf(1)}, {{"input_min", 2.0}, {"input_max", 1.5}}).error().message,
            "input_min: 2 is not below 1.5, input_max");
  EXPECT_EQ(remapped({boxOf(1)}, {{"input_min", 2.0}}).error().message,
            "input_min: 2 is not below 1, the largest density");
  EXPECT_TRUE(remapped({}, {{"input_min", 2.0}})) << "nothing linked holds nothing";
}

TEST(RemapNode, EditsEvaluateThisNodeAlone) {
  Graph graph =
      parseGraph(R"({"pileus": 1, "nodes": {"Box": {"type": "volume.box"}, "Remap": {"type": "volume.remap"}},
                               "links": ["Box.volume -> Remap.volume"]})")
          ->graph;
  Evaluator evaluator{nullptr};
  evaluator.evaluate(graph, {"Remap"}, {});
  graph = *setParam(graph, "Remap", "curve", kHalf);
  evaluator.evaluate(graph, {"Remap"}, {});
  EXPECT_EQ(evaluator.status("Box").evaluations, 1u);
  EXPECT_EQ(evaluator.status("Remap").evaluations, 2u) << "another curve is another key";
  const auto& out = std::get<VolumeValue>(*evaluator.output("Remap", "volume")).items;
  EXPECT_EQ(out[0].density, 0.5);
}

}  // namespace
}  // namespace pileus::nodes
