#pragma once
// The editor: opens the window and runs until it is closed.
#include <filesystem>

namespace pileus::editor {

struct EditorOptions {
  std::filesystem::path file;  ///< empty = the default preset
};

/// Exit code: 0, or 4 when no OpenGL 4.5 window can be had (the reason goes to the log).
int runEditor(const EditorOptions& options);

}  // namespace pileus::editor
