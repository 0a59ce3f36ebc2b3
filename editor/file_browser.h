#pragma once
// A file dialog inside the window: folders, the files of some kinds, recent folders, a typed name; asks
// before a file is replaced.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pileus::editor {

struct Editor;

struct BrowserRequest {
  std::string title, button;       ///< "Open graph", "Open"
  std::vector<std::string> kinds;  ///< endings without the dot; empty = all files
  bool saving = false;             ///< a new name may be typed; an existing file is asked about
  std::filesystem::path start;     ///< folder, or file to preselect; empty = last folder used
  std::function<void(const std::filesystem::path&)> done;
};

class FileBrowser {
 public:
  void open(Editor& editor, BrowserRequest request);
  void draw(Editor& editor);  ///< once a frame
  bool isOpen() const { return open_; }

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };
  void enter(const std::filesystem::path& folder);
  void refresh();
  void drawPlaces(Editor& editor);
  void drawEntries(Editor& editor);
  void choose(Editor& editor);
  void finish(Editor& editor, const std::filesystem::path& path);

  BrowserRequest request_;
  bool open_ = false, appear_ = false, askReplace_ = false, focusName_ = false, showAll_ = false;
  std::filesystem::path folder_, replacing_;
  std::vector<Entry> entries_;
  std::string name_, error_;
};

}  // namespace pileus::editor
