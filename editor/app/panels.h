#pragma once
// Everything that is drawn of the window's panels in a frame: menu bar, panels, splitters, status line,
// notices.
namespace pileus::editor {

struct Editor;

/// All of one frame but the dialogs; sets FrameState::hovered.
void drawPanels(Editor& editor);

}  // namespace pileus::editor
