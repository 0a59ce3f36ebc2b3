#pragma once
// Carries out what the canvas's state machine decides, and the graph actions of menus and keys.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout.h"

namespace pileus::editor {

struct Editor;

void carryOut(Editor& editor, const CanvasView& view, const Layout& layout, const Command& command);
/// The context menu of a node or link; once a frame.
void drawCanvasMenu(Editor& editor);

// Actions on the selection.
void deleteSelection(Editor& editor);  ///< or the selected link
void duplicateSelection(Editor& editor);
void copySelection(Editor& editor);
void cutSelection(Editor& editor);
void pasteNodes(Editor& editor);
void bypassSelection(Editor& editor);
void selectAllNodes(Editor& editor);
void searchNode(Editor& editor);  ///< at the pointer, or the middle of the canvas

}  // namespace pileus::editor
