#pragma once
// The panels of the window: one row each.
#include <span>

#include "editor/exchange/panel.h"
#include "editor/preferences/panel_layout.h"

namespace pileus::editor {

struct PanelInfo {
  Panel panel;
  const char* id;     ///< "graph": of its window and in traces
  const char* title;  ///< "Graph"
  bool PanelLayout::*shown;
  float bar;    ///< design pixels of its own bar at the top; 0: it has none
  float inset;  ///< design pixels that the bar keeps for a button of its own at the right
};

std::span<const PanelInfo> allPanels();
const PanelInfo& panelInfo(Panel panel);

}  // namespace pileus::editor
