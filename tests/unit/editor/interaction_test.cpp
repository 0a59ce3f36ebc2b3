#include "editor/graph_view/interaction.h"

#include <gtest/gtest.h>

#include "editor/graph_view/hit_test.h"

namespace pileus::editor {
namespace {

using State = Interaction::State;

/// Feeds one frame at a time, as the canvas does.
struct Hand {
  Interaction machine;
  PointerInput in;
  std::vector<Command> all;

  Hand() { in.over = true; }
  std::vector<Command> frame(vec2 at, Hit hit = {}, bool selected = false) {
    in.pos = at;
    in.hit = std::move(hit);
    std::vector<Command> out = step(machine, in, selected, 4);
    for (int i = 0; i < 3; ++i) in.pressed[i] = in.released[i] = false;
    in.wheel = 0;
    in.cancel = false;
    all.insert(all.end(), out.begin(), out.end());
    return out;
  }
  template <class T>
  std::vector<T> commands() const {
    std::vector<T> found;
    for (const Command& c : all)
      if (const T* t = std::get_if<T>(&c)) found.push_back(*t);
    return found;
  }
};

Hit onNode(const char* name) { return {Hit::Kind::Node, name, {}, {}, {}}; }
Hit onOutput(const char* name, const char* socket) { return {Hit::Kind::Output, name, socket, {}, {}}; }
Hit onInput(const char* name, const char* socket) { return {Hit::Kind::Input, name, socket, {}, {}}; }

TEST(Interaction, AClickSelectsAndADragMoves) {
  Hand hand;
  hand.in.pressed[0] = true;
  hand.frame({10, 10}, onNode("Sun"));
  EXPECT_EQ(hand.machine.state, State::PressedNode);
  hand.frame({12, 10}, onNode("Sun"));
  EXPECT_TRUE(hand.commands<command::Move>().empty()) << "below the drag threshold";
  hand.frame({30, 20}, onNode("Sun"));
  hand.frame({40, 25}, onNode("Sun"));
  hand.in.released[0] = true;
  hand.frame({40, 25}, onNode("Sun"));
  vec2 sum(0);
  for (const command::Move& m : hand.commands<command::Move>()) sum += m.by;
  EXPECT_EQ(sum, vec2(30, 15)) << "the node follows the pointer exactly";
  ASSERT_EQ(hand.commands<command::SelectNode>().size(), 1u);
  EXPECT_EQ(hand.commands<command::MoveDone>().size(), 1u);
  EXPECT_EQ(hand.machine.state, State::Idle);
}

TEST(Interaction, PressingASelectedNodeKeepsTheSelectionUntilItIsNoDrag) {
  Hand hand;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onNode("Sun"), true);
  EXPECT_TRUE(hand.commands<command::SelectNode>().empty());
  hand.in.released[0] = true;
  hand.frame({1, 0}, onNode("Sun"), true);
  ASSERT_EQ(hand.commands<command::SelectNode>().size(), 1u);
  EXPECT_EQ(hand.commands<command::SelectNode>()[0].op, SelectOp::Replace);
}

TEST(Interaction, ModifiersAddAndRemove) {
  Hand hand;
  hand.in.shift = true;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onNode("A"));
  hand.in.released[0] = true;
  hand.frame({0, 0}, onNode("A"));
  hand.in.shift = false;
  hand.in.ctrl = true;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onNode("B"));
  const auto picked = hand.commands<command::SelectNode>();
  ASSERT_EQ(picked.size(), 2u);
  EXPECT_EQ(picked[0].op, SelectOp::Add);
  EXPECT_EQ(picked[1].op, SelectOp::Remove);
}

TEST(Interaction, BoxSelectsAndAnEmptyClickDeselects) {
  Hand hand;
  hand.in.pressed[0] = true;
  hand.frame({5, 5});
  hand.frame({100, 80});
  hand.in.released[0] = true;
  hand.frame({120, 90});
  const auto boxes = hand.commands<command::SelectBox>();
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].a, vec2(5, 5));
  EXPECT_EQ(boxes[0].b, vec2(120, 90));
  hand.in.pressed[0] = true;
  hand.frame({5, 5});
  hand.in.released[0] = true;
  hand.frame({5, 5});
  EXPECT_EQ(hand.commands<command::SelectNone>().size(), 1u);
}

TEST(Interaction, LinksDragFromOutputsAndInputs) {
  Hand hand;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onOutput("Sun", "light"));
  EXPECT_EQ(hand.machine.state, State::DraggingLink);
  hand.frame({50, 0});
  hand.in.released[0] = true;
  hand.frame({60, 0}, onInput("Render", "lights"));
  auto drops = hand.commands<command::LinkDrop>();
  ASSERT_EQ(drops.size(), 1u);
  EXPECT_TRUE(drops[0].drag.fromOutput);
  EXPECT_EQ(drops[0].on.socket, "lights");

  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onInput("Render", "camera"));
  hand.in.released[0] = true;
  hand.frame({60, 0});
  drops = hand.commands<command::LinkDrop>();
  ASSERT_EQ(drops.size(), 2u);
  EXPECT_FALSE(drops[1].drag.fromOutput);
  EXPECT_EQ(drops[1].on.kind, Hit::Kind::Canvas);
}

