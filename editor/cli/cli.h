#pragma once
// The command line: parses and dispatches. Exit codes are those of pileus::Code.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "editor/cli/library/presets.h"

namespace pileus::cli {

/// What only the window's side of the program can do.
struct EditorSide {
  std::function<int(const std::filesystem::path&)> open;  ///< `pileus [FILE]`; returns the exit code
  std::function<std::string(bool markdown)> keys;         ///< `pileus keys`: the table of commands
  std::function<int()> measure;                           ///< `pileus bench`: the rows of a real window
  /// `pileus presets`, `pileus render NAME`: what the gallery says of the presets that are part of the
  /// program, and the folders with others, the user's own first.
  std::function<std::vector<ShippedPreset>()> shippedPresets;
  std::function<std::vector<std::filesystem::path>()> presetFolders;
};

int run(int argc, char** argv, const EditorSide& editor);

}  // namespace pileus::cli
