#pragma once
// Edits of the keys on the timeline, each one undo step.
#include <string>

#include "nodes/graph/animation.h"

namespace pileus::editor {

struct Editor;

/// "key" or "3 keys".
std::string keysText(std::size_t count);

void deleteSelectedKeys(Editor& editor);
void deleteSelectedKeys(Editor& editor, const std::string& label);  ///< of the undo step
void interpolateSelectedKeys(Editor& editor, nodes::Interpolation interpolation);
/// A key on every row shown, at the current frame, with the value it has there.
void keyShownRows(Editor& editor);
void selectAllKeys(Editor& editor);

/// A drag of the selected keys: begin, then where it is now, then the end.
void beginKeyMove(Editor& editor);
void moveSelectedKeys(Editor& editor, double frames);
void endKeyMove(Editor& editor);

}  // namespace pileus::editor
