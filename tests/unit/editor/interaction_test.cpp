#include "editor/graph_view/interaction.h"

#include <gtest/gtest.h>

#include "editor/graph_view/layout/hit_test.h"
#include "editor/graph_view/layout/path_geometry.h"

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

TEST(Interaction, EscTakesAMoveBack) {
  Hand hand;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onNode("Sun"));
  hand.frame({50, 0}, onNode("Sun"));
  hand.in.cancel = true;
  hand.frame({60, 0}, onNode("Sun"));
  EXPECT_EQ(hand.commands<command::Cancel>().size(), 1u);
  hand.in.released[0] = true;
  hand.frame({60, 0}, onNode("Sun"));
  EXPECT_TRUE(hand.commands<command::MoveDone>().empty());
}

nodes::Link linkTo(const char* node) { return {"Sun", "light", node, "light"}; }

TEST(Interaction, ShiftAtAnInputDrawsAnotherLinkFromItsSource) {
  Hand hand;
  Hit hit = onInput("Map", "light");
  hit.taken = linkTo("Map");
  hit.links = {linkTo("Map")};
  hand.in.shift = true;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, hit);
  EXPECT_TRUE(hand.machine.link.fromOutput);
  EXPECT_EQ(hand.machine.link.node, "Sun");
  EXPECT_FALSE(hand.machine.link.replaces) << "the old link stays";
  EXPECT_TRUE(hand.machine.link.moves.empty());
}

TEST(Interaction, CtrlAtAnOutputTakesAllOfItsLinks) {
  Hand hand;
  Hit hit = onOutput("Sun", "light");
  hit.links = {linkTo("A"), linkTo("B")};
  hand.in.ctrl = true;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, hit);
  EXPECT_EQ(hand.machine.link.moves, hit.links);
  hand.in.released[0] = true;
  hand.frame({90, 0}, onOutput("Lamp", "light"));
  ASSERT_EQ(hand.commands<command::LinkDrop>().size(), 1u);
  EXPECT_EQ(hand.commands<command::LinkDrop>()[0].on.node, "Lamp");
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, onOutput("Free", "light"));
  EXPECT_TRUE(hand.machine.link.moves.empty()) << "an output without links begins one";
}

TEST(Interaction, CtrlClickPutsADotAndCtrlShiftClickViews) {
  Hand hand;
  Hit onLink;
  onLink.kind = Hit::Kind::Link;
  onLink.link = linkTo("A");
  hand.in.ctrl = true;
  hand.in.pressed[0] = true;
  hand.frame({3, 4}, onLink);
  ASSERT_EQ(hand.commands<command::PutDot>().size(), 1u);
  EXPECT_EQ(hand.commands<command::PutDot>()[0].link, linkTo("A"));
  EXPECT_EQ(hand.commands<command::PutDot>()[0].at, vec2(3, 4));
  hand.in.shift = true;
  hand.in.pressed[0] = true;
  hand.frame({3, 4}, onNode("Render"));
  ASSERT_EQ(hand.commands<command::View>().size(), 1u);
  EXPECT_EQ(hand.machine.state, State::Idle);
  EXPECT_TRUE(hand.commands<command::SelectNode>().empty());
}

/// Draws a line with a button and modifiers that `set` chooses; returns what it became.
std::vector<command::StrokeDone> drawnWith(Hand& hand, int button) {
  hand.in.pressed[button] = true;
  hand.frame({0, 0});
  EXPECT_EQ(hand.machine.state, State::Stroking);
  for (float x = 0; x <= 100; x += 1) hand.frame({x, 0});
  hand.in.released[button] = true;
  hand.frame({101, 0});
  EXPECT_EQ(hand.machine.state, State::Idle);
  return hand.commands<command::StrokeDone>();
}

TEST(Interaction, RightDragsAndTheKnifeKeyDrawLines) {
  struct Case {
    bool ctrl, shift, alt, knife;
    int button;
    Stroke becomes;
  };
  for (const Case c : {Case{true, false, false, false, 1, Stroke::Cut},
                       {true, false, true, false, 1, Stroke::Mute},
                       {false, true, false, false, 1, Stroke::Dots},
                       {false, false, false, true, 0, Stroke::Cut}}) {
    Hand hand;
    hand.in.ctrl = c.ctrl, hand.in.shift = c.shift, hand.in.alt = c.alt, hand.in.knife = c.knife;
    const auto lines = drawnWith(hand, c.button);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].kind, c.becomes);
    EXPECT_EQ(lines[0].points.front(), vec2(0, 0));
    EXPECT_EQ(lines[0].points.back(), vec2(101, 0)) << "the line ends where the button was released";
    EXPECT_LT(lines[0].points.size(), 40u) << "points a pixel apart are thinned out";
  }
}

