#pragma once
// Tidying the selected nodes, each as one step of undo.
#include "editor/graph_view/layout/arrange.h"

namespace pileus::editor {

struct Editor;

void arrangeNodes(Editor& editor);  ///< all of them where none is selected
void alignNodes(Editor& editor, Align how);
void distributeNodes(Editor& editor, bool horizontal);

}  // namespace pileus::editor
