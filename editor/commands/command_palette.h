#pragma once
// Every command, preset and recent file in one list that is searched by typing.
#include <string>
#include <vector>

#include "editor/exchange/requests.h"

namespace pileus::editor {

struct Editor;

struct PaletteEntry {
  std::string label, place, keys;  ///< "Save As…", "File", "Ctrl+Shift+S"
  std::string id;                  ///< of an action; "preset:NAME", "file:PATH"
  bool enabled = true, checked = false;
  Panel panel = Panel::Global;  ///< is shown before it runs
  Request request;
};

struct CommandPalette {
  bool opening = false;  ///< asks drawCommandPalette to open it
  std::string query;
  int chosen = 0;
  bool scrollToChosen = false;
  std::vector<PaletteEntry> found;  ///< best first
  std::string foundFor = "\n";      ///< query they were found for
};

/// Best first: by the match, and those used most recently before others. An empty query lists all.
std::vector<PaletteEntry> findCommands(const Editor& editor, const std::string& query);
void drawCommandPalette(Editor& editor);

}  // namespace pileus::editor
