// Content-key evaluation with real CPU types: what runs again, and what each failure says.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <limits>

#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/file/serialize.h"
#include "tests/support/support.h"

namespace pileus::nodes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Graph parsed(const std::string& nodes, const std::string& links) {
  return parseGraph(R"({"pileus": 1, "nodes": {)" + nodes + R"(}, "links": [)" + links + "]}")->graph;
}

Graph chain() {
  return parsed(
      R"("Box": {"type": "volume.box"}, "Ball": {"type": "volume.sphere"}, "Move": {"type": "volume.transform"},
                   "Haze": {"type": "volume.medium"}, "All": {"type": "volume.merge"})",
      R"("Box.volume -> Move.volume", "Move.volume -> Haze.volume", "Haze.volume -> All.volumes", "Ball.volume -> All.volumes")");
}

struct Fixture {
  Evaluator evaluator{nullptr};
  EvalSettings settings;
  EvalReport run(const Graph& graph, const std::string& target = "All") {
    return evaluator.evaluate(graph, {target}, settings);
  }
  std::uint64_t calls(const std::string& node) const { return evaluator.status(node).evaluations; }
  std::uint64_t allCalls(const Graph& graph) const {
    std::uint64_t sum = 0;
    for (const auto& [name, node] : graph.nodes) sum += calls(name);
    return sum;
  }
  std::string error(const std::string& node) const { return evaluator.status(node).error.message; }
  const volume::InstanceList& volumes(const std::string& node) const {
    return std::get<VolumeValue>(*evaluator.output(node, "volume")).items;
  }
};

Graph set(const Graph& graph, const std::string& node, const std::string& param, const ParamValue& value) {
  return setParam(graph, node, param, value).value();
}

TEST(Evaluator, EvaluatesOnceAndThenOnlyWhatChanged) {
  Fixture f;
  Graph graph = chain();
  const EvalReport first = f.run(graph);
  EXPECT_TRUE(first.complete);
  EXPECT_FALSE(first.failed);
  EXPECT_EQ(first.fraction, 1);
  EXPECT_EQ(f.allCalls(graph), 5u);
  for (int i = 0; i < 10; ++i) f.run(graph);
  EXPECT_EQ(f.allCalls(graph), 5u) << "an unchanged graph evaluates nothing";
  f.run(moveNodes(graph, {"Box", "All"}, {100, 0}));
  EXPECT_EQ(f.allCalls(graph), 5u) << "neither does moving nodes";
  graph = set(graph, "Move", "scale", dvec3(2));
  f.run(graph);
  EXPECT_EQ(f.calls("Box") * 10 + f.calls("Ball"), 11u);
  for (const auto name : {"Move", "Haze", "All"}) EXPECT_EQ(f.calls(name), 2u) << name;
  graph = set(graph, "Move", "scale", dvec3(1));
  f.run(graph);
  EXPECT_EQ(f.allCalls(graph), 8u) << "back to an earlier state: still known";
  const Graph renamed = renameNode(graph, "Move", "Shift").value();
  f.run(renamed);
  EXPECT_EQ(f.calls("Shift"), 0u) << "a name is no content";
}

TEST(Evaluator, ComputesWhatTheNodesSay) {
  Fixture f;
  Graph graph = set(set(chain(), "Move", "translate", dvec3(5, 0, 0)), "Haze", "extinction", 3.0);
  graph = set(graph, "Move", "scale", dvec3(-2, 1, 1));
  f.run(graph);
  const auto& items = f.volumes("All");
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[0].shape, volume::Shape::Box);
  EXPECT_EQ(items[0].medium.extinction, 3.0);
  EXPECT_EQ(items[1].medium.extinction, 1.0);
  EXPECT_EQ(items[0].worldFromLocal, composeTransform({5, 0, 0}, {0, 0, 0}, {-2, 1, 1}));
  EXPECT_EQ(items[1].worldFromLocal, composeTransform({0, 0, 0}, {0, 0, 0}, dvec3(0.5)));
  EXPECT_EQ(f.evaluator.input("Haze", "volume"), f.evaluator.output("Move", "volume"));
  EXPECT_EQ(f.evaluator.output("All", "nonsense"), nullptr);
  EXPECT_EQ(f.evaluator.output("Nobody", "volume"), nullptr);
  EXPECT_TRUE(f.evaluator.key("All"));
  EXPECT_FALSE(f.evaluator.key("Nobody"));
}

