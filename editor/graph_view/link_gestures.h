#pragma once
// Dragging links and drawing lines across them.
#include <string>
#include <vector>

#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Editor;

void startLink(Editor& editor, const Layout& layout, const LinkDrag& drag);
void dropLink(Editor& editor, const CanvasView& view, const command::LinkDrop& drop);
/// A dragged link over a node's body goes to the first of its sockets that takes it, free ones first. Where
/// none does, the hit stays the node.
Hit snappedToNode(const Editor& editor, const Layout& layout, const Hit& hit);
/// Why the link under way cannot be dropped here; "" = it can, or there is nothing to refuse it.
std::string refusalAt(const Editor& editor, const Layout& layout, const Hit& hit);

void dotOnSelectedLink(Editor& editor);
void putDot(Editor& editor, const nodes::Link& link, dvec2 at);
void finishStroke(Editor& editor, const CanvasView& view, const Layout& layout,
                  const command::StrokeDone& stroke);

}  // namespace pileus::editor
