#pragma once
// The window's panels: which there are, how one is hidden, brought back or given the whole window, and
// everything that is drawn of them in a frame.
#include <imgui.h>

#include <span>

#include "editor/app/editor.h"

namespace pileus::editor {

struct PanelInfo {
  Panel panel;
  const char* id;     ///< "graph": of its window and in traces
  const char* title;  ///< "Graph"
  bool PanelLayout::*shown;
  float bar;    ///< design pixels of its own bar at the top; 0: it has none
  float inset;  ///< design pixels that the bar keeps for a button of its own at the right
  void (*draw)(Editor&, ImVec2 min, ImVec2 max, bool hovered);
};

std::span<const PanelInfo> allPanels();
const PanelInfo& panelInfo(Panel panel);

bool panelOpen(const Editor& editor, Panel panel);
/// Viewport and graph are never both hidden: the other one comes back.
void setPanelOpen(Editor& editor, Panel panel, bool open);
/// Gives the panel the whole window, or gives it back.
void toggleMaximised(Editor& editor, Panel panel);
/// Opens the panel where it cannot be seen, so that a command of it has an effect one sees.
void revealPanel(Editor& editor, Panel panel);
/// A layout of the user's or a built-in one; unknown names do nothing.
void useLayout(Editor& editor, std::string_view name);

/// Everything of one frame but the dialogs; sets Editor::hovered.
void drawPanels(Editor& editor);

}  // namespace pileus::editor
