#include "editor/graph_view/scopes.h"

#include <algorithm>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/picture/viewed_node.h"
#include "editor/toolkit/ui.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

/// Remembers what is selected here, for when one comes back.
void keepScope(const Session& session, Canvas& canvas) {
  canvas.scopes[session.document.scope()].selection = session.document.selection();
}

}  // namespace

std::vector<std::string> currentScope(const Session& session) { return session.document.scope(); }

bool goToScope(Session& session, Canvas& canvas, const std::vector<std::string>& scope) {
  if (scope == session.document.scope()) return true;
  if (!nodes::graphAt(session.document.root(), scope)) return false;
  keepScope(session, canvas);
  session.document.setScope(scope);
  followScope(session, canvas);
  return true;
}

void followScope(Session& session, Canvas& canvas) {
  const std::vector<std::string>& scope = session.document.scope();
  if (canvas.scope == scope) return;
  canvas.scopes[canvas.scope].center = canvas.center;
  canvas.scopes[canvas.scope].level = canvas.level;
  canvas.scope = scope;
  canvas.moving = {};
  canvas.interaction = {};
  session.selectedLink.reset();
  canvas.selectedFrame.reset();
  canvas.frameTitle.reset();
  const auto known = canvas.scopes.find(scope);
  if (known == canvas.scopes.end() || known->second.level < 0) {
    canvas.frameAll = true;
    return;
  }
  canvas.center = known->second.center;
  canvas.level = known->second.level;
}

bool isGroup(const Session& session, const std::string& node) {
  return nodes::groupGraph(session.document.graph(), node) != nullptr;
}

void openNode(Ui& ui, Session& session, Shown& shown, Canvas& canvas, const std::string& name) {
  const nodes::Node* node = nodes::findNode(session.document.graph(), name);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (isGroup(session, name))
    enterGroup(ui, session, canvas, name);
  else if (type && type->isOutput)
    viewNode(ui.messages, session, shown, name);
  else
    ui.fields.focusName = true;
}

void groupSelection(Ui& ui, Session& session) {
  const std::set<std::string>& names = session.document.selection();
  if (names.empty()) return ui.messages.hint("Select the nodes to group.");
  std::string group;
  if (tryEdit(session, ui.messages, nodes::groupNodes(session.document.graph(), names, &group),
              "Group nodes"))
    session.document.select({group});
}

void ungroupSelection(Ui& ui, Session& session) {
  nodes::Graph graph = session.document.graph();
  std::set<std::string> held;
  for (const std::string& name : std::set<std::string>(session.document.selection())) {
    if (!nodes::groupGraph(graph, name)) continue;
    std::set<std::string> names;
    Result<nodes::Graph> undone = nodes::ungroup(graph, name, &names);
    if (!undone) return ui.messages.hint(undone.error().message);
    graph = std::move(*undone);
    held.merge(names);
  }
  if (held.empty()) return ui.messages.hint("Select a group to take apart.");
  if (tryEdit(session, ui.messages, std::move(graph), "Ungroup")) session.document.select(std::move(held));
}

bool groupSelected(const Session& session) {
  const std::set<std::string>& names = session.document.selection();
  return std::any_of(names.begin(), names.end(), [&](const std::string& n) { return isGroup(session, n); });
}

void enterGroup(Ui& ui, Session& session, Canvas& canvas, const std::string& group) {
  if (!isGroup(session, group)) return ui.messages.hint(group + " is no group.");
  keepScope(session, canvas);
  if (!session.document.enter(group)) return;
  std::set<std::string> selection = canvas.scopes[session.document.scope()].selection;
  std::erase_if(selection, [&](const std::string& n) { return !session.document.graph().nodes.contains(n); });
  session.document.select(std::move(selection));
  followScope(session, canvas);
}

void enterSelected(Ui& ui, Session& session, Canvas& canvas) {
  if (oneGroupSelected(session)) enterGroup(ui, session, canvas, *session.document.selection().begin());
}

bool oneGroupSelected(const Session& session) {
  return session.document.selection().size() == 1 && groupSelected(session);
}

void leaveGroup(Ui& ui, Session& session, Canvas& canvas) {
  if (!insideGroup(session)) return ui.messages.hint("This is the outermost level already.");
  keepScope(session, canvas);
  session.document.leave();
  followScope(session, canvas);
}

bool insideGroup(const Session& session) { return !session.document.scope().empty(); }

}  // namespace pileus::editor
