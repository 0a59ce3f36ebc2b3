// The protocol of unfinished values, keys, budgets and the cache, with node types made for the purpose.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <thread>

#include "nodes/declare/describe.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/evaluate/node_inputs.h"
#include "renderer/base/log.h"
#include "tests/support/support.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volume;
  CameraValue camera;
  double value = 1;
};
struct Out {
  VolumeValue volume;
};

/// What the next calls of "t.script" shall do, and what was seen.
struct Script {
  enum Step { Finish, Partial, PartialJob, Pending, PendingGpu, Throw, Fail, FailPassing, Slow };
  std::vector<Step> steps;
  std::size_t at = 0;
  std::uint64_t revision = 0;
  int alive = 0;  ///< state objects
  std::size_t bytes = 0;
} script;

struct State {
  State() { ++script.alive; }
  ~State() { --script.alive; }
  int calls = 0;
};

VolumeValue marked(double density) {
  volume::Instance instance;
  instance.density = density;
  return {{instance}};
}

Result<Out> runScript(const In& in, EvalContext& ctx) {
  const int calls = ++ctx.state<State>().calls;
  const auto step = script.at < script.steps.size() ? script.steps[script.at++] : Script::Finish;
  if (script.bytes) ctx.reportGpu(0, script.bytes);
  switch (step) {
    case Script::Finish:
      break;
    case Script::Partial:
      ctx.partial(0.5, script.revision);
      break;
    case Script::PartialJob:
      ctx.partial(0.5, script.revision, true);
      break;
    case Script::Pending:
      ctx.pending(0.25, "Baking");
      break;
    case Script::PendingGpu:
      ctx.reportGpu(3, 0), ctx.pending(0.25, "Uploading");
      break;
    case Script::Throw:
      throw std::runtime_error("bang");
    case Script::Fail:
      return fail(Code::Gpu, "value: too heavy");
    case Script::FailPassing:
      return Error{Code::Input, "value: took too long", true};
    case Script::Slow:
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      ctx.partial(0.1, script.revision);
      break;
  }
  return Out{marked(in.value + 100 * calls)};
}

Result<Out> pass(const In& in, EvalContext&) { return Out{in.volume}; }

/// What "t.reads" and the like ask of the context; with `Bits` they declare what they ask for.
Result<Out> readAll(const In& in, EvalContext& ctx) {
  double all = ctx.frame() + ctx.fps() + ctx.size().x + ctx.draftPixels() + ctx.draftTexels();
  all += ctx.quality() == Quality::Draft ? 1 : 0;
  all += ctx.freeCamera() ? ctx.freeCamera()->fov : 0;
  all += ctx.layer().light + (ctx.extra().depth ? 1 : 0) + ctx.region().max.x + (ctx.seed() ? 1 : 0);
  all += double(ctx.ocio().size());
  return Out{marked(in.value + all)};
}
Result<Out> readFrame(const In& in, EvalContext& ctx) { return Out{marked(in.value + ctx.frame())}; }

/// Grids that are alive, and the most there were at once.
int grids = 0, mostGrids = 0;

/// A grid of a MiB for each frame.
Result<Out> makeGrid(const In& in, EvalContext& ctx) {
  auto* grid = new volume::BrickGrid;
  grid->payloadCount = (1u << 20) / volume::kStoredVoxels + 1;
  mostGrids = std::max(mostGrids, ++grids);
  Out out{marked(in.value + ctx.frame())};
  out.volume.items[0].grid = volume::GridPtr(grid, [](const volume::BrickGrid* g) { --grids, delete g; });
  return out;
}

struct NumberOut {
  double number = 0;
};
Result<NumberOut> makeNumber(const In&, EvalContext& ctx) { return NumberOut{ctx.frame() < 100 ? 7.0 : 8.0}; }

void describeIt(Describe<In, Out>& d) {
  d.in("volume", &In::volume).many();
  d.in("camera", &In::camera);
  d.in("value", &In::value).range(-1e6, 1e6);
  d.out("volume", &Out::volume);
}
template <unsigned Bits>
void describeUses(Describe<In, Out>& d) {
  describeIt(d);
  d.uses(Bits);
}

struct CameraOut {
  CameraValue camera;
};
struct NoIn {};
Result<CameraOut> makeCamera(const NoIn&, EvalContext&) {
  return CameraOut{{std::make_shared<const scene::Camera>()}};
}

