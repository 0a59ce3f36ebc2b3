#include "editor/actions.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "editor/files.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/panels/viewport_camera.h"

namespace pileus::editor {
namespace {

constexpr Shortcut ctrl(int key) { return {key, true, false, false}; }
constexpr Shortcut shift(int key) { return {key, false, true, false}; }
constexpr Shortcut ctrlShift(int key) { return {key, true, true, false}; }
constexpr Shortcut plain(int key) { return {key, false, false, false}; }

bool hasSelection(const Editor& e) { return !e.document.selection().empty(); }
bool canDelete(const Editor& e) { return hasSelection(e) || e.canvas.selectedLink; }
bool oneSelected(const Editor& e) { return e.document.selection().size() == 1; }
bool hasNodes(const Editor& e) { return !e.document.graph().nodes.empty(); }
bool canUndo(const Editor& e) { return e.document.canUndo(); }
bool canRedo(const Editor& e) { return e.document.canRedo(); }
bool hasView(const Editor& e) { return !shownView(e).empty(); }

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
void quit(Editor& e) {
  withSavedDocument(e, [](Editor& editor) { editor.quit = true; });
}

using P = Panel;

const Action kActions[] = {
    {"file.new", "New", "File", P::Global, {ctrl(GLFW_KEY_N)}, newDocument, nullptr, nullptr, false, true},
    {"file.open",
     "Open\xe2\x80\xa6",
     "File",
     P::Global,
     {ctrl(GLFW_KEY_O)},
     askOpen,
     nullptr,
     nullptr,
     false,
     true},
    {"file.save",
     "Save",
     "File",
     P::Global,
     {ctrl(GLFW_KEY_S)},
     [](Editor& e) { save(e); },
     nullptr,
     nullptr,
     true,
     true},
    {"file.save_as",
     "Save As\xe2\x80\xa6",
     "File",
     P::Global,
     {ctrlShift(GLFW_KEY_S)},
     [](Editor& e) { saveAs(e); },
     nullptr,
     nullptr,
     false,
     true},
    {"file.export",
     "Export EXR\xe2\x80\xa6",
     "File",
     P::Global,
     {ctrl(GLFW_KEY_E)},
     askExport,
     hasView,
     nullptr,
     true},
    {"file.quit", "Quit", "File", P::Global, {ctrl(GLFW_KEY_Q)}, quit, nullptr, nullptr, true, true},

    {"edit.undo", "Undo", "Edit", P::Global, {ctrl(GLFW_KEY_Z)}, undo, canUndo},
    {"edit.redo", "Redo", "Edit", P::Global, {ctrlShift(GLFW_KEY_Z), ctrl(GLFW_KEY_Y)}, redo, canRedo},
    {"edit.cut", "Cut", "Edit", P::Global, {ctrl(GLFW_KEY_X)}, cutSelection, hasSelection, nullptr, true},
    {"edit.copy", "Copy", "Edit", P::Global, {ctrl(GLFW_KEY_C)}, copySelection, hasSelection},
    {"edit.paste", "Paste", "Edit", P::Global, {ctrl(GLFW_KEY_V)}, pasteNodes},
    {"graph.duplicate",
     "Duplicate",
     "Edit",
     P::Graph,
     {ctrl(GLFW_KEY_D), shift(GLFW_KEY_D)},
     duplicateSelection,
     hasSelection},
    {"graph.delete", "Delete", "Edit", P::Graph, {plain(GLFW_KEY_DELETE)}, deleteSelection, canDelete},
    {"edit.select_all", "Select All", "Edit", P::Global, {ctrl(GLFW_KEY_A)}, selectAllNodes, hasNodes},
    {"graph.add",
     "Add Node\xe2\x80\xa6",
     "Edit",
     P::Graph,
     {plain(GLFW_KEY_TAB), shift(GLFW_KEY_A)},
     searchNode,
     nullptr,
     nullptr,
     true},
    {"graph.bypass", "Bypass", "Edit", P::Graph, {plain(GLFW_KEY_D)}, bypassSelection, hasSelection},
    {"graph.rename",
     "Rename",
     "Edit",
     P::Graph,
     {plain(GLFW_KEY_F2)},
     [](Editor& e) { e.parameters.focusName = true; },
     oneSelected},

    {"graph.frame",
     "Frame Selected Nodes",
     "View",
     P::Graph,
     {plain(GLFW_KEY_F)},
     [](Editor& e) { (e.document.selection().empty() ? e.canvas.frameAll : e.canvas.frameSelection) = true; },
     hasNodes},
    {"graph.frame_all",
     "Frame All Nodes",
     "View",
     P::Graph,
     {plain(GLFW_KEY_A), plain(GLFW_KEY_HOME)},
     [](Editor& e) { e.canvas.frameAll = true; }},
    {"viewport.frame",
     "Frame Volumes",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_F), plain(GLFW_KEY_A), plain(GLFW_KEY_HOME)},
     frameVolumes,
     hasView,
     nullptr,
     true},
    {"viewport.reset_camera",
     "Reset Free Camera",
     "View",
     P::Viewport,
     {},
     [](Editor& e) { e.viewport.freeCamera.reset(); },
     hasView},
    {"viewport.exposure_up",
     "Exposure +0.5",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_RIGHT_BRACKET)},
     [](Editor& e) { changeExposure(e, 0.5); },
     hasView},
    {"viewport.exposure_down",
     "Exposure -0.5",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_LEFT_BRACKET)},
     [](Editor& e) { changeExposure(e, -0.5); },
     hasView},
    {"viewport.exposure_reset",
     "Reset Exposure",
     "View",
     P::Viewport,
     {ctrl(GLFW_KEY_R)},
     resetExposure,
     hasView},
    {"viewport.compare",
     "Compare with Truth",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_Q)},
     toggleCompare,
     hasView,
     [](const Editor& e) { return e.compare.on; },
     true},
    {"viewport.wipe",
     "Wipe",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_W)},
     toggleWipe,
     hasView,
     [](const Editor& e) { return e.compare.on && e.compare.layout == CompareLayout::Wipe; }},
    {"viewport.error",
     "Error in False Colours",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_E)},
     toggleError,
     hasView,
     [](const Editor& e) { return e.compare.on && e.compare.layout == CompareLayout::Error; }},
    {"viewport.pick_ray",
     "Pick Light Ray",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_S)},
     togglePicking,
     hasView,
     [](const Editor& e) { return e.scope.picking; }},
    {"view.pause",
     "Pause Refinement",
     "View",
     P::Global,
     {plain(GLFW_KEY_ESCAPE)},
     [](Editor& e) { e.preview.pause(!e.preview.paused()); },
     nullptr,
     [](const Editor& e) { return e.preview.paused(); },
     true},
    {"view.times",
     "Show Node Times",
     "View",
     P::Global,
     {},
     [](Editor& e) { e.settings.showTimes = !e.settings.showTimes; },
     nullptr,
     [](const Editor& e) { return e.settings.showTimes; }},
    {"view.scope",
     "Show Ray Scope",
     "View",
     P::Global,
     {shift(GLFW_KEY_S)},
     toggleScope,
     nullptr,
     [](const Editor& e) { return e.settings.showScope; }},
    {"view.shootout",
     "Shoot-out",
     "View",
     P::Global,
     {plain(GLFW_KEY_F6)},
     toggleShootout,
     nullptr,
     [](const Editor& e) { return e.settings.showLab && e.lab.tab == LabTab::Shootout; }},
    {"view.tune",
     "Tune Shadows",
     "View",
     P::Global,
     {plain(GLFW_KEY_F7)},
     toggleTune,
     nullptr,
     [](const Editor& e) { return e.settings.showLab && e.lab.tab == LabTab::Tune; }},
    {"view.log",
     "Show Log",
     "View",
     P::Global,
     {ctrl(GLFW_KEY_L)},
     [](Editor& e) { e.settings.showLog = !e.settings.showLog; },
     nullptr,
     [](const Editor& e) { return e.settings.showLog; }},

    {"help.shortcuts",
     "Keyboard and Mouse",
     "Help",
     P::Global,
     {plain(GLFW_KEY_F1)},
     [](Editor& e) { e.dialogs.shortcuts = true; }},
    {"help.about", "About Pileus", "Help", P::Global, {}, [](Editor& e) { e.dialogs.about = true; }},
};

