// Groups: making, entering, saving and evaluating them; values linked to parameters.
#include <gtest/gtest.h>

#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/evaluate/flatten.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/document.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_groups.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

Graph parsed(const std::string& nodes, const std::string& links) {
  return parseGraph(R"({"pileus": 1, "nodes": {)" + nodes + R"(}, "links": [)" + links + "]}")->graph;
}

Graph chain() {
  return parsed(
      R"("Box": {"type": "volume.box"}, "Ball": {"type": "volume.sphere"}, "Move": {"type": "volume.transform", "params": {"translate": [5, 0, 0]}},
         "Haze": {"type": "volume.medium", "params": {"extinction": 3}}, "All": {"type": "volume.merge"})",
      R"("Box.volume -> Move.volume", "Move.volume -> Haze.volume", "Haze.volume -> All.volumes", "Ball.volume -> All.volumes")");
}

struct Fixture {
  Evaluator evaluator{nullptr};
  EvalSettings settings;
  EvalReport run(const Graph& graph, const std::string& target = "All") {
    return evaluator.evaluate(graph, {target}, settings);
  }
  std::string error(const std::string& node) const { return evaluator.status(node).error.message; }
  const volume::InstanceList& volumes(const std::string& node, const char* socket = "volume") const {
    return std::get<VolumeValue>(*evaluator.output(node, socket)).items;
  }
};

TEST(Groups, KeepConnectionsAndComeApartAgain) {
  std::string name;
  const Graph graph = groupNodes(chain(), {"Move", "Haze"}, &name).value();
  EXPECT_EQ(name, "Group");
  ASSERT_EQ(inputsOf(graph, "Group").size(), 1u);
  EXPECT_EQ(inputsOf(graph, "Group")[0].type, SocketType::Volume);
  EXPECT_FALSE(inputsOf(graph, "Group")[0].any);
  EXPECT_EQ(outputsOf(graph, "Group").at(0).type, SocketType::Volume);
  EXPECT_EQ(graph.links[1].fromNode, "Group") << "in the old link's place";
  std::set<std::string> names;
  const Graph apart = ungroup(graph, "Group", &names).value();
  EXPECT_EQ(names, (std::set<std::string>{"Move", "Haze"}));
  const auto sorted = [](std::vector<Link> links) { return std::sort(links.begin(), links.end()), links; };
  EXPECT_EQ(sorted(apart.links), sorted(chain().links));
  EXPECT_EQ(groupNodes(chain(), {"Box", "Haze"}).error().message,
            "Move lies between these nodes: group it with them");
  EXPECT_TRUE(linkRefusal(graph, {"All", "volume", "Group", inputsOf(graph, "Group")[0].id})
                  ->starts_with("this would be a cycle"));
}

TEST(Groups, EvaluateAsTheirContent) {
  Fixture plain, grouped;
  plain.run(chain());
  Graph graph = groupNodes(chain(), {"Move", "Haze"}).value();
  graph = groupNodes(graph, {"Group", "Ball"}).value();  // a group in a group
  EXPECT_TRUE(grouped.run(graph).complete);
  EXPECT_EQ(grouped.evaluator.key("All"), plain.evaluator.key("All")) << "grouping changes no content";
  ASSERT_EQ(grouped.volumes("All").size(), 2u);
  EXPECT_EQ(grouped.volumes("All")[0].medium.extinction, 3.0);
  EXPECT_EQ(grouped.evaluator.status("Group 2/Group/Haze").state, NodeState::Ready);
  EXPECT_EQ(grouped.evaluator.status("Group 2").state, NodeState::Ready);
  EXPECT_EQ(grouped.evaluator.status("Group 2").evaluations, 3u);
  EXPECT_EQ(grouped.volumes("Group 2", outputsOf(graph, "Group 2")[0].id.c_str()).size(), 1u);
  EXPECT_TRUE(grouped.evaluator.evaluate(graph, {"Group 2"}, grouped.settings).complete);
  const Graph bypassed = setBypass(graph, {"Group 2"}, true);
  grouped.run(bypassed);
  EXPECT_EQ(grouped.error("All"), "");
  EXPECT_EQ(grouped.volumes("All").size(), 1u) << "the box alone";
}

