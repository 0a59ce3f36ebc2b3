#pragma once
// Draws what the canvas shows: grid, links, nodes, and words where there is nothing to show.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct GraphRoom;
struct Session;
struct Shown;
struct Theme;
struct Ui;

void drawGrid(const Theme& theme, const CanvasView& view);
void drawLinks(const Theme& theme, const Session& session, const Canvas& canvas, const CanvasView& view,
               const Layout& layout, const Hit& hit);
void drawNodes(const GraphRoom& room, const CanvasView& view, const Layout& layout, const Hit& hit);
/// What to do on an empty canvas.
void drawHints(const Theme& theme, const Session& session, const Canvas& canvas, const CanvasView& view);
/// What is wrong with the node under the resting pointer, or what its socket takes.
void drawCanvasTooltip(Ui& ui, const Session& session, const Shown& shown, const Canvas& canvas,
                       const Layout& layout, const Hit& hit, bool hovered);

}  // namespace pileus::editor
