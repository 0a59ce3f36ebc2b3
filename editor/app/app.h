#pragma once
// The editor: opens the window and runs until it is closed.
#include <filesystem>
#include <functional>

namespace pileus::editor {

struct Editor;

struct EditorOptions {
  std::filesystem::path file;  ///< empty = the default preset
};

/// Exit code: 0, or 4 when no OpenGL 4.5 window can be had (the reason goes to the log).
int runEditor(const EditorOptions& options);

/// The same with somebody else's loop: opens, hands the editor to `use`, saves its settings and closes.
int withEditor(const EditorOptions& options, const std::function<void(Editor&)>& use);

/// Hover states and tooltips need a second look: frames drawn after the last event.
inline constexpr int kSettlingFrames = 3;
/// One round of the loop: sleeps until something is due, draws a frame, does a slice of the work. `settling`
/// starts at kSettlingFrames and counts down to 0; then the loop may sleep.
void runFrame(Editor& editor, int& settling);

}  // namespace pileus::editor
