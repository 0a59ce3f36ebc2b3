#pragma once
// What the trace of a frame (toolkit/ui_trace.h) says of the editor's state.
namespace pileus::editor {

struct Editor;

/// At the end of a frame; does nothing where no trace is written.
void writeTrace(Editor& editor);

}  // namespace pileus::editor
