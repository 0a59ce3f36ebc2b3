#pragma once
// Where the panels of the window are: arithmetic only.
#include <array>
#include <vector>

#include "editor/exchange/panel.h"
#include "editor/preferences/panel_layout.h"
#include "editor/toolkit/theme.h"
#include "renderer/base/math.h"

namespace pileus::editor {

struct PanelRect {
  vec2 min{0}, max{0};
  bool empty() const { return max.x <= min.x || max.y <= min.y; }
};

/// A strip between panels and the length it changes.
struct PanelSplitter {
  const char* id;
  PanelRect strip;
  bool vertical;  ///< the strip; dragged sideways
  double PanelLayout::*length;
  double perPixel;  ///< change of the length for a pixel dragged; the sign says which side grows
};

struct PanelAreas {
  std::array<PanelRect, kPanelValues> of;  ///< by Panel; empty: not shown
  std::vector<PanelSplitter> splitters;
  const PanelRect& operator[](Panel p) const { return of[static_cast<std::size_t>(p)]; }
};

/// Divides lo..hi (pixels) among the open panels, or gives it all to `maximised` (Global: to none). Panels
/// keep a usable size as long as the window has it.
PanelAreas panelAreas(const PanelLayout& layout, Panel maximised, vec2 lo, vec2 hi, const Theme& theme);

}  // namespace pileus::editor
