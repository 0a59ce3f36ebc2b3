#pragma once
// How a panel is hidden, brought back or given the whole window.
#include <string_view>

#include "editor/exchange/panel.h"

namespace pileus::editor {

struct Editor;

bool panelOpen(const Editor& editor, Panel panel);
/// Viewport and graph are never both hidden: the other one comes back.
void setPanelOpen(Editor& editor, Panel panel, bool open);
/// Gives the panel the whole window, or gives it back.
void toggleMaximised(Editor& editor, Panel panel);
/// Opens the panel where it cannot be seen, so that a command of it has an effect one sees.
void revealPanel(Editor& editor, Panel panel);
/// A layout of the user's or a built-in one; unknown names do nothing.
void useLayout(Editor& editor, std::string_view name);

}  // namespace pileus::editor
