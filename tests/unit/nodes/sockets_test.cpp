// Sockets of every kind of node, and the edits of links, selections, frames and keys.
#include <gtest/gtest.h>

#include "nodes/file/serialize.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_frames.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

Graph with(const std::vector<std::pair<std::string, std::string>>& nodes,
           const std::vector<Link>& links = {}) {
  Graph graph;
  for (const auto& [name, type] : nodes) graph = addNode(graph, type, {0, 0}, name).value();
  for (const Link& link : links) graph = connect(graph, link).value();
  return graph;
}

std::vector<std::string> linksOf(const Graph& graph) {
  std::vector<std::string> all;
  for (const Link& l : graph.links)
    all.push_back((l.muted ? "(" : "") + l.fromNode + "." + l.fromSocket + " > " + l.toNode + "." +
                  l.toSocket);
  return all;
}
using Names = std::vector<std::string>;

Graph merged() {
  return with(
      {{"A", "volume.box"},
       {"B", "volume.box"},
       {"C", "volume.box"},
       {"M", "volume.merge"},
       {"T", "volume.transform"},
       {"Sun", "light.sun"}},
      {{"A", "volume", "M", "volumes"}, {"B", "volume", "M", "volumes"}, {"C", "volume", "M", "volumes"}});
}

TEST(Sockets, AreDeclaredExposedInferredOrUnknown) {
  Graph graph = with({{"Sun", "light.sun"}, {"D", "dot"}, {"N", "value.number"}, {"Math", "value.math"}});
  EXPECT_EQ(inputsOf(graph, "Sun").size(), 0u);
  EXPECT_EQ(outputsOf(graph, "Sun").at(0).type, SocketType::Light);
  EXPECT_TRUE(inputsOf(graph, "D").at(0).any);
  EXPECT_EQ(inputsOf(graph, "Math").size(), 3u) << "a, b and c are always sockets";
  graph = connect(graph, {"N", "value", "Sun", "elevation"}).value();
  ASSERT_EQ(inputsOf(graph, "Sun").size(), 1u) << "connecting exposes";
  EXPECT_TRUE(inputsOf(graph, "Sun")[0].param);
  EXPECT_EQ(inputsOf(graph, "Sun")[0].type, SocketType::Number);
  EXPECT_TRUE(exposeParam(graph, "Sun", "elevation", false)->links.empty());
  EXPECT_TRUE(inputsOf(*exposeParam(graph, "Sun", "elevation", false), "Sun").empty());
  EXPECT_FALSE(exposeParam(graph, "Math", "a", false));
  graph = connect(graph, {"Sun", "light", "D", "in"}).value();
  EXPECT_EQ(outputsOf(graph, "D").at(0).type, SocketType::Light);
  EXPECT_FALSE(outputsOf(graph, "D").at(0).any);
  EXPECT_TRUE(
      linkRefusal(graph, {"Sun", "light", "Sun", "elevation"})->starts_with("Sun takes Number, not Light"));
  const Graph odd =
      parseGraph(
          R"({"pileus": 1, "nodes": {"X": {"type": "odd"}, "M": {"type": "volume.merge"}}, "links": ["X.stuff -> M.volumes"]})")
          ->graph;
  ASSERT_EQ(outputsOf(odd, "X").size(), 1u);
  EXPECT_FALSE(outputsOf(odd, "X")[0].known);
}

TEST(Dots, CarryTypesAlongChains) {
  Graph graph = with(
      {{"Sun", "light.sun"}, {"Box", "volume.box"}, {"D", "dot"}, {"E", "dot"}, {"T", "volume.transform"}},
      {{"D", "out", "E", "in"}, {"E", "out", "T", "volume"}});
  EXPECT_EQ(inputsOf(graph, "D").at(0).type, SocketType::Volume) << "from what it feeds";
  EXPECT_TRUE(linkRefusal(graph, {"Sun", "light", "D", "in"})->starts_with("D takes Volume, not Light"));
  EXPECT_TRUE(linkRefusal(graph, {"E", "out", "Sun", "elevation"}).has_value()) << "one dot, two types";
  EXPECT_EQ(linkRefusal(graph, {"Box", "volume", "D", "in"}), std::nullopt);
  EXPECT_TRUE(linkRefusal(graph, {"E", "out", "D", "in"})->starts_with("this would be a cycle: D -> E -> D"));
}

TEST(Dots, KeepALinksPlace) {
  std::string name;
  const Graph graph = addDot(merged(), {"B", "volume", "M", "volumes"}, {5, 6}, &name).value();
  EXPECT_EQ(name, "Dot");
  EXPECT_EQ(linksOf(graph), (Names{"A.volume > M.volumes", "B.volume > Dot.in", "Dot.out > M.volumes",
                                   "C.volume > M.volumes"}));
  EXPECT_TRUE(removeNodes(graph, {"Dot"}, true).links == merged().links);
  EXPECT_FALSE(addDot(graph, {"B", "volume", "M", "volumes"}, {}));
}

TEST(Edits, InsertOnALinkAndTakeOutAgain) {
  const Graph graph = insertOnLink(merged(), "T", {"B", "volume", "M", "volumes"}).value();
  EXPECT_EQ(linksOf(graph), (Names{"A.volume > M.volumes", "T.volume > M.volumes", "C.volume > M.volumes",
                                   "B.volume > T.volume"}));
  EXPECT_EQ(linksOf(extractNodes(graph, {"T"})),
            (Names{"A.volume > M.volumes", "B.volume > M.volumes", "C.volume > M.volumes"}));
  EXPECT_TRUE(findNode(extractNodes(graph, {"T"}), "T"));
  EXPECT_EQ(insertOnLink(merged(), "Sun", {"B", "volume", "M", "volumes"}).error().message,
            "Sun has no input and output to put on a link");
  EXPECT_EQ(insertOnLink(merged(), "A", {"A", "volume", "M", "volumes"}).error().message,
            "A is at an end of this link");
}

