#pragma once
// The window's layout: menu bar, viewport over graph, parameters at the right, log, status line; with
// splitters between them.
namespace pileus::editor {

struct Editor;

/// Everything of one frame but the dialogs; sets Editor::hovered.
void drawPanels(Editor& editor);

}  // namespace pileus::editor
