#pragma once
// The whole graph in a corner of the canvas: the shown part is a rectangle that can be dragged, a click goes
// there. Not shown where all nodes are in view or the panel is small, nor over nodes that are selected.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct Session;
struct Settings;
struct Theme;
struct Ui;

struct Minimap {
  bool dragging = false;
  vec2 grip{0};  ///< canvas units from the pressed place to the view's middle
};

/// Follows the pointer; true: it is over the map, which has it.
bool updateMinimap(const Theme& theme, const Session& session, Settings& settings, Canvas& canvas,
                   const CanvasView& view, const Layout& layout, bool hovered);
void drawMinimap(Ui& ui, const Session& session, const Settings& settings, const Canvas& canvas,
                 const CanvasView& view, const Layout& layout);

}  // namespace pileus::editor
