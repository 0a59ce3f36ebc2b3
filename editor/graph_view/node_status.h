#pragma once
// What the evaluator knows about nodes of the graph on the canvas, which may be inside groups.
#include <string>

#include "nodes/evaluate/evaluator.h"

namespace pileus::editor {

struct Session;
struct Shown;

/// The evaluator's name of a node on the canvas.
std::string evaluatedName(const Session& session, const std::string& node);
const nodes::NodeStatus& statusOf(const Session& session, const Shown& shown, const std::string& node);

}  // namespace pileus::editor