TEST(Evaluator, SunAndCameraMeanWhatTheyDeclare) {
  Fixture f;
  const Graph graph =
      parsed(R"("Sun": {"type": "light.sun", "params": {"azimuth": 90, "elevation": 0, "irradiance": 4,
      "color": [1, 0.5, 0.25], "use_temperature": true, "angle": 0.53, "disc_samples": 1}},
      "Cam": {"type": "camera.perspective", "params": {"eye": [0, 1, 9], "fov": 25}}, "Bad": {"type": "camera.perspective",
      "params": {"eye": [0, 0, 0]}})",
             "");
  f.evaluator.evaluate(graph, {"Sun", "Cam", "Bad"}, f.settings);
  const auto& sun = std::get<LightValue>(*f.evaluator.output("Sun", "light")).items.at(0).light;
  EXPECT_NEAR(glm::length(sun.towards - dvec3(1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(sun.emitted.x, 4, 1e-3);
  EXPECT_NEAR(sun.emitted.y, 2, 1e-3);
  EXPECT_NEAR(sun.emitted.z, 1, 1e-3);
  EXPECT_EQ(sun.angle, 0.53);
  EXPECT_EQ(*std::get<CameraValue>(*f.evaluator.output("Cam", "camera")).camera,
            (scene::Camera{{0, 1, 9}, {0, 0, 0}, {0, 1, 0}, 25}));
  EXPECT_EQ(f.error("Bad"), "Bad.target: is where the eye is; move one of them");
}

TEST(Evaluator, FailuresNameNodeAndKeyAndSkipWhatFollows) {
  Fixture f;
  const auto failure = [&f](const Graph& graph, const std::string& node) {
    const EvalReport report = f.run(graph);
    EXPECT_TRUE(report.complete);
    EXPECT_TRUE(report.failed);
    EXPECT_EQ(f.evaluator.status(node).state, NodeState::Failed);
    EXPECT_EQ(f.evaluator.status(node).error.code, Code::Input);
    EXPECT_EQ(f.evaluator.output(node, "volume"), nullptr);
    return f.error(node);
  };
  EXPECT_EQ(failure(set(chain(), "Move", "scale", dvec3(1, 0, 1)), "Move"),
            "Move.scale: 0 along Y leaves nothing; use a value other than zero");
  EXPECT_EQ(f.evaluator.status("All").state, NodeState::Skipped);
  EXPECT_EQ(f.error("All"), "All: skipped, because Move failed");
  EXPECT_EQ(f.evaluator.status("Ball").state, NodeState::Ready);

  EXPECT_EQ(failure(removeNodes(chain(), {"Box"}), "Move"), "Move.volume: nothing is linked");
  const auto faulty = [](const std::string& param) {
    return parsed(
        R"("Haze": {"type": "volume.box", "params": {)" + param + R"(}}, "All": {"type": "volume.merge"})",
        R"("Haze.volume -> All.volumes")");
  };
  EXPECT_EQ(failure(faulty(R"("density": -1)"), "Haze"), "Haze.density: -1 is outside 0..1e+06");
  EXPECT_EQ(failure(faulty(R"("density": "thick")"), "Haze"),
            "Haze.density: \"thick\" is not a value this parameter takes");
  EXPECT_TRUE(f.run(faulty(R"("density": {"expr": "1"})")).complete);
  EXPECT_EQ(f.evaluator.status("Haze").state, NodeState::Ready);
  EXPECT_EQ(f.evaluator.status("Haze").warnings.size(), 1u);

  const std::string merge = R"("All": {"type": "volume.merge"})";
  EXPECT_EQ(failure(parsed(R"("X": {"type": "no.such"}, )" + merge, R"("X.volume -> All.volumes")"), "X"),
            "X: unknown node type 'no.such'");
  EXPECT_EQ(failure(parsed(R"("B": {"type": "volume.box"}, )" + merge, R"("B.smoke -> All.volumes")"), "All"),
            "All.volumes: B has no output 'smoke'");
  EXPECT_EQ(failure(parsed(R"("B": {"type": "volume.box"}, )" + merge, R"("B.volume -> All.smoke")"), "All"),
            "All.smoke: there is no such input");
  EXPECT_EQ(failure(parsed(R"("S": {"type": "light.sun"}, )" + merge, R"("S.light -> All.volumes")"), "All"),
            "All.volumes: takes volume, but S.light gives light");
  EXPECT_EQ(
      failure(parsed(R"("V": {"type": "volume.vdb_file"}, )" + merge, R"("V.volume -> All.volumes")"), "V"),
      "V.file: no file chosen");
}

TEST(Evaluator, CyclesFailByNameAndTheRestGoesOn) {
  Fixture f;
  const Graph graph = parsed(
      R"("A": {"type": "volume.merge"}, "B": {"type": "volume.transform"}, "Box": {"type": "volume.box"}, "All": {"type": "volume.merge"},
         "Self": {"type": "volume.transform"})",
      R"("B.volume -> A.volumes", "A.volume -> B.volume", "Box.volume -> A.volumes", "B.volume -> All.volumes", "Self.volume -> Self.volume")");
  EXPECT_TRUE(f.evaluator.evaluate(graph, {"All", "Box", "Self"}, f.settings).complete);
  EXPECT_EQ(f.error("A"), "A: cycle: B -> A -> B");
  EXPECT_EQ(f.error("B"), "B: cycle: B -> A -> B");
  EXPECT_EQ(f.error("Self"), "Self: cycle: Self -> Self");
  EXPECT_EQ(f.error("All"), "All: skipped, because B failed");
  EXPECT_EQ(f.evaluator.status("Box").state, NodeState::Ready);
}

TEST(Evaluator, MutedLinksAreAbsentAndBypassPassesThrough) {
  Fixture f;
  f.run(setMuted(chain(), {"Ball", "volume", "All", "volumes"}, true));
  EXPECT_EQ(f.volumes("All").size(), 1u);
  EXPECT_EQ(f.evaluator.status("Ball").state, NodeState::Idle);
  const Graph graph = set(chain(), "Haze", "extinction", 3.0);
  f.run(setBypass(graph, {"Haze"}, true));
  EXPECT_EQ(f.volumes("Haze").at(0).medium.extinction, 1.0);
  EXPECT_EQ(f.calls("Haze"), 1u);
  const Key bypassed = f.evaluator.key("All");
  Graph direct = removeNodes(graph, {"Haze"}, true);
  f.run(direct);
  EXPECT_EQ(f.evaluator.key("All"), bypassed) << "bypassed is as if it were not there";
  f.run(setBypass(chain(), {"All"}, true));
  EXPECT_EQ(f.volumes("All").size(), 2u) << "a many-input is passed on as one list";
  const EvalReport report = f.run(setBypass(chain(), {"Box"}, true));
  EXPECT_TRUE(report.failed);
  EXPECT_EQ(f.error("Move"), "Move.volume: nothing is linked") << "a bypassed source gives nothing";
}

TEST(Evaluator, OnlyWhatTheTargetsNeedIsEvaluated) {
  Fixture f;
  f.run(chain(), "Move");
  EXPECT_EQ(f.calls("Haze") + f.calls("All") + f.calls("Ball"), 0u);
  f.run(chain(), "Ball");
  EXPECT_EQ(f.evaluator.status("Move").state, NodeState::Idle);
  EXPECT_EQ(f.evaluator.output("Move", "volume"), nullptr);
  EXPECT_NE(f.evaluator.lastGood("Move", "volume"), nullptr);
  EXPECT_TRUE(f.run(chain(), "Nobody").complete);
}

TEST(Evaluator, AnimatedParametersFollowTheFrame) {
  Fixture f;
  const Graph graph = parsed(
      R"("Box": {"type": "volume.box", "params": {"density": {"keys": [[1, 1, "linear"], [3, 3, "linear"]]}}},
      "Ball": {"type": "volume.sphere"}, "All": {"type": "volume.merge"})",
      R"("Box.volume -> All.volumes", "Ball.volume -> All.volumes")");
  f.run(graph);
  f.settings.frame = 2;
  f.run(graph);
  EXPECT_EQ(f.volumes("Box").at(0).density, 2.0);
  EXPECT_EQ(f.calls("Box"), 2u);
  EXPECT_EQ(f.calls("Ball"), 1u) << "the frame concerns only what depends on it";
  f.settings.frame = 3;
  f.run(graph);
  f.settings.frame = 99;
  f.run(graph);
  EXPECT_EQ(f.calls("Box"), 3u) << "the same value is the same content";
}

