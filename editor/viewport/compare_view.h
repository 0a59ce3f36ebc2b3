#pragma once
// The viewport's picture in compare mode: wipe, two halves or error colours, with labels, legend and figures.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Shown;
struct Ui;
struct ViewportRoom;

/// Draws into the picture's rectangle, or for halves into the whole room there is, and notes where pictures
/// are (Viewport::shown). `hovered`: the pointer may take the wipe's line.
void drawComparison(const ViewportRoom& room, vec2 lo, vec2 hi, vec2 roomMin, vec2 roomMax, bool hovered);
/// The figures and the legend, in a strip of the given place.
void drawCompareFigures(Ui& ui, const Shown& shown, vec2 lo, vec2 hi);

}  // namespace pileus::editor
