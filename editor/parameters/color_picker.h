#pragma once
// The popup of a colour parameter: a wheel of hue and saturation, intensity, channels and temperature in the
// working space; recent colours; an eyedropper for the viewport's picture. All swatches go through the
// viewport's display transform.
#include <imgui.h>

#include <vector>

#include "editor/parameters/param_edit.h"
#include "editor/toolkit/hsv.h"

namespace pileus::editor {

struct Parameters;
struct Shown;
struct Theme;
struct Ui;

struct ColorPicker {
  Hsv hsv;          ///< of the colour last shown: keeps the hue of greys
  dvec3 before{0};  ///< the colour when the popup opened
  double kelvin = 6500;
  std::string key;  ///< "Node.param" it belongs to
  bool open = false;
  std::vector<ImU32> wheel;    ///< display colours of the wheel's vertices
  unsigned wheelRevision = 0;  ///< of the display colours they were made with
  std::vector<dvec3> recent;   ///< newest first
};

/// What the popup changed.
struct ColorEdit {
  bool changed = false, dragging = false, finished = false, cancelled = false, eyedropper = false;
};

/// The swatch, `size` large; true if clicked.
bool colorSwatch(const Theme& theme, Shown& shown, Parameters& parameters, const char* id, const dvec3& color,
                 ImVec2 size, bool mixed = false);
/// Inside an open ImGui popup. Channels stay within `lo` .. `hi`.
ColorEdit drawColorPicker(Ui& ui, Shown& shown, Parameters& parameters, dvec3& color, double lo, double hi);
/// Once, when the popup has closed: the colour becomes a recent one.
void closeColorPicker(ColorPicker& picker, const dvec3& color);

}  // namespace pileus::editor