TEST(Groups, SayWhatIsWrongInside) {
  Graph graph = groupNodes(chain(), {"Move", "Haze"}).value();
  const std::vector<std::string> scope{"Group"};
  Graph inner = *graphAt(graph, scope);
  inner = setParam(inner, "Move", "scale", dvec3(0)).value();
  graph = withGraphAt(graph, scope, inner).value();
  Fixture f;
  EXPECT_TRUE(f.run(graph).failed);
  EXPECT_EQ(f.error("Group/Move"), "Group/Move.scale: 0 along X leaves nothing; use a value other than zero");
  EXPECT_EQ(f.error("Group"), f.error("Group/Move"));
  EXPECT_EQ(f.evaluator.status("All").state, NodeState::Skipped);
  const auto faults =
      parseGraph(
          R"({"pileus": 1, "nodes": {"G": {"type": "group", "graph": {"nodes": {"S": {"type": "light.sun", "params": {"elevation": 99}}}, "links": ["S.light -> X.y"]}}}})")
          ->faults;
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faultText(faults[0]), "error: G/S.elevation: 99 is outside -90..90");
  EXPECT_EQ(faultText(faults[1]), "error: G/links[0]: \"S.light -> X.y\": there is no node 'X'");
  EXPECT_EQ(faultText(parseGraph(R"({"pileus": 1, "nodes": {"G": {"type": "group"}}})")->faults.at(0)),
            "error: G.graph: is missing");
}

TEST(Groups, NestToALimit) {
  Document document(addNode({}, "volume.box", {0, 0}, "Box").value());
  bool refused = false;
  for (std::size_t i = 0; i < kDeepestGroup + 3; ++i) {
    std::set<std::string> all;
    for (const auto& [name, node] : document.graph().nodes) all.insert(name);
    const auto grouped = groupNodes(document.graph(), all);
    refused = !grouped || !document.edit(*grouped, "Group");
    if (refused) break;
  }
  EXPECT_TRUE(refused);
  EXPECT_EQ(groupDepth(document.root()), kDeepestGroup);
  const std::string text = graphText(document.root());
  const auto loaded = parseGraph(text);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(graphText(loaded->graph), text);
  EXPECT_TRUE(flatten(document.root()).faults.empty());
}

TEST(Groups, SurviveFilesAndTheClipboard) {
  const Graph graph = groupNodes(chain(), {"Move", "Haze"}).value();
  const auto loaded = parseGraph(graphText(graph));
  EXPECT_TRUE(loaded->faults.empty());
  EXPECT_TRUE(loaded->graph == graph);
  std::set<std::string> pasted;
  const Graph twice = pasteText(graph, copyText(graph, {"Group", "All"}), {0, 0}, &pasted).value();
  EXPECT_EQ(pasted, (std::set<std::string>{"Group 2", "All 2"}));
  EXPECT_TRUE(*groupGraph(twice, "Group 2") == *groupGraph(graph, "Group"));
  EXPECT_EQ(twice.links.size(), graph.links.size() + 1);
}

