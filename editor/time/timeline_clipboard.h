#pragma once
// Keys of the timeline through the system's clipboard, as JSON text.
namespace pileus::editor {

struct Editor;

void copySelectedKeys(Editor& editor);
void cutSelectedKeys(Editor& editor);
/// The earliest key goes to the current frame; the pasted keys are selected. One undo step.
void pasteKeys(Editor& editor);

}  // namespace pileus::editor