const NodeType* lookup(std::string_view id) {
  static const std::vector<NodeType> types = {
      makeNode<In, Out>("t.script", 1, describeIt, runScript),
      makeNode<In, Out>("t.pass", 1, describeIt, pass),
      makeNode<In, Out>("t.frame", 1, describeUses<UsesFrame>, pass),
      makeNode<In, Out>("t.grid", 1, describeUses<UsesFrame>, makeGrid),
      makeNode<In, NumberOut>(
          "t.number", 1,
          [](Describe<In, NumberOut>& d) {
            d.uses(UsesFrame);
            d.out("number", &NumberOut::number);
          },
          makeNumber),
      makeNode<In, Out>("t.size", 1, describeUses<UsesSize>, pass),
      makeNode<In, Out>("t.quality", 1, describeUses<UsesQuality>, pass),
      makeNode<In, Out>("t.free", 1, describeUses<UsesFreeCamera>, pass),
      makeNode<In, Out>("t.reads", 1,
                        describeUses<UsesFrame | UsesRate | UsesSize | UsesQuality | UsesFreeCamera |
                                     UsesLayers | UsesColors>,
                        readAll),
      makeNode<In, Out>("t.reads_none", 1, describeIt, readAll),
      makeNode<In, Out>("t.reads_frame", 1, describeUses<UsesSize>, readFrame),
      makeNode<NoIn, CameraOut>(
          "t.camera", 1, [](Describe<NoIn, CameraOut>& d) { d.out("camera", &CameraOut::camera); },
          makeCamera)};
  for (const NodeType& type : types)
    if (type.id == id) return &type;
  return nullptr;
}

class Progressive : public testing::Test {
 protected:
  Progressive() {
    script = {};
    add("S", "t.script");
    add("P", "t.pass");
    graph.links.push_back({"S", "volume", "P", "volume"});
  }
  void add(const std::string& name, const std::string& type) {
    Node node;
    node.type = type;
    graph.nodes[name] = std::make_shared<const Node>(node);
  }
  void value(double v) {
    Node node = *graph.nodes["S"];
    node.params["value"] = v;
    graph.nodes["S"] = std::make_shared<const Node>(node);
  }
  EvalReport run() { return evaluator.evaluate(graph, {"P"}, settings); }
  NodeState state(const std::string& node) const { return evaluator.status(node).state; }
  double density(const SocketValue* v) const {
    return v ? std::get<VolumeValue>(*v).items.at(0).density : -1;
  }
  double shown() const { return density(evaluator.output("P", "volume")); }
  std::uint64_t calls(const std::string& node) const { return evaluator.status(node).evaluations; }

  Graph graph;
  EvalSettings settings;
  Evaluator evaluator{nullptr, lookup};
};

TEST_F(Progressive, PartialValuesFlowOnAndTheStateIsKeptUntilDone) {
  script.steps = {Script::Partial, Script::Partial};
  EvalReport report = run();
  EXPECT_FALSE(report.complete);
  EXPECT_FALSE(report.waitingForJobs);
  EXPECT_EQ(state("S"), NodeState::Partial);
  EXPECT_EQ(state("P"), NodeState::Partial) << "finished, but on a value that still improves";
  EXPECT_EQ(shown(), 101);
  run();
  EXPECT_EQ(shown(), 101) << "the same revision: downstream does not run again";
  EXPECT_EQ(density(evaluator.output("S", "volume")), 201) << "one state object through all calls";
  EXPECT_EQ(calls("P"), 1u);
  EXPECT_EQ(script.alive, 1);
  report = run();
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(state("S"), NodeState::Ready);
  EXPECT_EQ(state("P"), NodeState::Ready);
  EXPECT_EQ(shown(), 301);
  EXPECT_EQ(script.alive, 0) << "dropped when complete";
  run();
  EXPECT_EQ(calls("S"), 3u);
  EXPECT_EQ(calls("P"), 2u);
}

TEST_F(Progressive, ANewRevisionRunsDownstreamAgain) {
  script.steps = {Script::Partial, Script::Partial, Script::Partial};
  run();
  script.revision = 1;
  run();
  EXPECT_EQ(shown(), 201);
  run();
  EXPECT_EQ(calls("P"), 2u);
}

