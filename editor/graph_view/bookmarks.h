#pragma once
// Places of the graph canvas to come back to, nine for each file. Part of the settings, never of a document
// or its undo.
#include <string>

namespace pileus::editor {

struct Canvas;
struct Session;
struct Settings;
struct Ui;

/// `number` from 1.
void saveBookmark(Ui& ui, const Session& session, Settings& settings, const Canvas& canvas, int number);
void goToBookmark(Ui& ui, Session& session, const Settings& settings, Canvas& canvas, int number);
bool hasBookmark(const Session& session, const Settings& settings, int number);
/// The document has another path now: its bookmarks come along.
void bookmarksFollow(Settings& settings, const std::string& from, const std::string& to);

}  // namespace pileus::editor
