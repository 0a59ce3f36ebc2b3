// Commands of undo, clipboard and selection.
#include "editor/commands/table.h"
#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/parameters/parameters.h"

namespace pileus::editor {
namespace {

bool hasSelection(const Editor& e) { return !e.session.document.selection().empty(); }
bool hasNodes(const Editor& e) { return !e.session.document.graph().nodes.empty(); }
bool canUndo(const Editor& e) { return e.session.document.canUndo(); }
bool canRedo(const Editor& e) { return e.session.document.canRedo(); }
void undo(Editor& e) {
  e.session.document.endMerge();
  const std::string label = e.session.document.undoLabel();
  e.session.document.undo();
  e.messages.note("Undone: " + label);
}
void redo(Editor& e) {
  const std::string label = e.session.document.redoLabel();
  e.session.document.redo();
  e.messages.note("Redone: " + label);
}

// Over a parameter the clipboard is that of values.
bool canCopy(const Editor& e) { return hasSelection(e) || e.parameters.hovered.has_value(); }
void copy(Editor& e) {
  if (const ParamTarget* target = hoveredParam(e.now, e.parameters))
    return copyParam(e.session, e.clock, *target);
  copySelection(e.ui, e.session, e.canvas);
}
void paste(Editor& e) {
  if (const ParamTarget* target = hoveredParam(e.now, e.parameters))
    return pasteParam(e.parameterRoom, ParamTarget(*target));
  pasteNodes(e.ui, e.session, e.canvas);
}

using P = Panel;

const Action kActions[] = {
    {.id = "edit.undo",
     .label = "Undo",
     .menu = "Edit",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_Z)},
     .run = undo,
     .enabled = canUndo},
    {.id = "edit.redo",
     .label = "Redo",
     .menu = "Edit",
     .panel = P::Global,
     .keys = {ctrlShift(GLFW_KEY_Z), ctrl(GLFW_KEY_Y)},
     .run = redo,
     .enabled = canRedo},
    {.id = "edit.cut",
     .label = "Cut",
     .menu = "Edit",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_X)},
     .run = [](Editor& e) { cutSelection(e.ui, e.session, e.canvas); },
     .enabled = hasSelection,
     .separator = true},
    {.id = "edit.copy",
     .label = "Copy",
     .menu = "Edit",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_C)},
     .run = copy,
     .enabled = canCopy},
    {.id = "edit.paste",
     .label = "Paste",
     .menu = "Edit",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_V)},
     .run = paste},
    {.id = "edit.select_all",
     .label = "Select All",
     .menu = "Edit",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_A)},
     .run = [](Editor& e) { selectAllNodes(e.session, e.canvas); },
     .enabled = hasNodes},
    {.id = "variations.take",
     .label = "Take Variation",
     .menu = "Edit",
     .panel = P::Global,
     .run = [](Editor& e) { takeVariation(e.parameterRoom); },
     .enabled = hasNodes,
     .separator = true},
};

}  // namespace

std::span<const Action> editActions() { return kActions; }

}  // namespace pileus::editor
