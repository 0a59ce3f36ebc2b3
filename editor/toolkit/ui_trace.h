#pragma once
// For tests that drive the window: when $PILEUS_UI_TRACE names a file, every drawn frame that looks different
// leaves there, as JSON, where things are (window pixels) and what the editor holds. Off, everything here
// is a test of one bool.
#include <imgui.h>

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace pileus::editor {

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
  bool writes() const { return !path_.empty(); }
  /// Writes the file if anything differs from the last one: rectangles, notes, `state`, which is an object,
  /// and `document`, a value that is text already. "marks" comes first: how much of a test's input the frame
  /// knows of (Window::marks()).
  void end(unsigned long long marks, const std::string& document, nlohmann::json state);

  double ms = 0;  ///< spent this frame on what only a trace needs

 private:
  std::filesystem::path path_;
  bool collecting_ = false;
  std::map<std::string, std::vector<float>> rects_;
  std::map<std::string, std::string> notes_;
  std::string last_;
};

}  // namespace pileus::editor
