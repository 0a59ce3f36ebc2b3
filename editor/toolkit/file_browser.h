#pragma once
// A file dialog inside the window: folders and files of some kinds with size and date, sequences as one row,
// recent folders and bookmarks, a filter, a typed path; asks before a file is replaced. All of it works with
// the keyboard: arrows choose, Enter opens, Alt+Up goes to the folder above, Tab completes.
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "editor/toolkit/file_listing.h"

namespace pileus::editor {

struct KeyPress;
struct Settings;
struct Ui;

struct BrowserRequest {
  std::string title, button;        ///< "Open graph", "Open"
  std::vector<std::string> kinds;   ///< endings without the dot; empty = all files
  bool saving = false;              ///< a new name may be typed; an existing file is asked about
  bool folder = false;              ///< the folder that is listed is chosen, not a file in it
  bool sequences = false;           ///< a row of numbered files gives its pattern, else its first file
  std::filesystem::path start;      ///< folder, or file to preselect; empty = where this kind was last used
  std::filesystem::path otherwise;  ///< folder, where this kind was not used yet; empty = last folder used
  std::string name;                 ///< offered, where `start` names no file
  std::function<void(const std::filesystem::path&)> done;
};

class FileBrowser {
 public:
  void open(const Settings& settings, BrowserRequest request);
  /// Once a frame. `keys`: of this frame; `document`: the document's folder, "" = it has none.
  void draw(Ui& ui, Settings& settings, std::span<const KeyPress> keys,
            const std::filesystem::path& document);
  bool isOpen() const { return open_; }

 private:
  void enter(const std::filesystem::path& folder);
  void refresh();  ///< reads the folder
  void arrange();  ///< what is listed of it, in order
  void select(int row);
  void handleKeys();
  void drawTop(Ui& ui, Settings& settings);
  void drawPlaces(Ui& ui, Settings& settings, const std::filesystem::path& document);
  void drawEntries(Ui& ui);
  void drawRow(Ui& ui, int row, float width);
  void drawBottom(Ui& ui);
  void drawNewFolder(Ui& ui);
  void drawNotice(Ui& ui, Settings& settings);
  void drawName(Ui& ui);
  std::filesystem::path typedPath() const;
  void choose(Ui& ui, Settings& settings);
  void finish(Ui& ui, Settings& settings, const std::filesystem::path& path);

  BrowserRequest request_;
  bool open_ = false, askReplace_ = false, focusName_ = false, focusFilter_ = false;
  bool showAll_ = false, scrollToRow_ = false, go_ = false, here_ = false;
  FileOrder order_ = FileOrder::Name;
  bool descending_ = false;
  std::filesystem::path folder_, replacing_;
  std::vector<FileEntry> all_, entries_;  ///< of the folder; listed
  int row_ = -1;                          ///< chosen in entries_
  std::string name_, filter_, error_;
  std::optional<std::string> newFolder_;  ///< its name while that is typed
};

}  // namespace pileus::editor
