// The timeline's arithmetic: ticks, frames and pixels, picking keys, and the clock that drops frames.
#include "editor/time/timeline.h"

#include <gtest/gtest.h>

#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

AnimatedRow row(const std::string& node, std::initializer_list<double> frames) {
  AnimatedRow r{node, "x", {}, {}};
  for (const double f : frames) r.keys.push_back({f, 1.0, nodes::Interpolation::Linear});
  return r;
}

TEST(Timeline, TicksAreRoundAndWideEnough) {
  EXPECT_EQ(tickStep(100, 60), 1);
  EXPECT_EQ(tickStep(40, 60), 2);
  EXPECT_EQ(tickStep(10, 60), 10);
  EXPECT_EQ(tickStep(2.9, 60), 50);
  for (double pixels = 1e-5; pixels < 500; pixels *= 1.7) EXPECT_GE(tickStep(pixels, 60) * pixels, 60);
}

TEST(Timeline, FramesAndPixelsGoBothWays) {
  FrameScale scale{1, 101, 200, 1200};
  EXPECT_DOUBLE_EQ(scale.toPixel(1), 200);
  EXPECT_DOUBLE_EQ(scale.toPixel(51), 700);
  EXPECT_DOUBLE_EQ(scale.toFrame(scale.toPixel(33.25)), 33.25);
  const double at = scale.toFrame(450);
  scale.zoom(450, 0.5);
  EXPECT_NEAR(scale.toFrame(450), at, 1e-9) << "the frame below the pointer stays";
  EXPECT_DOUBLE_EQ(scale.last - scale.first, 50);
  scale.pan(20);
  EXPECT_NEAR(scale.toFrame(470), at, 1e-9) << "frames follow the pointer";
  scale.fit({1, 1});
  EXPECT_GE(scale.last - scale.first, 24) << "one frame is not all there is to see";
}

TEST(Timeline, KeysArePickedByRowAndNearestFrame) {
  const std::vector<AnimatedRow> rows = {row("A", {1, 10}), row("B", {10, 11})};
  EXPECT_EQ(keysAt(rows, 1, 10.4, 1), (KeySelection{{"A", "x", 10}}));
  EXPECT_EQ(keysAt(rows, 2, 10.6, 1), (KeySelection{{"B", "x", 11}}));
  EXPECT_EQ(keysAt(rows, 0, 10.1, 1), (KeySelection{{"A", "x", 10}, {"B", "x", 10}}))
      << "the summary holds all";
  EXPECT_TRUE(keysAt(rows, 1, 5, 1).empty());
  EXPECT_EQ(keysAt(rows, 2, 10.5, 1).size(), 1u) << "between two frames: one of them";
}

TEST(Timeline, ABoxTakesItsRowsInAnyDirection) {
  const std::vector<AnimatedRow> rows = {row("A", {1, 10}), row("B", {10, 11}), row("C", {5})};
  const KeySelection expected{{"A", "x", 10}, {"B", "x", 10}};
  EXPECT_EQ(keysInBox(rows, 1, 2, 2, 10.5), expected);
  EXPECT_EQ(keysInBox(rows, 2, 1, 10.5, 2), expected);
  EXPECT_EQ(keysInBox(rows, 0, 0, 4, 6), (KeySelection{{"C", "x", 5}})) << "the summary row stands for all";
  EXPECT_EQ(keysInBox(rows, 3, 3, 0, 4).size(), 0u);
}

TEST(Timeline, NeighbouringKeys) {
  const std::vector<AnimatedRow> rows = {row("A", {1, 10}), row("B", {4})};
  EXPECT_EQ(keyBeside(rows, 1, 1), 4);
  EXPECT_EQ(keyBeside(rows, 10, -1), 4);
  EXPECT_EQ(keyBeside(rows, 10, 1), std::nullopt);
  EXPECT_EQ(keyBeside(rows, 1, -1), std::nullopt);
}

