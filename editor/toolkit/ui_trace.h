#pragma once
// For tests that drive the window: when $PILEUS_UI_TRACE names a file, every drawn frame that looks different
// leaves there, as JSON, where things are (window pixels) and what the document holds. Off, everything here
// is a test of one bool.
#include <imgui.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pileus::nodes {
struct Graph;
}

namespace pileus::editor {

struct Editor;

class UiTrace {
 public:
  /// Reads the environment.
  UiTrace();
  bool on() const { return collecting_ || !path_.empty(); }
  /// Rectangles and notes are kept for find(), with or without a file.
  void collect(bool on) { collecting_ = on; }
  /// Of this frame; null: nothing has this name.
  const std::vector<float>* find(const std::string& name) const {
    const auto it = rects_.find(name);
    return it == rects_.end() ? nullptr : &it->second;
  }
  void begin() { rects_.clear(), notes_.clear(), ms = 0; }
  /// "node/Sun", "socket/Sun/out/light", "param/extinction", "menu/file.save", "search/0": a name's rectangle
  /// this frame.
  void rect(std::string name, ImVec2 min, ImVec2 max) {
    if (on()) rects_[std::move(name)] = {min.x, min.y, max.x, max.y};
  }
  /// The last ImGui item, if its window is shown: a window that appears is laid out unseen first, at a place
  /// that is not yet its own.
  void item(std::string name);
  /// A text that is on the screen ("tooltip", "status", "search/0").
  void note(std::string name, std::string text) {
    if (on()) notes_[std::move(name)] = std::move(text);
  }
  /// Writes the file if anything differs from the last one. "marks" comes first: how much of a test's input
  /// it knows of (see Window::marks()).
  void end(const Editor& editor);

  double ms = 0;  ///< spent this frame on what only a trace needs

 private:
  std::filesystem::path path_;
  bool collecting_ = false;
  std::map<std::string, std::vector<float>> rects_;
  std::map<std::string, std::string> notes_;
  std::string last_, document_;                ///< as written; the part of it that is the document
  std::shared_ptr<const nodes::Graph> graph_;  ///< of that part
};

}  // namespace pileus::editor