TEST_F(Progressive, WhilePendingDownstreamWaitsAndTheLastGoodValueStays) {
  run();
  EXPECT_EQ(shown(), 101);
  value(2);
  script = {.steps = {Script::Pending, Script::Pending}};
  const EvalReport report = run();
  EXPECT_FALSE(report.complete);
  EXPECT_TRUE(report.waitingForJobs);
  EXPECT_EQ(state("S"), NodeState::Pending);
  EXPECT_EQ(evaluator.status("S").what, "Baking");
  EXPECT_EQ(state("P"), NodeState::Pending);
  EXPECT_EQ(evaluator.status("P").what, "Waiting for S");
  EXPECT_EQ(evaluator.output("P", "volume"), nullptr);
  EXPECT_FALSE(evaluator.key("P"));
  EXPECT_EQ(density(evaluator.lastGood("P", "volume")), 101);
  EXPECT_EQ(density(evaluator.lastGoodInput("P", "volume")), 101);
  run();
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(shown(), 302);
  EXPECT_EQ(density(evaluator.lastGood("P", "volume")), 302);
}

TEST_F(Progressive, WaitingIsToldFromWorking) {
  script.steps = {Script::PendingGpu, Script::PartialJob, Script::Partial};
  EXPECT_FALSE(run().waitingForJobs) << "a pending node that used the GPU goes on at once";
  EXPECT_TRUE(run().waitingForJobs) << "a partial value whose job goes on elsewhere";
  EXPECT_FALSE(run().waitingForJobs);
}

TEST_F(Progressive, AnInfiniteBudgetWaitsForFinalValues) {
  settings.budgetMs = std::numeric_limits<double>::infinity();
  script.steps = {Script::PartialJob};
  EXPECT_FALSE(run().complete);
  EXPECT_EQ(state("P"), NodeState::Pending);
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(calls("P"), 1u) << "nothing was rendered on the coarse value";
}

TEST_F(Progressive, TheBudgetEndsACallButOneStepIsAlwaysDone) {
  add("S2", "t.script");
  Node node = *graph.nodes["S2"];
  node.params["value"] = 7.0;
  graph.nodes["S2"] = std::make_shared<const Node>(node);
  graph.links.push_back({"S2", "volume", "P", "volume"});
  settings.budgetMs = 0;
  script.steps = {Script::Slow, Script::Finish, Script::Finish};
  EXPECT_FALSE(run().complete);
  EXPECT_EQ(calls("S") + calls("S2"), 1u);
  EXPECT_FALSE(run().complete);
  EXPECT_EQ(calls("S") + calls("S2"), 2u);
  EXPECT_FALSE(run().complete);
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(calls("P"), 1u);
}

TEST_F(Progressive, StatesNobodyWantsAreDroppedAfterThreeCalls) {
  script.steps = {Script::Pending, Script::Pending, Script::Pending,
                  Script::Pending, Script::Pending, Script::Pending};
  run();
  value(2);
  run();
  EXPECT_EQ(script.alive, 2) << "Draft and Final take turns";
  value(1);
  run();
  EXPECT_EQ(calls("S"), 3u);
  EXPECT_EQ(script.alive, 2);
  for (int i = 0; i < 3; ++i) run();
  EXPECT_EQ(script.alive, 1) << "the other one's job is cancelled";
  evaluator.clear();
  EXPECT_EQ(script.alive, 0);
}

TEST_F(Progressive, ExceptionsAndErrorsBecomeFailures) {
  script.steps = {Script::Throw, Script::Fail};
  EXPECT_TRUE(run().failed);
  EXPECT_EQ(evaluator.status("S").error.code, Code::Internal);
  EXPECT_EQ(evaluator.status("S").error.message, "S: internal error: bang");
  EXPECT_EQ(state("P"), NodeState::Skipped);
  run();
  EXPECT_EQ(calls("S"), 1u) << "a failure is not tried again";
  value(2);
  run();
  EXPECT_EQ(evaluator.status("S").error.code, Code::Gpu);
  EXPECT_EQ(evaluator.status("S").error.message, "S.value: too heavy");
}

TEST_F(Progressive, WhatWasOnlyOfTheMomentIsTriedAgain) {
  script.steps = {Script::FailPassing, Script::Finish};
  EXPECT_TRUE(run().failed);
  EXPECT_EQ(evaluator.status("S").error.message, "S.value: took too long");
  EXPECT_FALSE(run().failed) << "the next request asks anew";
  EXPECT_EQ(calls("S"), 2u);
}

TEST_F(Progressive, OldResultsAreDroppedBeyondTheLimit) {
  script.bytes = std::size_t(10) << 20;
  evaluator.setCacheLimit(std::size_t(35) << 20);
  for (int i = 0; i < 10; ++i) value(i), run();
  const auto before = calls("S");
  value(8), run();
  EXPECT_EQ(calls("S"), before) << "used in the last four calls";
  value(0), run();
  EXPECT_EQ(calls("S"), before + 1) << "long unused";
  evaluator.setCacheLimit(0);
  for (int i = 0; i < 6; ++i) run();
  EXPECT_EQ(calls("S"), before + 1) << "what is in use stays, whatever the limit";
}

