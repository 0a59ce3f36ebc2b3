#pragma once
// What lies over the canvas and takes the pointer from it: the map, the path of groups, and the badges of
// nodes that wait for another one.
#include <string>

#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct GraphRoom;
struct Session;
struct Settings;
struct Ui;

struct CanvasOverlays {
  bool covered = false;  ///< the pointer is over one of them
  std::string follower;  ///< the node whose badge is under the pointer
  int crumb = -1;        ///< the group of the path under the pointer; 0 = the document
};

/// Before the canvas looks at the pointer; true: it has nothing to look at.
bool updateOverlays(const GraphRoom& room, const CanvasView& view, const Layout& layout, bool hovered);
void drawOverlays(Ui& ui, const Session& session, const Settings& settings, const Canvas& canvas,
                  const CanvasView& view, const Layout& layout);

}  // namespace pileus::editor
