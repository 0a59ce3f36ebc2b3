#pragma once
// The log panel: what has been logged since the start, filtered by level and words, newest at the bottom.
#include <imgui.h>

#include <array>
#include <string>
#include <vector>

#include "renderer/base/log.h"

namespace pileus::editor {

struct Ui;

struct LogPanel {
  std::array<bool, 4> levels{false, true, true, true};  ///< shown, by log::Level
  std::string words;                                    ///< only lines with them
  std::size_t cleared = 0;                              ///< lines that were there when it was cleared
  std::array<std::size_t, 4> clearedAt{};               ///< how many of each level they were
  bool follow = true;                                   ///< the newest line stays in sight

  // What is shown, made anew where any of the above or the log has changed.
  std::vector<log::Line> lines;
  std::string key;

  /// Since it was cleared.
  std::size_t count(log::Level level) const;
};

void drawLog(Ui& ui, LogPanel& logPanel, ImVec2 min, ImVec2 max);
/// Opens the panel with all levels from `level` up.
void showLog(Ui& ui, LogPanel& logPanel, log::Level level);

}  // namespace pileus::editor