TEST(Timeline, RowsBearNamesForTheUserAndAreKept) {
  nodes::Graph graph = *nodes::addNode(nodes::Graph{}, "volume.medium", {}, "Fog");
  graph = *nodes::setKey(graph, "Fog", "anisotropy", 1, 0.5);
  nodes::Document document(graph);
  KeyRowsCache cache;
  const std::string label = nodes::findNodeType("volume.medium")->param("anisotropy")->label;
  ASSERT_EQ(shownRows(cache, document).size(), 1u);
  EXPECT_EQ(cache.rows[0].title, "Fog \xc2\xb7 " + label);
  EXPECT_NE(label, "anisotropy");
  cache.rows[0].title = "kept";
  EXPECT_EQ(shownRows(cache, document)[0].title, "kept") << "nothing has changed";
  document.select({"Fog"});
  EXPECT_NE(shownRows(cache, document)[0].title, "kept");
  document.edit(*nodes::setKey(document.graph(), "Fog", "anisotropy", 7, 0.2), "key");
  EXPECT_EQ(shownRows(cache, document)[0].keys.size(), 2u);
  document.undo();
  EXPECT_EQ(shownRows(cache, document)[0].keys.size(), 1u);
}

TEST(Timeline, ReachesIntoGroupsByPath) {
  nodes::Graph graph = *nodes::addNode({}, "light.sun", {0, 0}, "Sun");
  graph = *nodes::setKey(graph, "Sun", "elevation", 1, 20.0);
  graph = *nodes::setKey(graph, "Sun", "elevation", 24, 70.0);
  std::string group;
  graph = *nodes::groupNodes(graph, {"Sun"}, &group);
  const auto rows = keyRows(graph, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].node, group + "/Sun");
  EXPECT_EQ(rows[0].keys.size(), 2u);
  EXPECT_EQ(keyRows(graph, {group}).size(), 1u) << "also where the group is selected";
  const KeySelection picked = keysAt(rows, 0, 24, 0.5);
  graph = *nodes::moveKeys(graph, movesBy(picked, 6));
  EXPECT_EQ(keyRows(graph, {})[0].keys.back().frame, 30);
  ASSERT_TRUE(nodes::findKey(graph, {group + "/Sun", "elevation", 30}));
  graph = nodes::setInterpolation(graph, group + "/Sun", "elevation", 30, nodes::Interpolation::Constant);
  EXPECT_EQ(nodes::findKey(graph, {group + "/Sun", "elevation", 30})->interpolation,
            nodes::Interpolation::Constant);
  graph = *nodes::setParamAt(graph, group + "/Sun", "elevation", 45.0, 12);
  EXPECT_EQ(keyRows(graph, {})[0].keys.size(), 3u);
  graph = nodes::removeKey(graph, group + "/Sun", "elevation", 1);
  EXPECT_EQ(keyRows(graph, {})[0].keys.size(), 2u);
  EXPECT_FALSE(nodes::setParamAt(graph, group + "/Moon", "elevation", 45.0, 12));
}

TEST(PlayClock, FramesFollowTheTimeAndAreDropped) {
  PlayClock clock;
  clock.start(1, 1, {1, 120}, 24, 100);
  EXPECT_EQ(clock.frameAt(100), 1);
  EXPECT_EQ(clock.frameAt(100 + 1.0 / 24), 2);
  EXPECT_EQ(clock.frameAt(101), 25) << "whatever was drawn meanwhile";
  EXPECT_EQ(clock.frameAt(104.5), 109);
  EXPECT_EQ(clock.frameAt(105), 1) << "120 frames take five seconds, then all begins again";
  EXPECT_NEAR(clock.dueIn(100.01), 1.0 / 24 - 0.01, 1e-9);
}

TEST(PlayClock, BackwardLoopsAtTheStart) {
  PlayClock clock;
  clock.start(3, -1, {1, 10}, 10, 0);
  EXPECT_EQ(clock.frameAt(0.2), 1);
  EXPECT_EQ(clock.frameAt(0.3), 10);
  EXPECT_EQ(clock.frameAt(1.2), 1);
  clock.start(50, 1, {1, 10}, 10, 0);
  EXPECT_EQ(clock.frameAt(0), 10) << "from outside the range: its nearest frame";
}

TEST(PlayClock, SaysHowManyPicturesASecondThereWere) {
  PlayClock clock;
  clock.start(1, 1, {1, 100}, 24, 0);
  for (int i = 1; i <= 20; ++i) clock.shown(0.1 * i);
  EXPECT_EQ(clock.reachedFps(0.5), 24) << "not known yet";
  EXPECT_NEAR(clock.reachedFps(2.0), 10, 1);
  EXPECT_EQ(clock.reachedFps(9), 0);
}

}  // namespace
}  // namespace pileus::editor
