#pragma once
// What the pointer does on the graph canvas: a state machine from pointer input to commands. No ImGui, no
// document: canvas.cpp finds the hit, feeds step() once a frame and carries the commands out.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nodes/graph.h"

namespace pileus::editor {

/// What lies under the pointer.
struct Hit {
  enum class Kind { Canvas, Node, Input, Output, Link } kind = Kind::Canvas;
  std::string node, socket;          ///< Node, Input, Output
  nodes::Link link;                  ///< Link
  std::optional<nodes::Link> taken;  ///< Input that takes one link and has it
};

struct PointerInput {
  vec2 pos{0};                             ///< screen pixels
  bool pressed[3] = {}, released[3] = {};  ///< left, right, middle: this frame's edges
  bool doubleClick = false;                ///< with pressed[0]
  bool shift = false, ctrl = false, alt = false;
  bool cancel = false;  ///< Esc, or the window lost the pointer
  float wheel = 0;
  bool over = false;  ///< the pointer is over the canvas and nothing covers it
  Hit hit;
};

/// A link being dragged from a fixed end.
struct LinkDrag {
  bool fromOutput = true;               ///< the fixed end is an output
  std::string node, socket;             ///< the fixed end
  std::optional<nodes::Link> replaces;  ///< the link that was picked off an input
};

enum class SelectOp { Replace, Add, Remove };

namespace command {
struct Pan {
  vec2 by{0};
};  ///< pixels
struct Zoom {
  float steps = 0;
  vec2 at{0};
};  ///< fractions of a wheel notch, about a screen point
struct SelectNode {
  std::string node;
  SelectOp op = SelectOp::Replace;
};
struct SelectLink {
  nodes::Link link;
};
struct SelectNone {};
struct SelectBox {
  vec2 a{0}, b{0};
  SelectOp op = SelectOp::Replace;
};  ///< screen corners
struct Move {
  vec2 by{0};
};  ///< pixels, of the selection
struct MoveDone {};
struct LinkStart {
  LinkDrag drag;
};
struct LinkDrop {
  LinkDrag drag;
  Hit on;
  vec2 at{0};
};
struct Menu {
  Hit hit;
  vec2 at{0};
};  ///< right click on a node or link
struct Search {
  vec2 at{0};
};  ///< right click on nothing
struct Open {
  std::string node;
};  ///< double click
}  // namespace command
using Command =
    std::variant<command::Pan, command::Zoom, command::SelectNode, command::SelectLink, command::SelectNone,
                 command::SelectBox, command::Move, command::MoveDone, command::LinkStart, command::LinkDrop,
                 command::Menu, command::Search, command::Open>;

struct Interaction {
  enum class State {
    Idle,
    Panning,
    Zooming,
    PressedNode,
    MovingNodes,
    PressedCanvas,
    BoxSelecting,
    DraggingLink,
    PressedRight
  };
  State state = State::Idle;
  vec2 press{0}, last{0};  ///< screen pixels
  Hit pressHit;
  LinkDrag link;  ///< DraggingLink
  SelectOp boxOp = SelectOp::Replace;
  bool deferredSelect = false;  ///< a click on a selected node selects it alone, but only if it was no drag

  bool busy() const { return state != State::Idle; }
};

/// `isSelected` tells whether the pressed node is in the selection; `dragThreshold` in pixels.
std::vector<Command> step(Interaction& machine, const PointerInput& input, bool isSelected,
                          float dragThreshold);

}  // namespace pileus::editor
