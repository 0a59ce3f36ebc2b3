#pragma once
// Draws the frames of the canvas: tinted rectangles behind everything, titles that stay readable from afar.
#include "editor/graph_view/canvas_view.h"

namespace pileus::nodes {
struct Frame;
}

namespace pileus::editor {

struct Editor;

/// A frame's own colour, or a quiet one.
ImU32 frameTint(const nodes::Frame& frame);
void drawFrames(Editor& editor, const CanvasView& view);
/// Where the canvas shows no text: titles over the nodes.
void drawDistantTitles(Editor& editor, const CanvasView& view);

}  // namespace pileus::editor
