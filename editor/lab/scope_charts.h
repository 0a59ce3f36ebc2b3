#pragma once
// The charts of the ray scope, one below the other.
#include "editor/lab/ray_scope.h"
#include "editor/toolkit/plot.h"

namespace pileus::editor {

struct RayScope;
struct Theme;
struct Ui;

/// Rows that share the panel's height, design pixels at 1; a chart takes its place from the top.
struct ChartSpace {
  float left = 0, right = 0;  ///< pixels of the panel's inner edges
  float y = 0;                ///< next free pixel
  float unit = 1;             ///< pixels of one share of the height that is left to charts
};

void drawTransmittance(Ui& ui, const RayScope& scope,
                       ChartSpace& space);  ///< with the volumes' bars and g below it
void drawExtinction(Ui& ui, const RayScope& scope, ChartSpace& space);
/// Coefficients to mute, or a deep map's vertices in words.
void drawCoefficients(Ui& ui, RayScope& scope, ChartSpace& space);
/// Pixels that all of it takes besides the shared height.
float chartOverhead(const Theme& theme, const RayScope& scope);

}  // namespace pileus::editor
