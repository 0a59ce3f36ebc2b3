#pragma once
// What a gesture under way shows on the canvas: the loose link, the box, the line and what it would do.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct Session;
struct Ui;

/// Is this link in the hand, so that it is not drawn in its place?
bool isPickedUp(const LinkDrag& drag, const nodes::Link& link);
void drawDragFeedback(Ui& ui, const Session& session, const Canvas& canvas, const CanvasView& view,
                      const Layout& layout, const Hit& hit);

}  // namespace pileus::editor
