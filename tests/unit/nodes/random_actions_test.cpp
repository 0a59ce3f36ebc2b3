// A hundred thousand random actions against a document: whatever is done, in whatever order, the graph stays
// sound, files read back, and undo finds the way home.
#include <gtest/gtest.h>

#include <random>

#include "nodes/evaluate/flatten.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/document.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_frames.h"
#include "nodes/graph/graph_groups.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

constexpr std::size_t kMostNodes = 24;

/// "" or what is wrong with a graph.
std::string unsound(const Graph& graph) {
  const SocketTable table(graph);
  std::set<std::string> ends, takenInputs;
  for (const auto& [name, node] : graph.nodes) {
    if (!node) return "no node behind " + name;
    if (!checkName(name)) return "a bad name: " + name;
  }
  for (const Link& link : graph.links) {
    const std::string input = link.toNode + "." + link.toSocket;
    const std::string text = link.fromNode + "." + link.fromSocket + " -> " + input;
    const Node *from = findNode(graph, link.fromNode), *to = findNode(graph, link.toNode);
    if (!from || !to) return "dangling: " + text;
    if (!ends.insert(text).second) return "twice: " + text;
    const auto out = table.output(link.fromNode, link.fromSocket),
               in = table.input(link.toNode, link.toSocket);
    if (!out || !in) return "no such socket: " + text;
    if (in->known && !in->many && !takenInputs.insert(input).second) return "taken: " + text;
    const NodeType *gives = findNodeType(from->type), *takes = findNodeType(to->type);
    if (!gives || !takes || passesThrough(from->type) || passesThrough(to->type) || from->group || to->group)
      continue;
    if (!convertible(out->type, in->type)) return "types differ: " + text;
  }
  if (!evaluationOrder(graph)) return evaluationOrder(graph).error().message;
  for (const auto& [name, node] : graph.nodes)
    if (node->group)
      if (const std::string inside = unsound(*node->group); !inside.empty()) return name + "/ " + inside;
  return "";
}

class Actor {
 public:
  Actor(std::uint64_t seed, Graph start) : random_(seed), document(std::move(start)) {}

  void act() {
    const Graph& g = document.graph();
    const std::size_t kind = below(34);
    last = fmt::format("action {}", kind);
    if (g.nodes.size() > kMostNodes) return apply(removeNodes(g, some(g.nodes.size() / 2), chance(2)));
    switch (kind) {
      case 0:
      case 1:
      case 2: {
        const auto types = allNodeTypes();
        return apply(addNode(g, types[below(types.size())].id, place()));
      }
      case 3:
        return apply(removeNodes(g, some(3), chance(2)));
      case 4:
      case 5:
      case 6:
      case 7:
      case 8:
        return apply(connect(g, anyLink()));
      case 9:
        return apply(disconnect(g, oldLink()));
      case 10:
        return apply(setMuted(g, oldLink(), chance(2)));
      case 11:
        return apply(muteLinks(g, {oldLink(), oldLink()}, chance(2)));
      case 12:
        return apply(setRandomParam(false));
      case 13:
        return apply(setRandomParam(true));
      case 14:
        return apply(renameNode(g, node(), chance(4) ? "new/name" : fmt::format("N{}", below(50))));
      case 15:
        return apply(moveNodes(g, some(4), place()), "drag");
      case 16:
        return apply(setBypass(g, some(3), chance(2)));
      case 17:
        return apply(disableNodes(g, some(2), chance(2)));
      case 18:
        return apply(addDot(g, oldLink(), place()));
      case 19:
        return apply(insertOnLink(g, node(), oldLink()));
      case 20:
        return apply(extractNodes(g, some(3)));
      case 21:
        return apply(duplicateNodes(g, some(3), chance(2), place()));
      case 22:
        return moveAllLinks();
      case 23:
        return apply(resetParams(g, node()));
      case 24:
        return expose();
      case 25:
        return apply(groupNodes(g, some(4)));
      case 26:
        return apply(ungroup(g, group()));
      case 27:
        return document.enter(group()), void();
      case 28:
        return document.leave(1 + below(2));
      case 29:
        return frames();
      case 30:
        return animate();
      case 31:
        return paste();
      case 32:
        for (std::size_t i = below(4); i > 0; --i) chance(2) ? document.undo() : document.redo();
        return document.undo();
      default: {
        std::set<std::string> names = some(5);
        std::erase_if(names, [&](const std::string& name) { return !g.nodes.contains(name); });
        return document.select(std::move(names));
      }
    }
  }

  std::size_t below(std::size_t n) { return n < 2 ? 0 : static_cast<std::size_t>(random_()) % n; }
  bool chance(std::size_t n) { return below(n) == 0; }

