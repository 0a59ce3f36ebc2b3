#pragma once
// Places of the graph canvas to come back to, nine for each file. Part of the settings, never of a document
// or its undo.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::editor {

struct Editor;

struct CanvasPlace {
  std::vector<std::string> scope;  ///< groups from the outermost in; empty: the document itself
  dvec2 center{0};                 ///< canvas units
  int level = 0;                   ///< of zoom
  bool operator==(const CanvasPlace&) const = default;
};

struct FileBookmarks {
  std::string path;  ///< of the document; "" = not saved yet, forgotten with it
  std::array<std::optional<CanvasPlace>, 9> places;
  bool operator==(const FileBookmarks&) const = default;
};

/// `number` from 1.
void saveBookmark(Editor& editor, int number);
void goToBookmark(Editor& editor, int number);
bool hasBookmark(const Editor& editor, int number);
/// The document has another path now: its bookmarks come along.
void bookmarksFollow(Editor& editor, const std::string& from, const std::string& to);

}  // namespace pileus::editor
