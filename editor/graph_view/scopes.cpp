#include "editor/graph_view/scopes.h"

#include <algorithm>

#include "editor/app/editor.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

/// Remembers what is selected here, for when one comes back.
void keepScope(Editor& editor) {
  editor.canvas.scopes[editor.document.scope()].selection = editor.document.selection();
}

}  // namespace

std::vector<std::string> currentScope(const Editor& editor) { return editor.document.scope(); }

bool goToScope(Editor& editor, const std::vector<std::string>& scope) {
  if (scope == editor.document.scope()) return true;
  if (!nodes::graphAt(editor.document.root(), scope)) return false;
  keepScope(editor);
  editor.document.setScope(scope);
  followScope(editor);
  return true;
}

void followScope(Editor& editor) {
  Canvas& canvas = editor.canvas;
  const std::vector<std::string>& scope = editor.document.scope();
  if (canvas.scope == scope) return;
  canvas.scopes[canvas.scope].center = canvas.center;
  canvas.scopes[canvas.scope].level = canvas.level;
  canvas.scope = scope;
  canvas.moving = {};
  canvas.interaction = {};
  canvas.selectedLink.reset();
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

bool isGroup(const Editor& editor, const std::string& node) {
  return nodes::groupGraph(editor.document.graph(), node) != nullptr;
}

void openNode(Editor& editor, const std::string& name) {
  const nodes::Node* node = nodes::findNode(editor.document.graph(), name);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (isGroup(editor, name))
    enterGroup(editor, name);
  else if (type && type->isOutput)
    viewNode(editor, name);
  else
    editor.parameters.focusName = true;
}

void groupSelection(Editor& editor) {
  const std::set<std::string>& names = editor.document.selection();
  if (names.empty()) return editor.messages.hint("Select the nodes to group.");
  std::string group;
  if (tryEdit(editor, nodes::groupNodes(editor.document.graph(), names, &group), "Group nodes"))
    editor.document.select({group});
}

void ungroupSelection(Editor& editor) {
  nodes::Graph graph = editor.document.graph();
  std::set<std::string> held;
  for (const std::string& name : std::set<std::string>(editor.document.selection())) {
    if (!nodes::groupGraph(graph, name)) continue;
    std::set<std::string> names;
    Result<nodes::Graph> undone = nodes::ungroup(graph, name, &names);
    if (!undone) return editor.messages.hint(undone.error().message);
    graph = std::move(*undone);
    held.merge(names);
  }
  if (held.empty()) return editor.messages.hint("Select a group to take apart.");
  if (tryEdit(editor, std::move(graph), "Ungroup")) editor.document.select(std::move(held));
}

bool groupSelected(const Editor& editor) {
  const std::set<std::string>& names = editor.document.selection();
  return std::any_of(names.begin(), names.end(), [&](const std::string& n) { return isGroup(editor, n); });
}

void enterGroup(Editor& editor, const std::string& group) {
  if (!isGroup(editor, group)) return editor.messages.hint(group + " is no group.");
  keepScope(editor);
  if (!editor.document.enter(group)) return;
  std::set<std::string> selection = editor.canvas.scopes[editor.document.scope()].selection;
  std::erase_if(selection, [&](const std::string& n) { return !editor.document.graph().nodes.contains(n); });
  editor.document.select(std::move(selection));
  followScope(editor);
}

void enterSelected(Editor& editor) {
  if (oneGroupSelected(editor)) enterGroup(editor, *editor.document.selection().begin());
}

bool oneGroupSelected(const Editor& editor) {
  return editor.document.selection().size() == 1 && groupSelected(editor);
}

void leaveGroup(Editor& editor) {
  if (!insideGroup(editor)) return editor.messages.hint("This is the outermost level already.");
  keepScope(editor);
  editor.document.leave();
  followScope(editor);
}

bool insideGroup(const Editor& editor) { return !editor.document.scope().empty(); }

}  // namespace pileus::editor
