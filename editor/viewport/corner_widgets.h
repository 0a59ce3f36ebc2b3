#pragma once
// The little controls over the picture: tools on the left, the axis cross on the right, hints below.
#include "editor/picture/shown.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

struct Settings;
struct Shown;
struct Theme;
struct Ui;
struct Viewport;
struct ViewportRoom;

/// The corners of all that is shown, which is never nothing while a viewport is drawn: two pictures side by
/// side are wider than one.
ScreenRect shownCorners(const Shown& shown);
/// Each sets tools.overWidget where the pointer is over it.
void drawToolStrip(Ui& ui, Settings& settings, Viewport& viewport, vec2 min, vec2 max, bool hovered);
void drawAxisCross(const ViewportRoom& room, const Projection& view, bool hovered);
/// What they take of the picture's corners: pixels from the left edge, from the upper edge; 0 where they are
/// not shown.
float toolStripWidth(const Theme& theme, vec2 min, vec2 max);
float axisCrossHeight(const Theme& theme, const Shown& shown, const Settings& settings, vec2 min, vec2 max);
void drawToolHints(const ViewportRoom& room, vec2 min, vec2 max, bool hovered);

}  // namespace pileus::editor