 private:
  std::mt19937_64 random_;

  void apply(Result<Graph> graph, std::string_view merge = {}) {
    if (graph) document.edit(std::move(*graph), last, chance(2) ? merge : std::string_view());
  }
  dvec2 place() { return dvec2(static_cast<double>(below(2000)), static_cast<double>(below(1500))) - 500.0; }
  std::string node() {
    const auto& nodes = document.graph().nodes;
    if (nodes.empty() || chance(40)) return "Nobody";
    return std::next(nodes.begin(), static_cast<long>(below(nodes.size())))->first;
  }
  std::string group() {
    std::string name = node();
    for (const auto& [n, p] : document.graph().nodes)
      if (p->group &&
          (!findNode(document.graph(), name) || !findNode(document.graph(), name)->group || chance(2)))
        name = n;
    return name;
  }
  std::set<std::string> some(std::size_t most) {
    std::set<std::string> names;
    for (std::size_t i = below(most + 1) + 1; i > 0; --i) names.insert(node());
    return names;
  }
  Link oldLink() {
    const auto& links = document.graph().links;
    if (links.empty() || chance(40)) return {"A", "b", "C", "d", false};
    return links[below(links.size())];
  }
  /// Sockets that exist, mostly of types that fit.
  Link anyLink() {
    Link link{node(), "x", node(), "y", false};
    const SocketTable table(document.graph());
    for (int tries = 0; tries < 6; ++tries) {
      link.fromNode = node(), link.toNode = node();
      const auto outs = table.outputs(link.fromNode), ins = table.inputs(link.toNode);
      if (!outs.empty()) link.fromSocket = outs[below(outs.size())].id;
      if (!ins.empty()) link.toSocket = ins[below(ins.size())].id;
      const Node* to = findNode(document.graph(), link.toNode);
      const NodeType* type = to ? findNodeType(to->type) : nullptr;
      if (type && !type->params.empty() && chance(4))
        link.toSocket = type->params[below(type->params.size())].id;
      if (!table.refusal(link)) break;
    }
    return link;
  }
  const ParamSpec* param(const std::string& name) {
    const Node* n = findNode(document.graph(), name);
    const NodeType* type = n ? findNodeType(n->type) : nullptr;
    return type && !type->params.empty() ? &type->params[below(type->params.size())] : nullptr;
  }
  ParamValue value(const ParamSpec& spec) {
    const double x = static_cast<double>(below(2000)) * 0.05 - 20;
    switch (spec.type) {
      case ParamType::Bool:
        return chance(2);
      case ParamType::Int:
        return static_cast<int>(below(40)) - 4;
      case ParamType::Float:
        return x;
      case ParamType::Vector:
      case ParamType::Color:
        return dvec3(x, 1, below(9));
      case ParamType::Enum:
        return spec.choices[below(spec.choices.size())].id;
      case ParamType::Curve:
        return Curve{{{0, 0.5}, {0.25 * static_cast<double>(1 + below(4)), 1}}, CurveShape::Linear};
      case ParamType::Ramp:
        return Ramp{{{0.5, dvec3(0.1 * static_cast<double>(below(12)))}}, RampShape::Smooth};
      default:
        return std::string(chance(2) ? "smoke.vdb" : "W\xc3\xb6lkchen \"1\"");
    }
  }
  Result<Graph> setRandomParam(bool atFrame) {
    const std::string name = node();
    const ParamSpec* spec = param(name);
    if (!spec) return fail(Code::Arguments, "none");
    if (atFrame)
      return setParamAt(document.graph(), name, spec->id, value(*spec), static_cast<double>(below(50)));
    return setParam(document.graph(), name, spec->id, value(*spec));
  }
  void expose() {
    const std::string name = node();
    if (const ParamSpec* spec = param(name)) apply(exposeParam(document.graph(), name, spec->id, chance(2)));
  }
  void moveAllLinks() {
    const Link a = oldLink(), b = anyLink();
    apply(moveLinks(document.graph(), a.fromNode, a.fromSocket, b.fromNode, b.fromSocket));
  }
  void frames() {
    const Graph& g = document.graph();
    const std::size_t i = below(g.frames.size() + 1);
    switch (g.frames.size() > 6 ? 1 : below(5)) {
      case 0:
        return apply(addFrame(g, {"Lights", "#445566", place(), {300, 200}, {}}));
      case 1:
        return apply(removeFrame(g, i));
      case 2:
        return apply(moveFrame(g, i, place(), chance(2)));
      case 3:
        return apply(setFrame(g, i, {"", "", place(), {10, 10}, {}}));
      default:
        return apply(frameAround(g, some(5), "Around"));
    }
  }
  void animate() {
    const Graph& g = document.graph();
    const std::string name = node();
    const ParamSpec* spec = param(name);
    if (!spec)
      return apply(chance(2) ? setFps(g, static_cast<double>(below(60)))
                             : setFrameRange(g, {1, static_cast<int>(below(99))}));
    const double frame = static_cast<double>(below(8));
    switch (below(6)) {
      case 0:
        return apply(removeKey(g, name, spec->id, frame));
      case 1:
        return apply(setInterpolation(g, name, spec->id, frame, Interpolation::Linear));
      case 2:
        return apply(clearAnimation(g, name, spec->id, frame));
      case 3:
        return apply(moveKeys(g, {{name, spec->id, frame, frame + 1}, {name, spec->id, frame + 1, frame}}));
      default:
        return apply(setKey(g, name, spec->id, frame, value(*spec)));
    }
  }
  void paste() {
    const Graph& g = document.graph();
    std::set<std::string> names = some(5);
    const bool damage = chance(2);
    if (damage) std::erase_if(names, [&](const std::string& n) { return groupGraph(g, n); });
    std::string text = copyText(g, names);
    for (std::size_t i = damage ? 1 + below(4) : 0; i > 0; --i) {
      const std::size_t at = below(text.size());
      if (chance(2))
        text[at] = "{}[]\",:.0a-> \n"[below(14)];
      else
        text.erase(at, below(8));
    }
    apply(pasteText(g, text, place()));
  }