TEST_F(Progressive, ErrorsOfMemoryAreTriedAgainAtTheNextRequestAndNotBefore) {
  add("S2", "t.script");
  Node other = *graph.nodes["S2"];
  other.params["value"] = 7.0;
  graph.nodes["S2"] = std::make_shared<const Node>(other);
  graph.links.push_back({"S2", "volume", "P", "volume"});
  script.steps = {Script::Fail, Script::Pending, Script::Pending};
  EXPECT_FALSE(run().complete);
  EXPECT_EQ(state("S"), NodeState::Failed);
  EXPECT_FALSE(run().complete);
  EXPECT_EQ(calls("S"), 1u) << "the same request: S2 still waits for its job";
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(state("P"), NodeState::Skipped);
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(calls("S"), 2u);
  EXPECT_EQ(state("P"), NodeState::Ready) << "there is memory now";
  EXPECT_EQ(calls("S2"), 3u);
}

TEST_F(Progressive, WhatNobodyWaitsForIsCancelledOnceARequestIsAnswered) {
  script.steps = {Script::Pending, Script::Finish};
  EXPECT_FALSE(run().complete);
  EXPECT_EQ(script.alive, 1);
  value(2);
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(script.alive, 0) << "no further call may come: nothing moves";
}

TEST_F(Progressive, DraftsGoAsSoonAsTheyAreUnwanted) {
  add("Q", "t.quality");
  add("End", "t.pass");
  graph.links.push_back({"P", "volume", "Q", "volume"});
  graph.links.push_back({"Q", "volume", "End", "volume"});
  const auto ask = [&](double v, Quality quality) {
    value(v);
    settings.quality = quality;
    evaluator.evaluate(graph, {"End"}, settings);
    return std::array{calls("S"), calls("Q"), calls("End")};
  };
  using Calls = std::array<std::uint64_t, 3>;
  EXPECT_EQ(ask(1, Quality::Draft), (Calls{1, 1, 1}));
  EXPECT_EQ(ask(2, Quality::Draft), (Calls{2, 2, 2}));
  EXPECT_EQ(ask(1, Quality::Draft), (Calls{2, 3, 3})) << "what is the same in a draft is kept";
  EXPECT_EQ(ask(1, Quality::Final), (Calls{2, 4, 4}));
  EXPECT_EQ(ask(2, Quality::Final), (Calls{2, 5, 5}));
  EXPECT_EQ(ask(1, Quality::Draft), (Calls{2, 5, 5})) << "and what was final";
}

TEST_F(Progressive, OfASequenceOneFrameIsKept) {
  add("Grid", "t.grid");
  add("Number", "t.number");
  add("Numbered", "t.script");
  graph.links.push_back({"Grid", "volume", "P", "volume"});
  graph.links.push_back({"Number", "number", "Numbered", "value"});
  graph.links.push_back({"Numbered", "volume", "P", "volume"});
  evaluator.setCacheLimit(0);
  mostGrids = grids;
  for (settings.frame = 1; settings.frame <= 5; ++settings.frame) EXPECT_TRUE(run().complete);
  EXPECT_EQ(mostGrids, 1) << "a frame goes before the next is made";
  EXPECT_EQ(calls("Grid"), 5u);
  EXPECT_EQ(calls("S"), 1u) << "what is the same in all frames stays";
  EXPECT_EQ(calls("Numbered"), 1u) << "also where a number that is worked out anew comes to the same";
  settings.frame = 100;
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(calls("Numbered"), 2u);
  evaluator.clear();
  EXPECT_EQ(grids, 0);
}

TEST_F(Progressive, WhatResultsShareIsCountedOnce) {
  add("Grid", "t.grid");
  graph.links.push_back({"Grid", "volume", "P", "volume"});
  run();
  const std::size_t one = evaluator.keptBytes();
  EXPECT_NEAR(double(one), 1 << 20, volume::kStoredVoxels) << "two results hold one grid";
  evaluator.setCacheLimit(one * 3);
  for (settings.frame = 2; settings.frame <= 60; ++settings.frame) {
    run();
    EXPECT_LE(evaluator.keptBytes(), one * 3) << settings.frame;
  }
  EXPECT_EQ(grids, 3);
  evaluator.clear();
  EXPECT_EQ(evaluator.keptBytes(), 0u);
  EXPECT_EQ(grids, 0);
}

