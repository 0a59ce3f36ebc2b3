#pragma once
// The graph canvas: what it remembers, and drawing it with its pointer handling. Its commands (delete, copy,
// ...) are in canvas_commands.h.
#include <imgui.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/graph_view/canvas_overlays.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout_cache.h"
#include "editor/graph_view/minimap.h"
#include "editor/graph_view/move_gesture.h"
#include "editor/graph_view/search/find_nodes.h"
#include "editor/graph_view/search/node_search.h"
#include "editor/graph_view/thumbnails.h"

namespace pileus::editor {

struct CanvasView;
struct GraphRoom;
struct Theme;

/// A frame's title while it is typed.
struct FrameTitleField {
  std::size_t frame = 0;
  std::string text;
  bool opening = false;
};

/// How a scope was left.
struct ScopeMemory {
  dvec2 center{0};
  int level = -1;
  std::set<std::string> selection;
};

struct Canvas {
  Interaction interaction;
  NodeSearch search;
  FindNodes find;
  CanvasOverlays overlays;
  Minimap minimap;
  LayoutCache cache;
  ThumbnailChoice thumbnails;
  Thumbnails pictures;
  dvec2 center{0};                               ///< canvas units at the panel's middle
  int level = -1;                                ///< index into Theme::zoomLevels; -1: not chosen yet
  float zoomRest = 0;                            ///< part of a level not yet stepped
  bool frameAll = true, frameSelection = false;  ///< to be done at the next drawing
  vec2 min{0}, max{0};                           ///< the panel on the screen, last frame
  vec2 pointer{0};                               ///< canvas units under the pointer, last frame
  bool pointerInside = false;

  /// While a link is dragged: why each socket refuses it; sockets that accept are not in it.
  std::map<std::string, std::string> refusals;
  MoveGesture moving;
  std::map<std::vector<std::string>, ScopeMemory> scopes;
  std::vector<std::string> scope;            ///< shown last: undo may have changed the document's
  std::optional<std::size_t> selectedFrame;  ///< apart from nodes, as links
  std::optional<FrameTitleField> frameTitle;
  Hit menuHit;     ///< what the context menu is about
  vec2 menuAt{0};  ///< screen pixels
  bool menuOpening = false;
  dvec2 pastedAt{0};  ///< where the last paste was asked for
  int pastes = 0;     ///< in that place
};

/// Key of a socket in Canvas::refusals.
std::string socketKey(std::string_view node, std::string_view socket, bool input);

/// The canvas as it is on the screen.
CanvasView canvasView(const Theme& theme, const Canvas& canvas, ImDrawList* draw = nullptr);

void drawCanvas(const GraphRoom& room, ImVec2 min, ImVec2 max, bool hovered);

}  // namespace pileus::editor