TEST(Edits, ReconnectOnlyWhatFits) {
  Graph graph = connect(merged(), {"M", "volume", "T", "volume"}).value();
  graph = removeNodes(graph, {"M"}, true);
  EXPECT_EQ(linksOf(graph), Names{"A.volume > T.volume"}) << "a single input takes the first of many";
}

TEST(Edits, DuplicateMoveMuteAndFollow) {
  std::set<std::string> copies;
  const Graph graph = duplicateNodes(connect(merged(), {"M", "volume", "T", "volume"}).value(), {"M", "T"},
                                     true, {1, 1}, &copies);
  EXPECT_EQ(copies, (std::set<std::string>{"M 2", "T 2"}));
  EXPECT_EQ(graph.links.size(), 8u);
  EXPECT_EQ(upstreamOf(graph, {"T 2"}), (std::set<std::string>{"A", "B", "C", "M 2", "T 2"}));
  EXPECT_EQ(downstreamOf(graph, {"A"}), (std::set<std::string>{"A", "M", "M 2", "T", "T 2"}));
  const Graph moved = moveLinks(merged(), "A", "volume", "T", "volume").value();
  EXPECT_EQ(linksOf(moved)[0], "T.volume > M.volumes");
  EXPECT_EQ(linksOf(moveLinks(merged(), "A", "volume", "B", "volume").value()),
            (Names{"B.volume > M.volumes", "C.volume > M.volumes"}));
  EXPECT_FALSE(moveLinks(merged(), "A", "volume", "Sun", "light"));
  const Graph muted = muteLinks(merged(), merged().links, true);
  EXPECT_TRUE(muted.links[2].muted);
}

TEST(Frames, CarryWhatLiesInside) {
  Graph graph = with({{"A", "volume.box"}, {"B", "volume.box"}});
  graph = moveNodes(graph, {"B"}, {2000, 0});
  graph = frameAround(graph, {"A"}, "Box");
  ASSERT_EQ(graph.frames.size(), 1u);
  EXPECT_EQ(contentOf(graph, 0).nodes, (std::set<std::string>{"A"}));
  graph = addFrame(graph, {"Small", "#445566", graph.frames[0].at + dvec2(5), {10, 10}, {}});
  const Graph moved = moveFrame(graph, 0, {100, 50}, true);
  EXPECT_EQ(findNode(moved, "A")->at, dvec2(100, 50));
  EXPECT_EQ(findNode(moved, "B")->at, dvec2(2000, 0));
  EXPECT_EQ(moved.frames[1].at, graph.frames[1].at + dvec2(100, 50));
  EXPECT_EQ(findNode(moveFrame(graph, 0, {100, 50}, false), "A")->at, dvec2(0));
  const std::string text = graphText(graph);
  const auto loaded = parseGraph(text);
  EXPECT_TRUE(loaded->faults.empty());
  EXPECT_TRUE(loaded->graph == graph);
  EXPECT_TRUE(removeFrame(removeFrame(graph, 0), 0).frames.empty());
  const auto bad = parseGraph(R"({"pileus": 1, "nodes": {}, "frames": [{"at": [1]}]})");
  ASSERT_EQ(bad->faults.size(), 1u);
  EXPECT_EQ(faultText(bad->faults[0]), "error: frames[0].at: [1] is not two numbers");
  EXPECT_NE(graphText(bad->graph).find("\"at\": [1]"), std::string::npos) << "kept as it is";
}

TEST(Keys, AreSetMovedAndCleared) {
  Graph graph = with({{"Sun", "light.sun"}});
  graph = setKey(graph, "Sun", "elevation", 1, 10.0, Interpolation::Linear).value();
  graph = setParamAt(graph, "Sun", "elevation", 30.0, 11).value();
  const auto keys = [&] { return findNode(graph, "Sun")->animated.at("elevation").keys; };
  ASSERT_EQ(keys().size(), 2u);
  EXPECT_EQ(keys()[1].interpolation, Interpolation::Linear) << "as the key before";
  EXPECT_EQ(clearAnimation(graph, "Sun", "elevation", 6).nodes.at("Sun")->params.at("elevation"),
            ParamValue(20.0));
  EXPECT_EQ(setKey(graph, "Sun", "elevation", 1, 200.0).error().message,
            "Sun.elevation: 200 is outside -90..90");
  graph = moveKeys(graph, {{"Sun", "elevation", 1, 11}, {"Sun", "elevation", 11, 1}}).value();
  EXPECT_EQ(keys()[0].value, ParamValue(30.0)) << "keys change places";
  graph = setInterpolation(graph, "Sun", "elevation", 1, Interpolation::Constant);
  EXPECT_EQ(keys()[0].interpolation, Interpolation::Constant);
  EXPECT_TRUE(parseGraph(graphText(graph))->graph == graph);
  graph = removeKey(removeKey(graph, "Sun", "elevation", 1), "Sun", "elevation", 11);
  EXPECT_TRUE(findNode(graph, "Sun")->animated.empty());
  EXPECT_EQ(findNode(graph, "Sun")->params.at("elevation"), ParamValue(10.0));
  EXPECT_TRUE(findNode(resetParams(graph, "Sun"), "Sun")->params.empty());
  EXPECT_FALSE(setFrameRange(graph, {5, 1}));
  EXPECT_FALSE(setFps(graph, 0));
  EXPECT_EQ(setFps(graph, 25)->settings.fps, 25);
}

}  // namespace
}  // namespace pileus::nodes
