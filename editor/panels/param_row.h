#pragma once
// One parameter of a node as a row: label, "modified" mark, and the widget its type asks for.
#include <string>

#include "nodes/graph.h"

namespace pileus::editor {

struct Editor;

void drawParamRow(Editor& editor, const std::string& node, const nodes::ParamSpec& spec);

/// Begins a row: draws the label at the left and moves to where the widget goes; returns the widget's width.
/// `modified` adds a dot that resets when clicked (returned in `reset`).
float beginRow(const Editor& editor, const std::string& label, bool modified, bool* reset);

}  // namespace pileus::editor
