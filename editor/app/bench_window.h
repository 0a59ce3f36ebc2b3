#pragma once
// What the window itself costs, measured in it by events as a user would make them (rows of docs/bench.md).
namespace pileus::editor {

/// Prints the rows; an exit code. Uses the settings and folders of the environment.
int benchWindow();

}  // namespace pileus::editor
