#pragma once
// Every key and mouse gesture by panel: the table of commands, and beside it what the pointer does. The
// shortcut sheet and docs/keyboard.md are made of this.
#include <string>
#include <vector>

namespace pileus::editor {

struct KeyRow {
  std::string what, keys;
};
struct KeySection {
  std::string title;
  std::vector<KeyRow> rows;
};

/// Rows of one meaning with ten numbers ("View Slot 1" to "9") become one.
std::vector<KeySection> keyboardMap();
/// docs/keyboard.md.
std::string keyboardMarkdown();
/// For a terminal.
std::string keyboardText();

}  // namespace pileus::editor
