#include "editor/graph_view/bookmarks.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/scopes.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kFiles = 50;  // the least recently marked are forgotten

const FileBookmarks* bookmarksOf(const Settings& settings, const std::string& path) {
  for (const FileBookmarks& f : settings.bookmarks)
    if (f.path == path) return &f;
  return nullptr;
}

/// Moved to the front.
FileBookmarks& touched(Settings& settings, const std::string& path) {
  std::vector<FileBookmarks>& all = settings.bookmarks;
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

const std::optional<CanvasPlace>& placeOf(const Session& session, const Settings& settings, int number) {
  static const std::optional<CanvasPlace> none;
  const FileBookmarks* ours = bookmarksOf(settings, session.document.path().string());
  return ours ? ours->places.at(static_cast<std::size_t>(number - 1)) : none;
}

}  // namespace

void saveBookmark(Ui& ui, const Session& session, Settings& settings, const Canvas& canvas, int number) {
  touched(settings, session.document.path().string()).places.at(static_cast<std::size_t>(number - 1)) =
      CanvasPlace{currentScope(session), canvas.center, canvas.level};
  ui.messages.note(fmt::format("Bookmark {} saved: Ctrl+{} comes back here", number, number));
}

void goToBookmark(Ui& ui, Session& session, const Settings& settings, Canvas& canvas, int number) {
  const std::optional<CanvasPlace> place = placeOf(session, settings, number);
  if (!place)
    return ui.messages.hint(
        fmt::format("Bookmark {} is free: Ctrl+Shift+{} saves this view.", number, number));
  if (!goToScope(session, canvas, place->scope))
    return ui.messages.hint(fmt::format("The group that bookmark {} lies in is gone.", number));
  canvas.center = place->center;
  canvas.level = std::clamp(place->level, 0, static_cast<int>(ui.theme.zoomLevels.size()) - 1);
  canvas.frameAll = canvas.frameSelection = false;
}

bool hasBookmark(const Session& session, const Settings& settings, int number) {
  return placeOf(session, settings, number).has_value();
}

void bookmarksFollow(Settings& settings, const std::string& from, const std::string& to) {
  if (from == to) return;
  if (const FileBookmarks* ours = bookmarksOf(settings, from)) {
    const auto places = ours->places;
    touched(settings, to).places = places;
  }
  if (from.empty()) std::erase_if(settings.bookmarks, [](const FileBookmarks& f) { return f.path.empty(); });
}

}  // namespace pileus::editor