std::string keyName(int key) {
  if ((key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9))
    return {static_cast<char>(key)};
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  switch (key) {
    case GLFW_KEY_TAB:
      return "Tab";
    case GLFW_KEY_HOME:
      return "Home";
    case GLFW_KEY_DELETE:
      return "Delete";
    case GLFW_KEY_ESCAPE:
      return "Esc";
    case GLFW_KEY_LEFT_BRACKET:
      return "[";
    case GLFW_KEY_RIGHT_BRACKET:
      return "]";
    default:
      return "?";
  }
}

void run(Editor& editor, const Action& action) {
  if (!action.enabled || action.enabled(editor)) action.run(editor);
}

}  // namespace

std::span<const Action> allActions() { return kActions; }

const Action* findAction(std::string_view id) {
  for (const Action& a : kActions)
    if (a.id == id) return &a;
  return nullptr;
}

std::string shortcutText(const Shortcut& s) {
  if (s.key == 0) return {};
  return std::string(s.ctrl ? "Ctrl+" : "") + (s.shift ? "Shift+" : "") + (s.alt ? "Alt+" : "") +
         keyName(s.key);
}

bool runShortcut(Editor& editor, const KeyPress& press) {
  const Shortcut wanted = {press.key, press.ctrl, press.shift, press.alt};
  const bool typing = ImGui::GetIO().WantTextInput;
  for (const Panel panel : {editor.hovered, Panel::Global}) {
    for (const Action& a : kActions) {
      if (a.panel != panel || (typing && !a.whileTyping)) continue;
      if (std::find(a.keys.begin(), a.keys.end(), wanted) == a.keys.end()) continue;
      run(editor, a);
      return true;
    }
    if (panel == Panel::Global) break;
  }
  return false;
}

void actionMenuItem(Editor& editor, std::string_view id) {
  const Action* a = findAction(id);
  if (!a) return;
  const bool on = a->checked && a->checked(editor);
  if (ImGui::MenuItem(a->label, shortcutText(a->keys[0]).c_str(), on, !a->enabled || a->enabled(editor)))
    run(editor, *a);
  editor.trace.item("menu/" + std::string(id));
}

}  // namespace pileus::editor
