#pragma once
// The menu bar, read from the action table.
namespace pileus::editor {

struct Editor;

/// Returns its height in pixels.
float drawMenuBar(Editor& editor);

}  // namespace pileus::editor
