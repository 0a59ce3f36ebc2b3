#include "editor/graph_view/node_status.h"

#include "editor/app/editor.h"

namespace pileus::editor {

std::string evaluatedName(const Editor& editor, const std::string& node) {
  return editor.document.scopedName(node);
}

const nodes::NodeStatus& statusOf(const Editor& editor, const std::string& node) {
  return editor.preview.evaluator().status(evaluatedName(editor, node));
}

}  // namespace pileus::editor
