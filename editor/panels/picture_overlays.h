#pragma once
// What is drawn over the picture to read it by: histogram, false-colour legend, figures of the renderer.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Editor;

void drawHistogram(Editor& editor, vec2 lo, vec2 hi);
/// The bands of exposure with their stops, along the right edge.
void drawBandLegend(Editor& editor, vec2 lo, vec2 hi);
/// `below`: where its first line may begin.
void drawHud(Editor& editor, vec2 lo, vec2 hi, float below);

}  // namespace pileus::editor
