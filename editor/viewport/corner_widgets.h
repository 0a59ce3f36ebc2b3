#pragma once
// The little controls over the picture: tools on the left, the axis cross on the right, hints below.
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

/// The corners of all that is shown, which is never nothing while a viewport is drawn: two pictures side by
/// side are wider than one.
Viewport::Rect shownCorners(const Viewport& viewport);
/// Each sets tools.overWidget where the pointer is over it.
void drawToolStrip(Editor& editor, vec2 min, vec2 max, bool hovered);
void drawAxisCross(Editor& editor, const Projection& view, bool hovered);
/// What they take of the picture's corners: pixels from the left edge, from the upper edge; 0 where they are
/// not shown.
float toolStripWidth(const Editor& editor, vec2 min, vec2 max);
float axisCrossHeight(const Editor& editor, vec2 min, vec2 max);
void drawToolHints(Editor& editor, vec2 min, vec2 max, bool hovered);

}  // namespace pileus::editor
