#pragma once
// Draws the links of the canvas and the one being dragged.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Theme;

struct LinkLook {
  bool selected = false, hovered = false, muted = false, dimmed = false;
};

/// Ends of a link in canvas units; false where a socket is missing.
bool linkEnds(const Layout& layout, const nodes::Link& link, vec2& from, vec2& to, nodes::SocketType& type);
void drawLink(const Theme& theme, const CanvasView& view, vec2 from, vec2 to, ImU32 color,
              const LinkLook& look);

}  // namespace pileus::editor