TEST_F(Progressive, AnotherDocumentsNamesMeanOtherNodes) {
  run();
  value(2);
  script = {.steps = {Script::Pending}};
  evaluator.forgetNames();
  run();
  EXPECT_EQ(evaluator.lastGood("P", "volume"), nullptr) << "of a node of that name in the document before";
}

TEST(ContentKey, OfARegionHoldsWhatStandsAroundIt) {
  const NodeType& type = *findNodeType("render.volume");
  NodeInputs in;
  in.links.resize(type.inputs.size());
  in.keys.resize(type.inputs.size());
  EvalSettings settings, other;
  other.around = Hasher().add("another picture").key();
  EXPECT_EQ(contentKey(type, in, settings), contentKey(type, in, other)) << "nothing is around the whole";
  settings.region.max = other.region.max = dvec2(0.5);
  EXPECT_NE(contentKey(type, in, settings), contentKey(type, in, other));
}

TEST_F(Progressive, EqualNodesShareOneResult) {
  add("S2", "t.script");
  graph.links.push_back({"S2", "volume", "P", "volume"});
  run();
  EXPECT_EQ(calls("S") + calls("S2"), 1u);
}

TEST_F(Progressive, KeysHoldOnlyWhatATypeUses) {
  for (const std::string kind : {"frame", "size", "quality", "free"}) add(kind, "t." + kind);
  add("plain", "t.pass");
  const std::vector<std::string> all = {"frame", "size", "quality", "free", "plain"};
  const auto changedBy = [&](auto change) {
    evaluator.evaluate(graph, all, settings);
    std::map<std::string, Key> before;
    for (const auto& name : all) before[name] = evaluator.key(name);
    change();
    evaluator.evaluate(graph, all, settings);
    std::string changed;
    for (const auto& name : all)
      if (evaluator.key(name) != before[name]) changed += name + " ";
    return changed;
  };
  EXPECT_EQ(changedBy([&] { settings.frame = 2; }), "frame ");
  EXPECT_EQ(changedBy([&] { settings.size = {10, 10}; }), "size ");
  EXPECT_EQ(changedBy([&] { settings.quality = Quality::Draft; }), "")
      << "what is there in full serves a draft";
  EXPECT_EQ(changedBy([&] { evaluator.clear(); }), "quality ");
  EXPECT_EQ(changedBy([&] { settings.freeCamera = scene::Camera{}; }), "free ");
  EXPECT_EQ(changedBy([&] { settings.freeCamera->fov = 20; }), "free ");
  EXPECT_EQ(changedBy([&] { settings.budgetMs = 1; }), "");
  add("camera", "t.camera");
  graph.links.push_back({"camera", "camera", "free", "camera"});
  EXPECT_EQ(changedBy([&] { settings.freeCamera->fov = 30; }), "") << "a linked camera replaces the free one";
}

TEST_F(Progressive, WhatATypeDoesNotDeclareItMayNotRead) {
  add("all", "t.reads"), add("none", "t.reads_none"), add("frame", "t.reads_frame");
  const auto logged = [&](const std::string& node) {
    const auto before = log::count(log::Level::Error);
    evaluator.evaluate(graph, {node}, settings);
    return log::count(log::Level::Error) > before ? log::history().back().text : "";
  };
  EXPECT_EQ(logged("all"), "");
  const test::ExpectLogged expected;
  EXPECT_EQ(logged("none"),
            "none: internal error: t.reads_none reads parts of the context that it does not declare: frame, "
            "size, quality, freeCamera, layers, rate, colors");
  EXPECT_EQ(
      logged("frame"),
      "frame: internal error: t.reads_frame reads parts of the context that it does not declare: frame");
  EXPECT_EQ(state("frame"), NodeState::Ready) << "the result is kept all the same";
}

TEST_F(Progressive, TheOrderOfLinksIsContent) {
  add("S2", "t.script");
  Node node = *graph.nodes["S2"];
  node.params["value"] = 7.0;
  graph.nodes["S2"] = std::make_shared<const Node>(node);
  graph.links.push_back({"S2", "volume", "P", "volume"});
  run();
  const Key key = evaluator.key("P");
  std::swap(graph.links[0], graph.links[1]);
  run();
  EXPECT_NE(evaluator.key("P"), key);
  EXPECT_EQ(shown(), 107);
}

}  // namespace
}  // namespace pileus::nodes