TEST(Interaction, ATakenInputGivesItsLinkToThePointer) {
  Hand hand;
  Hit hit = onInput("View", "image");
  hit.taken = nodes::Link{"Render", "image", "View", "image"};
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, hit);
  EXPECT_TRUE(hand.machine.link.fromOutput);
  EXPECT_EQ(hand.machine.link.node, "Render");
  ASSERT_TRUE(hand.machine.link.replaces);
  hand.in.cancel = true;
  hand.frame({50, 50});
  EXPECT_EQ(hand.machine.state, State::Idle);
  EXPECT_TRUE(hand.commands<command::LinkDrop>().empty()) << "a cancelled drag changes nothing";
}

TEST(Interaction, AClickOnASocketDropsNothing) {
  Hand hand;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onOutput("Sun", "light"));
  hand.in.released[0] = true;
  hand.frame({1, 1}, onOutput("Sun", "light"));
  EXPECT_TRUE(hand.commands<command::LinkDrop>().empty());
  EXPECT_EQ(hand.machine.state, State::Idle);
}

TEST(Interaction, PansZoomsAndOpensMenus) {
  Hand hand;
  hand.in.pressed[2] = true;
  hand.frame({0, 0});
  hand.frame({30, 10});
  hand.in.released[2] = true;
  hand.frame({30, 10});
  ASSERT_EQ(hand.commands<command::Pan>().size(), 1u);
  EXPECT_EQ(hand.commands<command::Pan>()[0].by, vec2(30, 10));
  hand.in.wheel = 2;
  hand.frame({7, 8});
  ASSERT_EQ(hand.commands<command::Zoom>().size(), 1u);
  EXPECT_EQ(hand.commands<command::Zoom>()[0].at, vec2(7, 8));
  hand.in.pressed[1] = true;
  hand.frame({1, 1});
  hand.in.released[1] = true;
  hand.frame({1, 1});
  EXPECT_EQ(hand.commands<command::Search>().size(), 1u);
  hand.in.pressed[1] = true;
  hand.frame({1, 1}, onNode("Sun"));
  hand.in.released[1] = true;
  hand.frame({1, 1}, onNode("Sun"));
  EXPECT_EQ(hand.commands<command::Menu>().size(), 1u);
}

TEST(Interaction, NothingStartsWhereThePointerIsNotOverTheCanvas) {
  Hand hand;
  hand.in.over = false;
  hand.in.wheel = 1;
  hand.in.pressed[0] = hand.in.pressed[1] = hand.in.pressed[2] = true;
  EXPECT_TRUE(hand.frame({0, 0}, onNode("Sun")).empty());
  EXPECT_EQ(hand.machine.state, State::Idle);
}

nodes::Graph twoNodes() {
  nodes::Graph graph = *nodes::addNode({}, "light.sun", {0, 0}, "Sun");
  return *nodes::addNode(graph, "shadow.extinction", {300, 0}, "Map");
}

TEST(HitTest, FindsBodiesDotsAndLabels) {
  const nodes::Graph graph = *nodes::connect(twoNodes(), {"Sun", "light", "Map", "light"});
  const Layout layout = layoutGraph(graph, {});
  const NodePlace& sun = *findPlace(layout, "Sun");
  const SocketPlace& out = *findSocket(sun, "light", false);
  const SocketPlace& in = *findSocket(*findPlace(layout, "Map"), "light", true);
  EXPECT_EQ(hitTest(layout, graph, sun.min + vec2(60, 10), 1, {}).kind, Hit::Kind::Node);
  EXPECT_EQ(hitTest(layout, graph, out.at, 1, {}).kind, Hit::Kind::Output);
  EXPECT_EQ(hitTest(layout, graph, out.at - vec2(30, 0), 1, {}).kind, Hit::Kind::Output)
      << "the label belongs to the socket";
  EXPECT_EQ(hitTest(layout, graph, in.at + vec2(30, 0), 1, {}).kind, Hit::Kind::Input);
  EXPECT_EQ(hitTest(layout, graph, 0.5f * (out.at + in.at), 1, {}).kind, Hit::Kind::Link);
  EXPECT_EQ(hitTest(layout, graph, {-500, -500}, 1, {}).kind, Hit::Kind::Canvas);
  EXPECT_EQ(nodesInside(layout, {-10, -10}, {10, 10}), std::set<std::string>{"Sun"});
}

}  // namespace
}  // namespace pileus::editor
