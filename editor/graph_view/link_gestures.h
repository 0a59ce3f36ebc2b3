#pragma once
// Dragging links and drawing lines across them.
#include <string>
#include <vector>

#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct Session;
struct Ui;

void startLink(Session& session, Canvas& canvas, const Layout& layout, const LinkDrag& drag);
void dropLink(Ui& ui, Session& session, Canvas& canvas, const CanvasView& view,
              const command::LinkDrop& drop);
/// A dragged link over a node's body goes to the first of its sockets that takes it, free ones first. Where
/// none does, the hit stays the node.
Hit snappedToNode(const Session& session, const Canvas& canvas, const Layout& layout, const Hit& hit);
/// Why the link under way cannot be dropped here; "" = it can, or there is nothing to refuse it.
std::string refusalAt(const Canvas& canvas, const Layout& layout, const Hit& hit);

void dotOnSelectedLink(Ui& ui, Session& session);
void putDot(Ui& ui, Session& session, const nodes::Link& link, dvec2 at);
void finishStroke(Ui& ui, Session& session, const CanvasView& view, const Layout& layout,
                  const command::StrokeDone& stroke);

}  // namespace pileus::editor
