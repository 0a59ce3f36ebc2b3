#pragma once
// Carries out what the canvas's state machine decides, and the graph actions of menus and keys.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Editor;

void carryOut(Editor& editor, const CanvasView& view, const Layout& layout, const Command& command);

// Removing (selection_commands.cpp).
void deleteSelection(Editor& editor);     ///< or the selected link or frame
void deleteReconnecting(Editor& editor);  ///< what the nodes passed on stays linked
void extractSelection(Editor& editor);    ///< out of their links, which close behind them
// Switching.
void bypassSelection(Editor& editor);
void disableSelection(Editor& editor);
void muteSelectedLink(Editor& editor);
void colorSelection(Editor& editor, const std::string& color);  ///< "" = the category's
// Selecting.
void selectAllNodes(Editor& editor);
void selectUpstream(Editor& editor);
void selectDownstream(Editor& editor);

// Clipboard and copies (clipboard_commands.cpp).
void copySelection(Editor& editor);
void cutSelection(Editor& editor);
void pasteNodes(Editor& editor);
void duplicateSelection(Editor& editor);
void duplicateWithInputs(Editor& editor);

void searchNode(Editor& editor);  ///< at the pointer, or the middle of the canvas

}  // namespace pileus::editor