 public:
  Document document;
  std::string last;
};

TEST(RandomActions, LeaveEveryGraphSoundAndUndoFindsTheWayHome) {
  Graph graph;
  std::size_t steps = 0, deepest = 0;
  for (std::uint64_t round = 0; round < 20; ++round) {
    Actor actor(round + 1, graph);
    Document& document = actor.document;
    const std::string firstText = graphText(graph);
    for (int i = 1; i <= 5000; ++i) {
      actor.act();
      const std::string problem = unsound(document.graph());
      ASSERT_EQ(problem, "") << "round " << round << ", step " << i << ", " << actor.last;
      for (const std::string& name : document.selection()) ASSERT_TRUE(document.graph().nodes.contains(name));
      ASSERT_TRUE(graphAt(document.root(), document.scope()));
      deepest = std::max(deepest, document.scope().size());
      if (i % 1000 != 0) continue;
      ASSERT_EQ(unsound(document.root()), "") << "round " << round << ", step " << i;
      const std::string text = graphText(document.root());
      const auto loaded = parseGraph(text);
      ASSERT_TRUE(loaded) << loaded.error().message;
      ASSERT_EQ(graphText(loaded->graph), text);
      const FlatGraph flat = flatten(document.root());
      for (const Link& link : flat.graph.links)
        ASSERT_TRUE(flat.graph.nodes.contains(link.fromNode) && flat.graph.nodes.contains(link.toNode))
            << link.fromNode << " -> " << link.toNode;
    }
    const Graph last = document.root();
    while (document.canRedo()) document.redo();
    const Graph newest = document.root();
    steps += document.steps();
    while (document.canUndo()) document.undo();
    ASSERT_TRUE(document.root() == graph);
    ASSERT_EQ(graphText(document.root()), firstText);
    while (document.canRedo()) document.redo();
    ASSERT_TRUE(document.root() == newest);
    graph = last;
  }
  EXPECT_GT(steps, 20000u);
  EXPECT_GE(deepest, 2u);
}

TEST(History, IsBoundedInStepsAndBytes) {
  Document small(addNode({}, "light.sun", {0, 0}, "Sun").value());
  for (int i = 0; i < 20050; ++i) small.edit(moveNodes(small.graph(), {"Sun"}, {1, 0}), "Move");
  EXPECT_EQ(small.steps(), Document::kMostSteps);
  while (small.canUndo()) small.undo();
  EXPECT_EQ(findNode(small.root(), "Sun")->at.x, 50);
  Graph large;
  for (int i = 0; i < 4000; ++i) {
    Node node;
    node.type = "light.sun";
    large.nodes.emplace(fmt::format("Sun {}", i), std::make_shared<const Node>(std::move(node)));
  }
  Document document(large);
  for (int i = 0; i < 600; ++i) document.edit(moveNodes(document.graph(), {"Sun 7"}, {1, 0}), "Move");
  EXPECT_LT(document.steps(), 450u);
  EXPECT_GE(document.steps(), Document::kLeastSteps);
}

}  // namespace
}  // namespace pileus::nodes
