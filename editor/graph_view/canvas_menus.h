#pragma once
// The context menus of nodes, links, frames and the canvas: everything keys and gestures do, by mouse alone.
#include "editor/graph_view/interaction.h"

namespace pileus::editor {

struct Canvas;
struct GraphRoom;

/// At a screen position, in this frame or the next.
void openCanvasMenu(Canvas& canvas, const Hit& hit, vec2 at);
/// Once a frame, after the canvas.
void drawCanvasMenu(const GraphRoom& room);

}  // namespace pileus::editor