TEST(Scope, EditsGoToTheRootAndUndoReturns) {
  Document document(groupNodes(chain(), {"Move", "Haze"}).value());
  const Graph first = document.root();
  EXPECT_FALSE(document.enter("All"));
  ASSERT_TRUE(document.enter("Group"));
  EXPECT_EQ(document.scopedName("Move"), "Group/Move");
  EXPECT_TRUE(document.graph().nodes.contains("Move"));
  const auto revision = document.revision();
  document.edit(setParam(document.graph(), "Haze", "extinction", 7.0).value(), "Set");
  EXPECT_GT(document.revision(), revision);
  EXPECT_EQ(findNode(*groupGraph(document.root(), "Group"), "Haze")->params.at("extinction"),
            ParamValue(7.0));
  Graph resized = document.graph();
  resized.settings.size = {10, 20};
  document.edit(resized, "Size");
  EXPECT_EQ(document.root().settings.size, ivec2(10, 20)) << "settings are the document's";
  const std::string input = groupInputs(document.graph()).at(0);
  document.edit(renameNode(document.graph(), input, "Smoke").value(), "Rename");
  EXPECT_EQ(document.root().links[0].toSocket, "Smoke") << "links outside follow";
  document.edit(removeNodes(document.graph(), {"Smoke"}), "Remove");
  EXPECT_EQ(document.root().links.size(), 2u) << "and go with the socket";
  document.leave();
  EXPECT_EQ(document.selection(), (std::set<std::string>{"Group"}));
  document.undo();
  EXPECT_EQ(document.scope(), std::vector<std::string>{"Group"}) << "back where the step was made";
  while (document.canUndo()) document.undo();
  EXPECT_TRUE(document.root() == first);
  EXPECT_FALSE(document.dirty());
  document.editRoot(removeNodes(document.root(), {"Group"}), "Remove group");
  EXPECT_TRUE(document.scope().empty()) << "a scope that is gone is left";
}

TEST(LinkedParams, WinOverTheConstantAndAreChecked) {
  Fixture f;
  Graph graph = parsed(
      R"("N": {"type": "value.number", "params": {"value": 4}}, "Haze": {"type": "volume.medium", "params": {"extinction": 3}},
      "Box": {"type": "volume.box"}, "Sum": {"type": "value.math", "params": {"operation": "divide", "a": 1}}, "All": {"type": "volume.merge"})",
      R"("Box.volume -> Haze.volume", "Haze.volume -> All.volumes")");
  graph = connect(graph, {"N", "value", "Haze", "extinction"}).value();
  f.run(graph);
  EXPECT_EQ(f.volumes("All").at(0).medium.extinction, 4.0);
  f.run(setMuted(graph, {"N", "value", "Haze", "extinction"}, true));
  EXPECT_EQ(f.volumes("All").at(0).medium.extinction, 3.0) << "constants return";
  f.run(disableNodes(graph, {"N"}, true));
  EXPECT_EQ(f.volumes("All").at(0).medium.extinction, 3.0);
  f.run(setParam(graph, "N", "value", -4.0).value());
  EXPECT_TRUE(f.error("Haze").starts_with("Haze.extinction: -4 is outside 0..")) << f.error("Haze");
  EXPECT_TRUE(f.error("Haze").ends_with("(from N.value)")) << f.error("Haze");
  // A number as a colour, through a dot and a calculation that divides by zero.
  graph = connect(graph, {"Sum", "value", "Haze", "albedo"}).value();
  graph = addDot(graph, {"Sum", "value", "Haze", "albedo"}, {0, 0}).value();
  f.run(graph);
  EXPECT_EQ(f.error("Haze"), "");
  graph = setParam(graph, "Sum", "b", 0.0).value();
  f.run(graph);
  EXPECT_EQ(std::get<double>(*f.evaluator.output("Sum", "value")), 0.0);
  EXPECT_EQ(f.evaluator.status("Dot").state, NodeState::Ready);
}

TEST(LinkedParams, FollowTheFrame) {
  Fixture f;
  Graph graph = parsed(
      R"("F": {"type": "value.frame"}, "Haze": {"type": "volume.medium"}, "Box": {"type": "volume.box"}, "All": {"type": "volume.merge"})",
      R"("Box.volume -> Haze.volume", "Haze.volume -> All.volumes", "F.seconds -> Haze.extinction")");
  EXPECT_TRUE(isSocket(*findNode(graph, "Haze"), *findNodeType("volume.medium")->param("extinction")))
      << "a file's link exposes";
  f.settings.frame = 48;
  f.run(graph);
  EXPECT_EQ(f.volumes("All").at(0).medium.extinction, 2.0);
  graph.settings.fps = 48;
  f.run(graph);
  EXPECT_EQ(f.volumes("All").at(0).medium.extinction, 1.0);
}

