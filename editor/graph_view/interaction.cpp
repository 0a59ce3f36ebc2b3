#include "editor/graph_view/interaction.h"

namespace pileus::editor {
namespace {

using State = Interaction::State;
constexpr int kLeft = 0, kRight = 1, kMiddle = 2;

SelectOp selectOp(const PointerInput& in) {
  return in.ctrl ? SelectOp::Remove : in.shift ? SelectOp::Add : SelectOp::Replace;
}

void begin(Interaction& m, const PointerInput& in, State state) {
  m.state = state;
  m.press = m.last = in.pos;
  m.pressHit = in.hit;
}

LinkDrag dragFrom(const Hit& hit) {
  if (hit.kind == Hit::Kind::Output) return {true, hit.node, hit.socket, {}};
  if (hit.taken) return {true, hit.taken->fromNode, hit.taken->fromSocket, hit.taken};
  return {false, hit.node, hit.socket, {}};
}

void pressLeft(Interaction& m, const PointerInput& in, bool isSelected, std::vector<Command>& out) {
  if (in.alt) return begin(m, in, State::Panning);
  switch (in.hit.kind) {
    case Hit::Kind::Input:
    case Hit::Kind::Output:
      begin(m, in, State::DraggingLink);
      m.link = dragFrom(in.hit);
      out.push_back(command::LinkStart{m.link});
      break;
    case Hit::Kind::Node:
      begin(m, in, State::PressedNode);
      m.deferredSelect = isSelected && selectOp(in) == SelectOp::Replace;
      if (!m.deferredSelect) out.push_back(command::SelectNode{in.hit.node, selectOp(in)});
      if (in.doubleClick) out.push_back(command::Open{in.hit.node});
      break;
    case Hit::Kind::Link:
      out.push_back(command::SelectLink{in.hit.link});
      break;
    case Hit::Kind::Canvas:
      begin(m, in, State::PressedCanvas);
      m.boxOp = selectOp(in);
      break;
  }
}

void startIdle(Interaction& m, const PointerInput& in, bool isSelected, std::vector<Command>& out) {
  if (!in.over) return;
  if (in.wheel != 0) out.push_back(command::Zoom{in.wheel, in.pos});
  if (in.pressed[kMiddle])
    begin(m, in, State::Panning);
  else if (in.pressed[kRight])
    begin(m, in, in.alt ? State::Zooming : State::PressedRight);
  else if (in.pressed[kLeft])
    pressLeft(m, in, isSelected, out);
}

bool anyReleased(const PointerInput& in) {
  return in.released[kLeft] || in.released[kRight] || in.released[kMiddle];
}

}  // namespace

std::vector<Command> step(Interaction& m, const PointerInput& in, bool isSelected, float dragThreshold) {
  std::vector<Command> out;
  const vec2 moved = in.pos - m.last;
  const bool dragged = glm::length(in.pos - m.press) >= dragThreshold;
  switch (m.state) {
    case State::Idle:
      startIdle(m, in, isSelected, out);
      return out;
    case State::Panning:
      if (moved != vec2(0)) out.push_back(command::Pan{moved});
      if (anyReleased(in) || in.cancel) m.state = State::Idle;
      break;
    case State::Zooming:
      if (moved != vec2(0)) out.push_back(command::Zoom{(moved.x - moved.y) / 40.0f, m.press});
      if (anyReleased(in) || in.cancel) m.state = State::Idle;
      break;
    case State::PressedNode:
      if (dragged) {
        m.state = State::MovingNodes;
        out.push_back(command::Move{in.pos - m.press});
      }
      if (in.released[kLeft] || in.cancel) {
        if (m.state == State::MovingNodes)
          out.push_back(command::MoveDone{});
        else if (m.deferredSelect && !in.cancel)
          out.push_back(command::SelectNode{m.pressHit.node, SelectOp::Replace});
        m.state = State::Idle;
      }
      break;
    case State::MovingNodes:
      if (moved != vec2(0)) out.push_back(command::Move{moved});
      if (in.released[kLeft] || in.cancel) {
        out.push_back(command::MoveDone{});
        m.state = State::Idle;
      }
      break;
    case State::PressedCanvas:
      if (dragged) m.state = State::BoxSelecting;
      if (in.released[kLeft] || in.cancel) {
        if (m.state == State::BoxSelecting && !in.cancel)
          out.push_back(command::SelectBox{m.press, in.pos, m.boxOp});
        else if (m.boxOp == SelectOp::Replace && !in.cancel)
          out.push_back(command::SelectNone{});
        m.state = State::Idle;
      }
      break;
    case State::BoxSelecting:
      if (in.released[kLeft]) out.push_back(command::SelectBox{m.press, in.pos, m.boxOp});
      if (in.released[kLeft] || in.cancel) m.state = State::Idle;
      break;
    case State::DraggingLink:
      if (in.wheel != 0 && in.over) out.push_back(command::Zoom{in.wheel, in.pos});
      if (in.released[kLeft] && !in.cancel) {
        // A mere click on a socket is no drag: nothing is dropped where the pointer stands.
        if (dragged) out.push_back(command::LinkDrop{m.link, in.hit, in.pos});
        m.state = State::Idle;
      } else if (in.cancel || in.pressed[kRight]) {
        m.state = State::Idle;
      }
      break;
    case State::PressedRight:
      if (in.released[kRight] || in.cancel) {
        if (!dragged && !in.cancel) {
          if (m.pressHit.kind == Hit::Kind::Canvas)
            out.push_back(command::Search{in.pos});
          else
            out.push_back(command::Menu{m.pressHit, in.pos});
        }
        m.state = State::Idle;
      }
      break;
  }
  m.last = in.pos;
  return out;
}

}  // namespace pileus::editor
