#pragma once
// Draws one node of the canvas.
#include <functional>

#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/layout/layout.h"
#include "nodes/evaluate/evaluator.h"

namespace pileus::editor {

struct Theme;

/// A node's picture: an image, or the tiles of a map side by side in one texture.
struct NodePicture {
  unsigned texture = 0;
  ivec2 size{0};  ///< of an image, or of one tile
  int tiles = 0;  ///< 0: an image
};

struct NodeLook {
  bool selected = false, hovered = false;
  bool disabled = false;
  bool viewed = false;                  ///< in the viewport, in place of the document's own view
  int slot = 0;                         ///< view slot; 0 = none
  bool found = false, unfound = false;  ///< a search is on, and this is one of its matches or is not
  bool stacked = false;                 ///< holds a graph of its own
  bool showTimes = false;
  double share = 0;  ///< of the time of all nodes
  const nodes::NodeStatus* status = nullptr;
  std::string_view source;  ///< the node whose failure this one waits for
  bool hoveredFooter = false;
  std::string_view hoveredSocket;  ///< id of the socket under the pointer, "" = none
  bool hoveredInput = false;
  /// While a link is dragged: whether it may end at this socket. Empty otherwise.
  std::function<bool(const SocketPlace&)> accepts;
  const NodePicture* picture = nullptr;  ///< where the layout has room for one
};

/// The header's colour: the node's own, else its category's.
ImU32 nodeColorOf(const NodePlace& place);
/// The user's label or the name.
std::string_view titleOf(const NodePlace& place);

void drawNode(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look);

}  // namespace pileus::editor
