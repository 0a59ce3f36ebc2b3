#include "editor/graph_view/interaction.h"

#include <utility>

namespace pileus::editor {
namespace {

using State = Interaction::State;
constexpr int kLeft = 0, kRight = 1, kMiddle = 2;
constexpr float kPathStep = 4;  // pixels between the points kept of a drawn line

SelectOp selectOp(const PointerInput& in) {
  return in.ctrl ? SelectOp::Remove : in.shift ? SelectOp::Add : SelectOp::Replace;
}

void begin(Interaction& m, const PointerInput& in, State state) {
  m.state = state;
  m.press = m.last = in.pos;
  m.pressHit = in.hit;
  m.path.assign(1, in.pos);
}

void beginStroke(Interaction& m, const PointerInput& in, Stroke kind) {
  begin(m, in, State::Stroking);
  m.stroke = kind;
}

LinkDrag dragFrom(const PointerInput& in) {
  const Hit& hit = in.hit;
  const bool output = hit.kind == Hit::Kind::Output;
  if (output && in.ctrl && !hit.links.empty()) return {true, hit.node, hit.socket, {}, hit.links};
  if (output) return {true, hit.node, hit.socket, {}};
  // Shift leaves the link where it is and draws another one from its source.
  if (in.shift && !hit.links.empty())
    return {true, hit.links.back().fromNode, hit.links.back().fromSocket, {}};
  if (hit.taken) return {true, hit.taken->fromNode, hit.taken->fromSocket, hit.taken};
  return {false, hit.node, hit.socket, {}};
}

void pressFrame(Interaction& m, const PointerInput& in, std::vector<Command>& out) {
  if (in.doubleClick && !in.hit.sides.any()) return out.push_back(command::RenameFrame{in.hit.frame});
  begin(m, in, State::PressedFrame);
  m.frameContent = !in.ctrl;
  out.push_back(command::SelectFrame{in.hit.frame});
}

void pressNode(Interaction& m, const PointerInput& in, bool isSelected, std::vector<Command>& out) {
  if (in.ctrl && in.shift) return out.push_back(command::View{in.hit.node});
  begin(m, in, State::PressedNode);
  m.deferredSelect = isSelected && selectOp(in) == SelectOp::Replace;
  if (!m.deferredSelect) out.push_back(command::SelectNode{in.hit.node, selectOp(in)});
  if (in.doubleClick) {
    m.state = State::Idle;  // what opens takes the pointer
    out.push_back(command::Open{in.hit.node});
  }
}

void pressLeft(Interaction& m, const PointerInput& in, bool isSelected, std::vector<Command>& out) {
  if (in.knife) return beginStroke(m, in, Stroke::Cut);
  if (m.armed || (in.ctrl && in.alt)) {
    m.boxOp = in.shift ? SelectOp::Add : SelectOp::Replace;
    return beginStroke(m, in, std::exchange(m.armed, std::nullopt).value_or(Stroke::Lasso));
  }
  if (in.alt) return begin(m, in, State::Panning);
  switch (in.hit.kind) {
    case Hit::Kind::Input:
    case Hit::Kind::Output:
      begin(m, in, State::DraggingLink);
      m.link = dragFrom(in);
      out.push_back(command::LinkStart{m.link});
      break;
    case Hit::Kind::Node:
      pressNode(m, in, isSelected, out);
      break;
    case Hit::Kind::Link:
      if (in.ctrl)
        out.push_back(command::PutDot{in.hit.link, in.pos});
      else
        out.push_back(command::SelectLink{in.hit.link});
      break;
    case Hit::Kind::Frame:
      pressFrame(m, in, out);
      break;
    case Hit::Kind::Canvas:
      begin(m, in, State::PressedCanvas);
      m.boxOp = selectOp(in);
      break;
  }
}

void pressRight(Interaction& m, const PointerInput& in) {
  if (in.ctrl) return beginStroke(m, in, in.alt ? Stroke::Mute : Stroke::Cut);
  if (in.shift) return beginStroke(m, in, Stroke::Dots);
  begin(m, in, in.alt ? State::Zooming : State::PressedRight);
}

void startIdle(Interaction& m, const PointerInput& in, bool isSelected, std::vector<Command>& out) {
  if (in.cancel || in.pressed[kRight]) m.armed.reset();
  if (!in.over) return;
  if (in.wheel != 0) out.push_back(command::Zoom{in.wheel, in.pos});
  if (in.pressed[kMiddle])
    begin(m, in, State::Panning);
  else if (in.pressed[kRight])
    pressRight(m, in);
  else if (in.pressed[kLeft])
    pressLeft(m, in, isSelected, out);
}

bool anyReleased(const PointerInput& in) {
  return in.released[kLeft] || in.released[kRight] || in.released[kMiddle];
}

void moveNodes(Interaction& m, const PointerInput& in, vec2 moved, bool dragged, std::vector<Command>& out) {
  if (m.state == State::PressedNode && dragged && !in.cancel) {
    m.state = State::MovingNodes;
    out.push_back(command::Move{in.pos - m.press});
  } else if (m.state == State::MovingNodes && moved != vec2(0) && !in.cancel) {
    out.push_back(command::Move{moved});
  }
  if (!in.released[kLeft] && !in.cancel) return;
  if (m.state == State::MovingNodes)
    out.push_back(in.cancel ? Command(command::Cancel{}) : Command(command::MoveDone{}));
  else if (m.deferredSelect && !in.cancel)
    out.push_back(command::SelectNode{m.pressHit.node, SelectOp::Replace});
  m.state = State::Idle;
}

void dragFrame(Interaction& m, const PointerInput& in, vec2 moved, bool dragged, std::vector<Command>& out) {
  const auto drag = [&](vec2 by) {
    out.push_back(command::FrameDrag{m.pressHit.frame, m.pressHit.sides, m.frameContent, by});
  };
  if (m.state == State::PressedFrame && dragged && !in.cancel) {
    m.state = State::DraggingFrame;
    drag(in.pos - m.press);
  } else if (m.state == State::DraggingFrame && moved != vec2(0) && !in.cancel) {
    drag(moved);
  }
  if (!in.released[kLeft] && !in.cancel) return;
  if (m.state == State::DraggingFrame)
    out.push_back(in.cancel ? Command(command::Cancel{}) : Command(command::FrameDone{}));
  m.state = State::Idle;
}

void dragLink(Interaction& m, const PointerInput& in, bool dragged, std::vector<Command>& out) {
  if (in.wheel != 0 && in.over) out.push_back(command::Zoom{in.wheel, in.pos});
  if (in.released[kLeft] && !in.cancel) {
    // A mere click on a socket is no drag: nothing is dropped where the pointer stands.
    if (dragged) out.push_back(command::LinkDrop{m.link, in.hit, in.pos});
    m.state = State::Idle;
  } else if (in.cancel || in.pressed[kRight]) {
    m.state = State::Idle;
  }
}

void selectBox(Interaction& m, const PointerInput& in, bool dragged, std::vector<Command>& out) {
  if (m.state == State::PressedCanvas && dragged) m.state = State::BoxSelecting;
  if (!in.released[kLeft] && !in.cancel) return;
  if (m.state == State::BoxSelecting && !in.cancel)
    out.push_back(command::SelectBox{m.press, in.pos, m.boxOp});
  else if (m.boxOp == SelectOp::Replace && !in.cancel)
    out.push_back(command::SelectNone{});
  m.state = State::Idle;
}

/// A line drawn freely: around nodes or across links.
void drawPath(Interaction& m, const PointerInput& in, std::vector<Command>& out) {
  const bool done = anyReleased(in);
  if (glm::length(in.pos - m.path.back()) >= kPathStep || (done && in.pos != m.path.back()))
    m.path.push_back(in.pos);
  if (!done && !in.cancel) return;
  const bool line = m.path.size() > 1;
  if (line && !in.cancel) {
    if (m.stroke == Stroke::Lasso)
      out.push_back(command::SelectLasso{std::move(m.path), m.boxOp});
    else
      out.push_back(command::StrokeDone{m.stroke, std::move(m.path)});
  } else if (!in.cancel && in.released[kRight]) {
    out.push_back(command::Menu{m.pressHit, in.pos});  // a click that drew nothing
  }
  m.path.clear();
  m.state = State::Idle;
}

void releaseRight(Interaction& m, const PointerInput& in, bool dragged, std::vector<Command>& out) {
  if (!in.released[kRight] && !in.cancel) return;
  if (!dragged && !in.cancel) {
    if (m.pressHit.kind == Hit::Kind::Canvas)
      out.push_back(command::Search{in.pos});
    else
      out.push_back(command::Menu{m.pressHit, in.pos});
  }
  m.state = State::Idle;
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
    case State::MovingNodes:
      moveNodes(m, in, moved, dragged, out);
      break;
    case State::PressedFrame:
    case State::DraggingFrame:
      dragFrame(m, in, moved, dragged, out);
      break;
    case State::PressedCanvas:
    case State::BoxSelecting:
      selectBox(m, in, dragged, out);
      break;
    case State::DraggingLink:
      dragLink(m, in, dragged, out);
      break;
    case State::Stroking:
      drawPath(m, in, out);
      break;
    case State::PressedRight:
      releaseRight(m, in, dragged, out);
      break;
  }
  m.last = in.pos;
  return out;
}

}  // namespace pileus::editor
