#pragma once
// Opening, saving and exporting documents, with the questions that go with them. Each may return before it is
// done (a dialog is open).
#include <filesystem>
#include <functional>
#include <string>

namespace pileus::editor {

struct Editor;
struct Lost;  // recovery.h

/// Runs `then` at once, or after the user chose to save or discard unsaved changes.
void withSavedDocument(Editor& editor, std::function<void()> then);

/// Ends the program, after questions about unsaved changes and a picture that is being exported.
void quit(Editor& editor);
void newDocument(Editor& editor);
void askOpen(Editor& editor);
/// Loads at once; what the file's faults are is shown, and a file that cannot be read leaves the document as
/// it is. False: not loaded.
bool openFile(Editor& editor, const std::filesystem::path& path);
/// The graph that another file carries (a still): opens as an unnamed document. `from`: that file, where its
/// relative paths start.
bool openText(Editor& editor, const std::string& text, const std::filesystem::path& from);
/// Unsaved work of an earlier session: the document as it was last saved, with the work as one step upon it.
bool openLost(Editor& editor, const Lost& lost);
/// A preset that is part of the program ("default.json"): opens as an unnamed document.
bool openPreset(Editor& editor, const std::string& name);
/// The text of a preset of one's own opens the same way; its relative paths start beside `from`.
bool openPresetText(Editor& editor, const std::string& text, const std::filesystem::path& from);
/// To its file, or asks for one. `then` runs after a successful save.
void save(Editor& editor, std::function<void()> then = {});
void saveAs(Editor& editor, std::function<void()> then = {});
/// "shot_v001.json" goes on as "shot_v002.json", or the next number that is free.
void saveNextVersion(Editor& editor);
void askExport(Editor& editor);

}  // namespace pileus::editor
