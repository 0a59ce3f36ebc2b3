#pragma once
// The sheet of keys and gestures, searchable: a dialog.
#include <string>
#include <vector>

#include "editor/commands/keyboard.h"

namespace pileus::editor {

struct Editor;

struct ShortcutSheet {
  std::string words;
  std::vector<KeySection> map;  ///< made when it opens
};

/// The dialog's content, between its heading and its buttons.
void drawShortcutSheet(Editor& editor);

}  // namespace pileus::editor
