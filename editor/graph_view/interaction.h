#pragma once
// What the pointer does on the graph canvas: a state machine from pointer input to commands. No ImGui, no
// document: canvas.cpp finds the hit, feeds step() once a frame and carries the commands out.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::editor {

/// Sides of a frame that a drag moves; none = its header.
struct FrameSides {
  bool left = false, top = false, right = false, bottom = false;
  bool any() const { return left || top || right || bottom; }
  bool operator==(const FrameSides&) const = default;
};

/// What lies under the pointer.
struct Hit {
  enum class Kind { Canvas, Node, Input, Output, Link, Frame } kind = Kind::Canvas;
  std::string node, socket;          ///< Node, Input, Output
  nodes::Link link;                  ///< Link
  std::optional<nodes::Link> taken;  ///< Input that takes one link and has it
  std::vector<nodes::Link> links{};  ///< Input, Output: all of its links, in order
  std::size_t frame = 0;             ///< Frame: index into the graph's frames
  FrameSides sides{};                ///< Frame
};

struct PointerInput {
  vec2 pos{0};                             ///< screen pixels
  bool pressed[3] = {}, released[3] = {};  ///< left, right, middle: this frame's edges
  bool doubleClick = false;                ///< with pressed[0]
  bool shift = false, ctrl = false, alt = false;
  bool knife = false;   ///< the knife's key is down
  bool cancel = false;  ///< Esc, or the window lost the pointer
  float wheel = 0;
  bool over = false;  ///< the pointer is over the canvas and nothing covers it
  Hit hit;
};

/// A link being dragged from a fixed end, or several from theirs.
struct LinkDrag {
  bool fromOutput = true;               ///< the fixed end is an output
  std::string node, socket;             ///< the fixed end; of several links: the output they came from
  std::optional<nodes::Link> replaces;  ///< the link that was picked off an input
  std::vector<nodes::Link> moves{};     ///< all links of an output that look for another one
};

enum class SelectOp { Replace, Add, Remove };
/// What a freely drawn line is for: the first three act on the links it crosses.
enum class Stroke { Cut, Mute, Dots, Lasso };

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
struct SelectFrame {
  std::size_t frame = 0;
};
struct SelectNone {};
struct SelectBox {
  vec2 a{0}, b{0};
  SelectOp op = SelectOp::Replace;
};  ///< screen corners
struct SelectLasso {
  std::vector<vec2> around;
  SelectOp op = SelectOp::Replace;
};  ///< screen points
struct Move {
  vec2 by{0};
};  ///< pixels, of the selection
struct MoveDone {};
struct FrameDrag {
  std::size_t frame = 0;
  FrameSides sides;
  bool content = true;
  vec2 by{0};
};  ///< pixels
struct FrameDone {};
struct Cancel {};  ///< of a Move or FrameDrag: everything lies where it lay
struct LinkStart {
  LinkDrag drag;
};
struct LinkDrop {
  LinkDrag drag;
  Hit on;
  vec2 at{0};
};
struct PutDot {
  nodes::Link link;
  vec2 at{0};
};
struct StrokeDone {
  Stroke kind = Stroke::Cut;
  std::vector<vec2> points;
};  ///< screen points
struct View {
  std::string node;
};
struct Menu {
  Hit hit;
  vec2 at{0};
};  ///< right click on a node, link or frame; on the canvas with a modifier
struct Search {
  vec2 at{0};
};  ///< right click on nothing
struct Open {
  std::string node;
};  ///< double click
struct RenameFrame {
  std::size_t frame = 0;
};
}  // namespace command
using Command =
    std::variant<command::Pan, command::Zoom, command::SelectNode, command::SelectLink, command::SelectFrame,
                 command::SelectNone, command::SelectBox, command::SelectLasso, command::Move,
                 command::MoveDone, command::FrameDrag, command::FrameDone, command::Cancel,
                 command::LinkStart, command::LinkDrop, command::PutDot, command::StrokeDone, command::View,
                 command::Menu, command::Search, command::Open, command::RenameFrame>;

struct Interaction {
  enum class State {
    Idle,
    Panning,
    Zooming,
    PressedNode,
    MovingNodes,
    PressedFrame,
    DraggingFrame,
    PressedCanvas,
    BoxSelecting,
    DraggingLink,
    Stroking,
    PressedRight
  };
  State state = State::Idle;
  vec2 press{0}, last{0};  ///< screen pixels
  Hit pressHit;
  LinkDrag link;  ///< DraggingLink
  SelectOp boxOp = SelectOp::Replace;
  bool deferredSelect = false;  ///< a click on a selected node selects it alone, but only if it was no drag
  bool frameContent = true;     ///< DraggingFrame: what lies in it comes along
  Stroke stroke = Stroke::Cut;
  std::vector<vec2> path;       ///< Stroking: screen points so far
  std::optional<Stroke> armed;  ///< chosen from a menu for the next left drag

  bool busy() const { return state != State::Idle; }
};

/// `isSelected` tells whether the pressed node is in the selection; `dragThreshold` in pixels.
std::vector<Command> step(Interaction& machine, const PointerInput& input, bool isSelected,
                          float dragThreshold);

}  // namespace pileus::editor
