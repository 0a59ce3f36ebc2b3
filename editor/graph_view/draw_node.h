#pragma once
// Draws one node of the canvas.
#include <functional>

#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/layout.h"
#include "nodes/evaluator.h"

namespace pileus::editor {

struct NodeLook {
  bool selected = false, hovered = false;
  bool showTimes = false;
  const nodes::NodeStatus* status = nullptr;
  std::string_view hoveredSocket;  ///< id of the socket under the pointer, "" = none
  bool hoveredInput = false;
  /// While a link is dragged: whether it may end at this socket. Empty otherwise.
  std::function<bool(const SocketPlace&)> accepts;
  std::function<bool(const SocketPlace&)> linked;
};

void drawNode(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look);

/// Height in canvas units of what hangs below the node (its error or warning line); 0 = nothing.
float footerHeight(const nodes::NodeStatus& status);

}  // namespace pileus::editor
