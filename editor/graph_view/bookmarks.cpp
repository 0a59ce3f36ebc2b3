#include "editor/graph_view/bookmarks.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/app/editor.h"
#include "editor/graph_view/scopes.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kFiles = 50;  // the least recently marked are forgotten

const FileBookmarks* bookmarksOf(const Editor& editor, const std::string& path) {
  for (const FileBookmarks& f : editor.settings.bookmarks)
    if (f.path == path) return &f;
  return nullptr;
}

/// Moved to the front.
FileBookmarks& touched(Editor& editor, const std::string& path) {
  std::vector<FileBookmarks>& all = editor.settings.bookmarks;
  const auto it =
      std::find_if(all.begin(), all.end(), [&](const FileBookmarks& f) { return f.path == path; });
  FileBookmarks ours{path, {}};
  if (it != all.end()) {
    ours = std::move(*it);
    all.erase(it);
  }
  all.insert(all.begin(), std::move(ours));
  if (all.size() > kFiles) all.resize(kFiles);
  return all.front();
}

const std::optional<CanvasPlace>& placeOf(const Editor& editor, int number) {
  static const std::optional<CanvasPlace> none;
  const FileBookmarks* ours = bookmarksOf(editor, editor.document.path().string());
  return ours ? ours->places.at(static_cast<std::size_t>(number - 1)) : none;
}

}  // namespace

void saveBookmark(Editor& editor, int number) {
  const Canvas& canvas = editor.canvas;
  touched(editor, editor.document.path().string()).places.at(static_cast<std::size_t>(number - 1)) =
      CanvasPlace{currentScope(editor), canvas.center, canvas.level};
  editor.messages.note(fmt::format("Bookmark {} saved: Ctrl+{} comes back here", number, number));
}

void goToBookmark(Editor& editor, int number) {
  const std::optional<CanvasPlace> place = placeOf(editor, number);
  if (!place)
    return editor.messages.hint(
        fmt::format("Bookmark {} is free: Ctrl+Shift+{} saves this view.", number, number));
  if (!goToScope(editor, place->scope))
    return editor.messages.hint(fmt::format("The group that bookmark {} lies in is gone.", number));
  editor.canvas.center = place->center;
  editor.canvas.level = std::clamp(place->level, 0, static_cast<int>(editor.theme.zoomLevels.size()) - 1);
  editor.canvas.frameAll = editor.canvas.frameSelection = false;
}

bool hasBookmark(const Editor& editor, int number) { return placeOf(editor, number).has_value(); }

void bookmarksFollow(Editor& editor, const std::string& from, const std::string& to) {
  if (from == to) return;
  if (const FileBookmarks* ours = bookmarksOf(editor, from)) {
    const auto places = ours->places;
    touched(editor, to).places = places;
  }
  if (from.empty())
    std::erase_if(editor.settings.bookmarks, [](const FileBookmarks& f) { return f.path.empty(); });
}

}  // namespace pileus::editor
