#pragma once
// What lies under a point of the canvas.
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

/// `at` in canvas units; `zoom` in design pixels per canvas unit, so that the reach around sockets and links
/// stays the same on the screen. A socket's label belongs to it. While a link is dragged links are no target
/// and sockets reach farther.
Hit hitTest(const Layout& layout, const nodes::Graph& graph, vec2 at, float zoom, const Interaction& machine);

/// Nodes that touch the rectangle.
std::set<std::string> nodesInside(const Layout& layout, vec2 a, vec2 b);

}  // namespace pileus::editor
