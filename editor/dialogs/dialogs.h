#pragma once
// Modal questions and notices: unsaved changes, faults of a loaded file, the shortcut sheet, about.
namespace pileus::editor {

struct Editor;

/// Those that are open (toolkit/modals.h).
void drawDialogs(Editor& editor);

}  // namespace pileus::editor