TEST(Evaluator, AMissingVolumeFileIsAnErrorThatNamesIt) {
  Fixture f;
  f.settings.folder = test::scratchFolder();
  f.settings.budgetMs = kInfinity;
  Graph graph =
      set(addNode({}, "volume.vdb_file", {0, 0}, "V").value(), "V", "file", std::string("none.vdb"));
  EvalReport report;
  for (int i = 0; i < 2000 && !(report = f.run(graph, "V")).complete; ++i) {
    EXPECT_TRUE(report.waitingForJobs);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(report.complete);
  EXPECT_EQ(f.evaluator.status("V").state, NodeState::Failed);
  EXPECT_EQ(f.evaluator.status("V").error.code, Code::Input);
  EXPECT_TRUE(f.error("V").starts_with("V.file: ")) << f.error("V");
  EXPECT_NE(f.error("V").find((f.settings.folder / "none.vdb").string()), std::string::npos) << f.error("V");
  const auto calls = f.calls("V");
  f.run(graph, "V");
  EXPECT_EQ(f.calls("V"), calls) << "a failure is remembered";
  std::ofstream(f.settings.folder / "none.vdb") << "text";
  f.run(graph, "V");
  EXPECT_GT(f.calls("V"), calls) << "until the file changes";
}

TEST(Evaluator, CloudsComeCoarseFirst) {
  Fixture f;
  const Graph graph = set(addNode({}, "volume.cloud", {0, 0}, "Cloud").value(), "Cloud", "resolution", 96);
  std::vector<std::uint64_t> voxels;
  EvalReport report;
  for (int i = 0; i < 60000 && !(report = f.run(graph, "Cloud")).complete; ++i) {
    EXPECT_TRUE(report.waitingForJobs);
    if (f.evaluator.output("Cloud", "volume") && voxels.empty())
      voxels.push_back(f.volumes("Cloud").at(0).grid->activeVoxels);
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  ASSERT_TRUE(report.complete);
  ASSERT_EQ(f.evaluator.status("Cloud").state, NodeState::Ready) << f.error("Cloud");
  ASSERT_EQ(voxels.size(), 1u) << "the coarse cloud was shown";
  EXPECT_GT(f.volumes("Cloud").at(0).grid->activeVoxels, 8 * voxels[0]);
  EXPECT_GT(f.evaluator.status("Cloud").bytes, 0u);
}

}  // namespace
}  // namespace pileus::nodes
