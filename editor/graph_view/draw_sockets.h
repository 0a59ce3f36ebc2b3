#pragma once
// Draws the sockets of a node with their labels and values.
#include "editor/graph_view/draw_node.h"

namespace pileus::editor {

struct Theme;

void drawSockets(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look);

}  // namespace pileus::editor