TEST(LinkedParams, ComeIntoGroups) {
  Fixture f;
  Graph graph = parsed(
      R"("N": {"type": "value.number", "params": {"value": 4}}, "Haze": {"type": "volume.medium"}, "Box": {"type": "volume.box"}, "All": {"type": "volume.merge"})",
      R"("Box.volume -> Haze.volume", "Haze.volume -> All.volumes", "N.value -> Haze.extinction")");
  graph = groupNodes(graph, {"Haze", "Box"}).value();
  ASSERT_EQ(inputsOf(graph, "Group").size(), 1u);
  EXPECT_EQ(inputsOf(graph, "Group")[0].type, SocketType::Number);
  f.run(graph);
  EXPECT_EQ(f.volumes("All").at(0).medium.extinction, 4.0);
}

TEST(Disabled, NodesAreAsIfTheyWereNotThere) {
  Fixture f;
  const Graph graph = disableNodes(chain(), {"Ball"}, true);
  f.run(graph);
  EXPECT_EQ(f.volumes("All").size(), 1u);
  EXPECT_EQ(f.evaluator.status("Ball").state, NodeState::Idle);
  f.run(disableNodes(chain(), {"Move"}, true));
  EXPECT_EQ(f.error("Haze"), "Haze.volume: nothing is linked");
  EXPECT_TRUE(parseGraph(graphText(graph))->graph == graph);
}

TEST(Groups, SourcesAreFoundThroughThemAndThroughDots) {
  const Graph graph = parsed(
      R"("Eye": {"type": "camera.perspective"}, "Dot": {"type": "dot"}, "Sun": {"type": "light.sun"},
         "View": {"type": "output.view"},
         "Shot": {"type": "group", "graph": {
           "nodes": {
             "camera": {"type": "group.input", "at": [0, 0]}, "light": {"type": "group.input", "at": [0, 100]},
             "Rig": {"type": "group", "graph": {
               "nodes": { "Box": {"type": "volume.box"}, "volume": {"type": "group.output"} },
               "links": ["Box.volume -> volume.in"] }},
             "Render": {"type": "render.volume"}, "image": {"type": "group.output"} },
           "links": ["camera.out -> Render.camera", "light.out -> Render.lights", "Rig.volume -> Render.volumes",
                     "Render.image -> image.in"] }})",
      R"("Eye.camera -> Dot.in", "Dot.out -> Shot.camera", "Sun.light -> Shot.light", "Shot.image -> View.image")");
  ASSERT_EQ(graph.links.size(), 4u);
  using Sources = std::vector<SocketAt>;
  EXPECT_EQ(sourcesOf(graph, "View", "image"), (Sources{{"Shot/Render", "image"}}));
  EXPECT_EQ(sourcesOf(graph, "Shot/Render", "camera"), (Sources{{"Eye", "camera"}}));
  EXPECT_EQ(sourcesOf(graph, "Shot/Render", "volumes"), (Sources{{"Shot/Rig/Box", "volume"}}));
  EXPECT_EQ(sourcesOf(graph, "Shot/Render", "").size(), 3u) << "an empty input means any";
  EXPECT_TRUE(sourcesOf(graph, "Shot/Render", "solids").empty());
  EXPECT_TRUE(sourcesOf(graph, "Nobody/Render", "camera").empty());
  // The same as what is evaluated has it.
  const FlatGraph flat = flatten(graph);
  EXPECT_NE(findNode(flat.graph, "Shot/Rig/Box"), nullptr);

  const Graph without = unlinked(graph, "Shot/Render", "camera").value();
  EXPECT_TRUE(sourcesOf(without, "Shot/Render", "camera").empty());
  EXPECT_EQ(sourcesOf(without, "Shot/Render", "lights").size(), 1u) << "the others stay";
  EXPECT_FALSE(unlinked(graph, "Nobody/Render", "camera"));
  Graph muted = graph;
  for (Link& link : muted.links) link.muted = link.fromNode == "Dot";
  EXPECT_TRUE(sourcesOf(muted, "Shot/Render", "camera").empty());
}

}  // namespace
}  // namespace pileus::nodes
