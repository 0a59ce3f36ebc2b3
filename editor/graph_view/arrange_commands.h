#pragma once
// Tidying the selected nodes, each as one step of undo.
#include "editor/graph_view/layout/arrange.h"

namespace pileus::editor {

struct GraphRoom;

void arrangeNodes(const GraphRoom& room);  ///< all of them where none is selected
void alignNodes(const GraphRoom& room, Align how);
void distributeNodes(const GraphRoom& room, bool horizontal);

}  // namespace pileus::editor
