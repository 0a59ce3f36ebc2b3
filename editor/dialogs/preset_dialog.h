#pragma once
// Asks for a preset's name, sentence, tags and folder. Enter keeps it, Esc gives it up.
namespace pileus::editor {

struct Editor;
void drawPresetDialog(Editor& editor);

}  // namespace pileus::editor
