#pragma once
// What the evaluator knows about nodes of the graph on the canvas, which may be inside groups.
#include <string>

#include "nodes/evaluate/evaluator.h"

namespace pileus::editor {

struct Editor;

/// The evaluator's name of a node on the canvas.
std::string evaluatedName(const Editor& editor, const std::string& node);
const nodes::NodeStatus& statusOf(const Editor& editor, const std::string& node);

}  // namespace pileus::editor
