#include "editor/graph_view/node_status.h"

#include "editor/document/session.h"
#include "editor/picture/shown.h"

namespace pileus::editor {

std::string evaluatedName(const Session& session, const std::string& node) {
  return session.document.scopedName(node);
}

const nodes::NodeStatus& statusOf(const Session& session, const Shown& shown, const std::string& node) {
  return shown.preview.evaluator().status(evaluatedName(session, node));
}

}  // namespace pileus::editor
