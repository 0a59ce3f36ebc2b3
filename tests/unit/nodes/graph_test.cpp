// The graph as a value, its edits, and the document's undo.
#include <gtest/gtest.h>

#include <random>

#include "nodes/file/serialize.h"
#include "nodes/graph/document.h"

namespace pileus::nodes {
namespace {

Graph with(const std::vector<std::pair<std::string, std::string>>& nodes,
           const std::vector<Link>& links = {}) {
  Graph graph;
  for (const auto& [name, type] : nodes) graph = addNode(graph, type, {0, 0}, name).value();
  for (const Link& link : links) graph = connect(graph, link).value();
  return graph;
}

std::vector<std::string> sourcesOf(const Graph& graph, const std::string& node) {
  std::vector<std::string> names;
  for (const Link& link : graph.links)
    if (link.toNode == node) names.push_back(link.fromNode);
  return names;
}

using Names = std::vector<std::string>;

TEST(Names, AreCheckedAndMadeFree) {
  for (const auto bad : {"", "a.b", "a/b", "a=b", "a->b", "a\nb", " a", "a ", "\x7f", "\xff", "\xc0\xaf"})
    EXPECT_FALSE(checkName(bad)) << bad;
  for (const auto good : {"Sun", "a-b", "a>b", "Wölkchen", "雲", "Sun 2"})
    EXPECT_TRUE(checkName(good)) << good;
  EXPECT_FALSE(checkName(std::string(129, 'a')));
  EXPECT_TRUE(checkName(std::string(128, 'a')));
  const std::string lengthy = std::string(126, 'a') + "ö";
  const Graph graph = with({{"Sun", "light.sun"}, {"Sun 2", "light.sun"}, {lengthy, "light.sun"}});
  EXPECT_EQ(freeName(graph, "Moon"), "Moon");
  EXPECT_EQ(freeName(graph, "Sun"), "Sun 3");
  EXPECT_EQ(freeName(graph, "Sun 2"), "Sun 3");
  EXPECT_TRUE(checkName(freeName(graph, lengthy)));
}

TEST(GraphEdit, RefusesWhatCannotBe) {
  const Graph graph = with({{"Sun", "light.sun"}, {"Box", "volume.box"}});
  EXPECT_FALSE(addNode(graph, "no.such", {0, 0}));
  EXPECT_FALSE(addNode(graph, "light.sun", {0, 0}, "Sun"));
  EXPECT_FALSE(addNode(graph, "light.sun", {0, 0}, "a.b"));
  EXPECT_FALSE(renameNode(graph, "Sun", "Box"));
  EXPECT_FALSE(renameNode(graph, "Nobody", "X"));
  EXPECT_EQ(setParam(graph, "Sun", "elevation", 120.0).error().message,
            "Sun.elevation: 120 is outside -90..90");
  EXPECT_FALSE(setParam(graph, "Sun", "height", 1.0));
  EXPECT_FALSE(setParam(graph, "Nobody", "height", 1.0));
}

TEST(GraphEdit, KeepsOnlyWhatDiffersFromTheDefault) {
  const Graph graph = with({{"Sun", "light.sun"}});
  const Graph set = setParam(graph, "Sun", "elevation", 20.0).value();
  EXPECT_EQ(findNode(set, "Sun")->params.size(), 1u);
  EXPECT_FALSE(set == graph);
  EXPECT_TRUE(setParam(set, "Sun", "elevation", 40.0).value() == graph);
  EXPECT_EQ(paramValue(*findNode(set, "Sun"), *findNodeType("light.sun")->param("elevation")),
            ParamValue(20.0));
}

TEST(Links, AreRefusedInWords) {
  const Graph graph = with(
      {{"Sun", "light.sun"}, {"Box", "volume.box"}, {"T", "volume.transform"}, {"U", "volume.transform"}},
      {{"Box", "volume", "T", "volume"}, {"T", "volume", "U", "volume"}});
  EXPECT_EQ(linkRefusal(graph, {"Box", "volume", "U", "volume"}), std::nullopt);
  EXPECT_EQ(*linkRefusal(graph, {"U", "volume", "T", "volume"}), "this would be a cycle: T -> U -> T");
  EXPECT_EQ(*linkRefusal(graph, {"T", "volume", "T", "volume"}), "this would be a cycle: T -> T");
  EXPECT_TRUE(linkRefusal(graph, {"Sun", "light", "T", "volume"})->starts_with("T takes Volume, not Light"));
  EXPECT_EQ(*linkRefusal(graph, {"Sun", "glow", "T", "volume"}), "Sun has no output 'glow'");
  EXPECT_EQ(*linkRefusal(graph, {"Box", "volume", "Sun", "volume"}), "Sun has no input 'volume'");
  EXPECT_EQ(*linkRefusal(graph, {"Nobody", "volume", "T", "volume"}), "there is no node 'Nobody'");
  EXPECT_FALSE(connect(graph, {"U", "volume", "T", "volume"}));
}

TEST(Links, ReplaceInSingleInputsAndQueueInManyOnes) {
  Graph graph = with({{"A", "volume.box"},
                      {"B", "volume.box"},
                      {"C", "volume.box"},
                      {"T", "volume.transform"},
                      {"M", "volume.merge"}},
                     {{"A", "volume", "T", "volume"}, {"B", "volume", "T", "volume"}});
  EXPECT_EQ(sourcesOf(graph, "T"), Names{"B"});
  for (const auto from : {"A", "B", "C"}) graph = connect(graph, {from, "volume", "M", "volumes"}).value();
  EXPECT_EQ(sourcesOf(graph, "M"), (Names{"A", "B", "C"}));
  EXPECT_TRUE(connect(graph, {"A", "volume", "M", "volumes"}).value() == graph);
  const Graph muted = setMuted(graph, {"A", "volume", "M", "volumes"}, true);
  EXPECT_FALSE(muted == graph);
  EXPECT_TRUE(setMuted(muted, {"A", "volume", "M", "volumes"}, false) == graph);
  EXPECT_EQ(sourcesOf(disconnect(graph, {"B", "volume", "M", "volumes"}), "M"), (Names{"A", "C"}));
  // A link that closes a cycle only through the one it replaces is fine.
  const Graph chain =
      with({{"T", "volume.transform"}, {"U", "volume.transform"}}, {{"T", "volume", "U", "volume"}});
  EXPECT_FALSE(connect(chain, {"U", "volume", "T", "volume"}));
}

TEST(Links, SurviveRemovalAndRenaming) {
  Graph graph =
      with({{"A", "volume.box"},
            {"B", "volume.box"},
            {"T", "volume.transform"},
            {"U", "volume.medium"},
            {"M", "volume.merge"}},
           {{"A", "volume", "T", "volume"}, {"T", "volume", "U", "volume"}, {"U", "volume", "M", "volumes"}});
  graph = connect(graph, {"B", "volume", "M", "volumes"}).value();
  EXPECT_EQ(sourcesOf(removeNodes(graph, {"T", "U"}, true), "M"), (Names{"A", "B"}));
  EXPECT_EQ(sourcesOf(removeNodes(graph, {"T", "U"}), "M"), Names{"B"});
  const Graph renamed = renameNode(graph, "U", "Haze").value();
  EXPECT_EQ(sourcesOf(renamed, "M"), (Names{"Haze", "B"}));
  EXPECT_TRUE(renameNode(renamed, "Haze", "U").value() == graph);
}

TEST(Order, PutsInputsFirstAndNamesCycles) {
  Graph graph = with({{"A", "volume.transform"}, {"B", "volume.transform"}, {"Z", "volume.box"}},
                     {{"Z", "volume", "B", "volume"}, {"B", "volume", "A", "volume"}});
  EXPECT_EQ(evaluationOrder(graph).value(), (Names{"Z", "B", "A"}));
  graph.links.push_back({"A", "volume", "B", "volume", true});
  EXPECT_TRUE(evaluationOrder(graph)) << "a muted link is no link";
  graph.links.back().muted = false;
  EXPECT_EQ(evaluationOrder(graph).error().message, "cycle: A -> B -> A");
  Graph chain;
  for (int i = 0; i < 5000; ++i) {
    const auto name = [](int n) { return "N" + std::to_string(n); };
    Node node;
    node.type = "volume.transform";
    chain.nodes[name(i)] = std::make_shared<const Node>(node);
    if (i > 0) chain.links.push_back({name(i), "volume", name(i - 1), "volume"});
  }
  EXPECT_EQ(evaluationOrder(chain).value().front(), "N4999");
}

TEST(Document, MergesDragsAndRestoresSelections) {
  Document document(with({{"Sun", "light.sun"}, {"Box", "volume.box"}}));
  EXPECT_FALSE(document.dirty());
  document.select({"Sun"});
  for (const double elevation : {1.0, 2.0, 3.0})
    document.edit(setParam(document.graph(), "Sun", "elevation", elevation).value(), "Set elevation",
                  "Sun.elevation");
  document.endMerge();
  document.edit(setParam(document.graph(), "Sun", "elevation", 4.0).value(), "Set elevation",
                "Sun.elevation");
  document.edit(document.graph(), "Nothing");
  document.select({"Box"});
  document.edit(removeNodes(document.graph(), {"Box"}), "Delete");
  EXPECT_TRUE(document.selection().empty()) << "a deleted node is not selected";
  EXPECT_EQ(document.undoLabel(), "Delete");
  document.undo();
  EXPECT_EQ(document.selection(), std::set<std::string>{"Box"});
  EXPECT_EQ(document.redoLabel(), "Delete");
  document.undo();
  document.undo();
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.selection(), std::set<std::string>{"Sun"});
  document.redo();
  EXPECT_TRUE(document.dirty());
  document.markSaved("x.json");
  EXPECT_FALSE(document.dirty());
  document.edit(moveNodes(document.graph(), {"Sun"}, {1, 0}), "Move", "move");
  EXPECT_FALSE(document.canRedo());
  document.edit(moveNodes(document.graph(), {"Sun"}, {-1, 0}), "Move", "move");
  EXPECT_FALSE(document.dirty()) << "dragged back: no step";
  EXPECT_EQ(document.undoLabel(), "Set elevation");
}

/// One random edit, possible or not.
Graph randomEdit(const Graph& graph, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const auto pick = [&]() -> std::string {
    if (graph.nodes.empty()) return "Nobody";
    return std::next(graph.nodes.begin(), static_cast<std::ptrdiff_t>(below(graph.nodes.size())))->first;
  };
  const std::string name = pick();
  const Node* node = findNode(graph, name);
  const NodeType* type = node ? findNodeType(node->type) : nullptr;
  switch (below(10)) {
    case 0:
    case 1:
    case 2:
      if (graph.nodes.size() < 40)
        return addNode(graph, allNodeTypes()[below(allNodeTypes().size())].id, {double(below(500)), 0})
            .value();
      return removeNodes(graph, {name}, below(2) == 0);
    case 3:
      return removeNodes(graph, {name}, below(2) == 0);
    case 4:
    case 5: {
      const std::string to = pick();
      const NodeType* target = graph.nodes.empty() ? nullptr : findNodeType(findNode(graph, to)->type);
      if (!type || !target || type->outputs.empty() || target->inputs.empty()) return graph;
      const auto linked =
          connect(graph, {name, type->outputs[0].id, to, target->inputs[below(target->inputs.size())].id});
      return linked ? *linked : graph;
    }
    case 6:
      if (!graph.links.empty()) return disconnect(graph, graph.links[below(graph.links.size())]);
      return graph;
    case 7: {
      if (!type || type->params.empty()) return graph;
      const ParamSpec& spec = type->params[below(type->params.size())];
      const auto set = setParam(graph, name, spec.id, double(below(100)) / 10);
      return set ? *set : graph;
    }
    case 8: {
      const auto renamed = renameNode(graph, name, freeName(graph, "Renamed"));
      return renamed ? *renamed : graph;
    }
    default:
      return below(2) ? moveNodes(graph, {name}, {1, 2}) : setBypass(graph, {name}, below(2) == 0);
  }
}

TEST(Document, UndoesTenThousandRandomEdits) {
  std::mt19937 random(7);
  const Graph first = with({{"Sun", "light.sun"}});
  Document document(first);
  for (int i = 0; i < 10000; ++i) {
    document.edit(randomEdit(document.graph(), random), "Edit " + std::to_string(i));
    if (i % 500 == 0) {
      ASSERT_TRUE(evaluationOrder(document.graph())) << "edits never make a cycle";
      const std::string text = graphText(document.graph());
      const auto again = parseGraph(text);
      ASSERT_TRUE(again);
      ASSERT_TRUE(again->faults.empty()) << faultText(again->faults[0]);
      ASSERT_EQ(graphText(again->graph), text);
      ASSERT_TRUE(again->graph == document.graph());
    }
  }
  const std::string last = graphText(document.graph());
  while (document.canUndo()) document.undo();
  EXPECT_TRUE(document.graph() == first);
  EXPECT_EQ(graphText(document.graph()), graphText(first));
  while (document.canRedo()) document.redo();
  EXPECT_EQ(graphText(document.graph()), last);
}

}  // namespace
}  // namespace pileus::nodes
