#pragma once
// The command line: parses and dispatches. Exit codes are those of pileus::Code.
#include <filesystem>
#include <functional>
#include <string>

namespace pileus::cli {

/// What only the window's side of the program can do.
struct EditorSide {
  std::function<int(const std::filesystem::path&)> open;  ///< `pileus [FILE]`; returns the exit code
  std::function<std::string(bool markdown)> keys;         ///< `pileus keys`: the table of commands
  std::function<int()> measure;                           ///< `pileus bench`: the rows of a real window
};

int run(int argc, char** argv, const EditorSide& editor);

}  // namespace pileus::cli
