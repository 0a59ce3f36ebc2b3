#include "editor/document/session.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/exchange/messages.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

/// A selected link that is gone is not selected.
void checkSelectedLink(Session& session) {
  if (!session.selectedLink) return;
  const std::vector<nodes::Link>& links = session.document.graph().links;
  if (std::find(links.begin(), links.end(), *session.selectedLink) == links.end())
    session.selectedLink.reset();
}

bool made(Session& session, Messages& messages, bool edited) {
  if (edited)
    checkSelectedLink(session);
  else
    messages.hint(fmt::format("Groups may be nested {} deep.", nodes::kDeepestGroup));
  return edited;
}

}  // namespace

bool tryEdit(Session& session, Messages& messages, Result<nodes::Graph> graph, const std::string& label,
             std::string_view mergeKey) {
  if (graph) return made(session, messages, session.document.edit(std::move(*graph), label, mergeKey));
  messages.hint(graph.error().message);
  return false;
}

bool tryEditRoot(Session& session, Messages& messages, Result<nodes::Graph> root, const std::string& label,
                 std::string_view mergeKey) {
  if (root) return made(session, messages, session.document.editRoot(std::move(*root), label, mergeKey));
  messages.hint(root.error().message);
  return false;
}

std::string documentName(const Session& session) {
  return session.document.path().empty() ? "Untitled" : session.document.path().filename().string();
}

}  // namespace pileus::editor
