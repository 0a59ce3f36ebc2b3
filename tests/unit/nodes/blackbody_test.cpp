// volume.blackbody: what becomes of volumes.
#include <gtest/gtest.h>

#include "nodes/declare/eval_context.h"
#include "nodes/declare/value.h"
#include "nodes/graph/graph.h"
#include "renderer/scene/black_body.h"
#include "tests/support/noise_grid.h"

namespace pileus::nodes {
namespace {

/// A node alone, on these volumes.
Result<volume::InstanceList> through(const std::string& id, const volume::InstanceList& volumes,
                                     const std::map<std::string, ParamValue>& values,
                                     std::vector<std::string>* notes = nullptr) {
  const NodeType& type = *findNodeType(id);
  std::vector<ParamValue> params;
  for (const ParamSpec& spec : type.params)
    params.push_back(values.contains(spec.id) ? values.at(spec.id) : spec.fallback);
  const EvalSettings settings;
  std::any state;
  const Stopwatch clock;
  EvalContext context(settings, nullptr, state, {}, clock);
  const std::vector<std::vector<SocketValue>> inputs{{VolumeValue{volumes}}};
  PILEUS_TRY(const auto out, type.evaluate(inputs, params, context));
  if (notes) *notes = context.notes();
  return std::get<VolumeValue>(out[0]).items;
}
Result<volume::InstanceList> glowing(const volume::InstanceList& volumes,
                                     const std::map<std::string, ParamValue>& values = {},
                                     std::vector<std::string>* notes = nullptr) {
  return through("volume.blackbody", volumes, values, notes);
}

volume::Instance boxOf(double density) {
  volume::Instance i;
  i.density = density;
  return i;
}

const volume::Instance kGrid = test::gridInstance(test::gridOf(40, test::blobs), 40, 1);
const dvec3 kHot(kGrid.worldFromLocal* dvec4(22, 24, 26, 1));

TEST(BlackBodyNode, VolumesGlowAndHaveNoExtinction) {
  const auto list = *glowing({kGrid, boxOf(0.5)}, {{"input_max", 1.0}, {"strength", 3.0}});
  for (const volume::Instance& i : list) {
    EXPECT_TRUE(volume::emits(i));
    EXPECT_EQ(volume::majorant(i), 0);
  }
  const dvec3 half = 3.0 * scene::blackBodyColor(1600, 2200), box = volume::emissionAt(list[1], dvec3(0));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(box[c], half[c], 3e-3 * half[c]) << "half way from 1000 to 2200 K";
  EXPECT_GT(volume::emissionAt(list[0], kHot).r, box.r);
}

TEST(BlackBodyNode, TheRangeIsTheDatas) {
  const auto list = *glowing({boxOf(1), boxOf(4)}, {{"hottest", 2000.0}});
  const dvec3 hottest = scene::blackBodyColor(2000, 2000), got = volume::emissionAt(list[1], dvec3(0));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], hottest[c], 1e-5);
  EXPECT_LT(volume::emissionAt(list[0], dvec3(0)).g, 0.05 * hottest.g) << "1250 K";
  EXPECT_EQ(glowing({boxOf(1)}, {{"input_min", 2.0}}).error().message,
            "input_min: 2 is not below 1, the largest value");
  EXPECT_EQ(glowing({boxOf(1)}, {{"input_min", 2.0}, {"input_max", 1.5}}).error().message,
            "input_min: 2 is not below 1.5, input_max");
  EXPECT_TRUE(glowing({})) << "nothing linked holds nothing";
}

TEST(BlackBodyNode, TheCurveIsTheTemperature) {
  const Curve off{{{0, 0}, {0.6, 0}, {1, 1}}, CurveShape::Linear};
  const auto list = *glowing({boxOf(0.5), boxOf(1)}, {{"curve", off}});
  EXPECT_FALSE(volume::emits(list[0])) << "0 does not glow, whatever the coolest is";
  EXPECT_TRUE(volume::emits(list[1]));
}

TEST(BlackBodyNode, ComesBehindARemapAndStaysWhatItIs) {
  const Curve half{{{0, 0}, {1, 0.5}}, CurveShape::Linear};
  const auto remapped = *through("volume.remap", {kGrid}, {{"curve", half}, {"input_max", 1.0}});
  const auto list = *glowing(remapped, {{"input_max", 1.0}});
  EXPECT_EQ(list[0].remap, nullptr);
  const auto plain = *glowing({kGrid}, {{"input_max", 2.0}});
  const dvec3 a = volume::emissionAt(list[0], kHot), b = volume::emissionAt(plain[0], kHot);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 0.01 * b[c]);
  // What glows already is left alone by nodes that change densities.
  const Key key = volume::contentKey(list);
  EXPECT_EQ(volume::contentKey(*glowing(list, {{"strength", 9.0}})), key);
  EXPECT_EQ(volume::contentKey(*through("volume.remap", list, {{"strength", 9.0}})), key);
  const auto medium = *through("volume.medium", list, {{"extinction", 9.0}});
  EXPECT_EQ(volume::majorant(medium[0]), 0);
  EXPECT_EQ(volume::emissionAt(medium[0], kHot), a);
}

TEST(BlackBodyNode, SaysWhatItTakesValuesFor) {
  std::vector<std::string> notes;
  ASSERT_TRUE(glowing({boxOf(1)}, {}, &notes));
  EXPECT_EQ(notes, std::vector<std::string>{"Values 0 to 1 become 1000 to 2200 K"});
  ASSERT_TRUE(glowing({boxOf(1800)}, {}, &notes));
  EXPECT_NE(notes[0].find("look like kelvins"), std::string::npos);
}

}  // namespace
}  // namespace pileus::nodes
