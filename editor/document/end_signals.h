#pragma once
// Being ended from outside: SIGTERM, SIGINT and SIGHUP wake the window, which saves unsaved work for recovery
// and leaves.

namespace pileus::editor {

/// Call once, before any thread is started.
void watchEndSignals();
/// The signal that asked the program to end; 0 = none.
int endSignal();

}  // namespace pileus::editor
