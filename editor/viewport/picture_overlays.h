#pragma once
// What is drawn over the picture to read it by: histogram, false-colour legend, figures of the renderer.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Settings;
struct Shown;
struct Ui;
struct ViewportRoom;

void drawHistogram(Ui& ui, const Shown& shown, vec2 lo, vec2 hi);
/// The bands of exposure with their stops, along the panel's right edge, above the histogram or beside it.
/// lo, hi: of the picture.
void drawBandLegend(Ui& ui, const Shown& shown, const Settings& settings, vec2 lo, vec2 hi, float right);
/// `below`: where its first line may begin.
void drawHud(const ViewportRoom& room, vec2 lo, vec2 hi, float below);

}  // namespace pileus::editor
