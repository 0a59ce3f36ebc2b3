#pragma once
// Draws the frames of the canvas: tinted rectangles behind everything, titles that stay readable from afar.
#include "editor/graph_view/canvas_view.h"

namespace pileus::nodes {
struct Frame;
}

namespace pileus::editor {

struct Canvas;
struct Session;
struct Theme;
struct Ui;

/// A frame's own colour, or a quiet one.
ImU32 frameTint(const nodes::Frame& frame);
void drawFrames(Ui& ui, const Session& session, const Canvas& canvas, const CanvasView& view);
/// Where the canvas shows no text: titles over the nodes.
void drawDistantTitles(const Theme& theme, const Session& session, const Canvas& canvas,
                       const CanvasView& view);

}  // namespace pileus::editor
