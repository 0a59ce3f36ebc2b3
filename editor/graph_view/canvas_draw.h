#pragma once
// Draws what the canvas shows: grid, links, nodes, and words where there is nothing to show.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Editor;

void drawGrid(const Theme& theme, const CanvasView& view);
void drawLinks(Editor& editor, const CanvasView& view, const Layout& layout, const Hit& hit);
void drawNodes(Editor& editor, const CanvasView& view, const Layout& layout, const Hit& hit);
/// What to do on an empty canvas.
void drawHints(const Editor& editor, const CanvasView& view);
/// What is wrong with the node under the resting pointer, or what its socket takes.
void drawCanvasTooltip(Editor& editor, const Layout& layout, const Hit& hit, bool hovered);

}  // namespace pileus::editor
