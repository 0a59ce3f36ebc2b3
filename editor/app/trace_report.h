#pragma once
// What the trace of a frame (toolkit/ui_trace.h) says of the editor's state.
#include <string>

#include "nodes/graph/graph.h"

namespace pileus::editor {

struct Editor;

class TraceReport {
 public:
  /// At the end of a frame; does nothing where no trace is written.
  void write(Editor& editor);

 private:
  std::string document_;  ///< in its own file format: what a save would write
  nodes::Graph graph_;    ///< that it was made of
};

}  // namespace pileus::editor