TEST(Interaction, EscEndsALineWithoutConsequence) {
  Hand hand;
  hand.in.ctrl = true;
  hand.in.pressed[1] = true;
  hand.frame({0, 0});
  hand.frame({100, 0});
  hand.in.cancel = true;
  hand.frame({120, 0});
  EXPECT_EQ(hand.machine.state, State::Idle);
  hand.in.released[1] = true;
  hand.frame({120, 0});
  EXPECT_TRUE(hand.commands<command::StrokeDone>().empty());
  EXPECT_TRUE(hand.commands<command::Menu>().empty());
}

TEST(Interaction, AModifiedRightClickOpensTheMenuOfWhatIsThere) {
  Hand hand;
  hand.in.ctrl = true;
  hand.in.pressed[1] = true;
  hand.frame({5, 5});
  hand.in.released[1] = true;
  hand.frame({5, 5});
  ASSERT_EQ(hand.commands<command::Menu>().size(), 1u);
  EXPECT_EQ(hand.commands<command::Menu>()[0].hit.kind, Hit::Kind::Canvas);
}

TEST(Interaction, ALassoSelectsAndAToolFromTheMenuActsOnce) {
  Hand hand;
  hand.in.ctrl = hand.in.alt = true;
  drawnWith(hand, 0);
  ASSERT_EQ(hand.commands<command::SelectLasso>().size(), 1u);
  EXPECT_EQ(hand.commands<command::SelectLasso>()[0].op, SelectOp::Replace);
  Hand armed;
  armed.machine.armed = Stroke::Mute;
  const auto lines = drawnWith(armed, 0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].kind, Stroke::Mute);
  EXPECT_FALSE(armed.machine.armed);
  armed.machine.armed = Stroke::Cut;
  armed.in.cancel = true;
  armed.frame({0, 0});
  EXPECT_FALSE(armed.machine.armed) << "Esc puts the tool away";
}

TEST(Interaction, FramesMoveWithTheirContentAndResizeAtTheirSides) {
  Hit header;
  header.kind = Hit::Kind::Frame;
  header.frame = 1;
  Hand hand;
  hand.in.pressed[0] = true;
  hand.frame({0, 0}, header);
  hand.frame({20, 10}, header);
  hand.frame({25, 10}, header);
  hand.in.released[0] = true;
  hand.frame({25, 10}, header);
  vec2 sum(0);
  for (const command::FrameDrag& d : hand.commands<command::FrameDrag>()) {
    sum += d.by;
    EXPECT_TRUE(d.content);
    EXPECT_FALSE(d.sides.any());
  }
  EXPECT_EQ(sum, vec2(25, 10));
  EXPECT_EQ(hand.commands<command::FrameDone>().size(), 1u);
  EXPECT_EQ(hand.commands<command::SelectFrame>().size(), 1u);

  Hand alone;
  alone.in.ctrl = true;
  alone.in.pressed[0] = true;
  alone.frame({0, 0}, header);
  alone.frame({20, 0}, header);
  ASSERT_EQ(alone.commands<command::FrameDrag>().size(), 1u);
  EXPECT_FALSE(alone.commands<command::FrameDrag>()[0].content);
  alone.in.cancel = true;
  alone.frame({20, 0}, header);
  EXPECT_EQ(alone.commands<command::Cancel>().size(), 1u);

  Hand corner;
  Hit side = header;
  side.sides.right = side.sides.bottom = true;
  corner.in.pressed[0] = true;
  corner.frame({0, 0}, side);
  corner.frame({20, 0}, side);
  ASSERT_EQ(corner.commands<command::FrameDrag>().size(), 1u);
  EXPECT_TRUE(corner.commands<command::FrameDrag>()[0].sides.right);

  Hand twice;
  twice.in.pressed[0] = twice.in.doubleClick = true;
  twice.frame({0, 0}, header);
  EXPECT_EQ(twice.commands<command::RenameFrame>().size(), 1u);
}

TEST(Interaction, NothingStartsWhereThePointerIsNotOverTheCanvas) {
  Hand hand;
  hand.in.over = false;
  hand.in.wheel = 1;
  hand.in.pressed[0] = hand.in.pressed[1] = hand.in.pressed[2] = true;
  EXPECT_TRUE(hand.frame({0, 0}, onNode("Sun")).empty());
  EXPECT_EQ(hand.machine.state, State::Idle);
}

}  // namespace
}  // namespace pileus::editor
