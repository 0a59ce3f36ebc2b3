// Commands of undo, clipboard and selection.
#include "editor/commands/table.h"
#include "editor/graph_view/canvas_commands.h"

namespace pileus::editor {
namespace {

bool hasSelection(const Editor& e) { return !e.document.selection().empty(); }
bool hasNodes(const Editor& e) { return !e.document.graph().nodes.empty(); }
bool canUndo(const Editor& e) { return e.document.canUndo(); }
bool canRedo(const Editor& e) { return e.document.canRedo(); }
void undo(Editor& e) {
  e.document.endMerge();
  const std::string label = e.document.undoLabel();
  e.document.undo();
  e.messages.note("Undone: " + label);
}
void redo(Editor& e) {
  const std::string label = e.document.redoLabel();
  e.document.redo();
  e.messages.note("Redone: " + label);
}

// Over a parameter the clipboard is that of values.
bool canCopy(const Editor& e) { return hasSelection(e) || e.parameters.hovered.has_value(); }
void copy(Editor& e) {
  const auto value = [](Editor& editor, const ParamTarget& target) { copyParam(editor, target); };
  if (!onHoveredParam(e, value)) copySelection(e);
}
void paste(Editor& e) {
  if (!onHoveredParam(e, pasteParam)) pasteNodes(e);
}

using P = Panel;

const Action kActions[] = {
    {"edit.undo", "Undo", "Edit", P::Global, {ctrl(GLFW_KEY_Z)}, undo, canUndo},
    {"edit.redo", "Redo", "Edit", P::Global, {ctrlShift(GLFW_KEY_Z), ctrl(GLFW_KEY_Y)}, redo, canRedo},
    {"edit.cut", "Cut", "Edit", P::Global, {ctrl(GLFW_KEY_X)}, cutSelection, hasSelection, nullptr, true},
    {"edit.copy", "Copy", "Edit", P::Global, {ctrl(GLFW_KEY_C)}, copy, canCopy},
    {"edit.paste", "Paste", "Edit", P::Global, {ctrl(GLFW_KEY_V)}, paste},
    {"edit.select_all", "Select All", "Edit", P::Global, {ctrl(GLFW_KEY_A)}, selectAllNodes, hasNodes},
};

}  // namespace

std::span<const Action> editActions() { return kActions; }

}  // namespace pileus::editor
