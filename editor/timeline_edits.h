#pragma once
// Edits of the keys on the timeline, each one undo step.
#include "nodes/animation.h"

namespace pileus::editor {

struct Editor;

void deleteSelectedKeys(Editor& editor);
void interpolateSelectedKeys(Editor& editor, nodes::Interpolation interpolation);
/// A key on every row shown, at the current frame, with the value it has there.
void keyShownRows(Editor& editor);
void selectAllKeys(Editor& editor);

/// A drag of the selected keys: begin, then where it is now, then the end.
void beginKeyMove(Editor& editor);
void moveSelectedKeys(Editor& editor, double frames);
void endKeyMove(Editor& editor);

}  // namespace pileus::editor
