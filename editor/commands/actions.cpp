#include "editor/commands/actions.h"

#include <imgui.h>
#include <imgui_internal.h>  // menu rows with icons

#include <algorithm>
#include <vector>

#include "editor/commands/menu.h"
#include "editor/commands/table.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/window.h"

namespace pileus::editor {
namespace {

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
    case GLFW_KEY_PERIOD:
      return ".";
    case GLFW_KEY_COMMA:
      return ",";
    case GLFW_KEY_SLASH:
      return "/";
    case GLFW_KEY_MINUS:
      return "-";
    case GLFW_KEY_EQUAL:
      return "=";
    case GLFW_KEY_SPACE:
      return "Space";
    case GLFW_KEY_ENTER:
      return "Enter";
    case GLFW_KEY_BACKSPACE:
      return "Backspace";
    case GLFW_KEY_END:
      return "End";
    case GLFW_KEY_PAGE_UP:
      return "PgUp";
    case GLFW_KEY_PAGE_DOWN:
      return "PgDn";
    case GLFW_KEY_LEFT:
      return "Left";
    case GLFW_KEY_RIGHT:
      return "Right";
    case GLFW_KEY_UP:
      return "Up";
    case GLFW_KEY_DOWN:
      return "Down";
    case GLFW_KEY_KP_ADD:
      return "Num +";
    case GLFW_KEY_KP_SUBTRACT:
      return "Num -";
    case GLFW_KEY_KP_0:
      return "Num 0";
    default:
      return "?";
  }
}

void run(Editor& editor, const Action& action) {
  if (!action.enabled || action.enabled(editor)) action.run(editor);
}

}  // namespace

std::span<const Action> allActions() {
  static const std::vector<Action> all = [] {
    std::vector<Action> joined;
    for (const auto part :
         {fileActions(), presetActions(), editActions(), graphActions(), lookActions(), numberedActions(),
          viewportActions(), cameraActions(), displayActions(), parameterActions(), lightActions(),
          timelineActions(), windowActions(), viewActions(), helpActions()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

const Action* findAction(std::string_view id) {
  for (const Action& a : allActions())
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
  for (const Panel panel : {editor.now.hovered, Panel::Global}) {
    for (const Action& a : allActions()) {
      if (a.panel != panel || (typing && !a.whileTyping)) continue;
      if (std::find(a.keys.begin(), a.keys.end(), wanted) == a.keys.end()) continue;
      run(editor, a);
      return true;
    }
    if (panel == Panel::Global) break;
  }
  return false;
}

bool actsWhileTyping(const Editor& editor, const KeyPress& press) {
  const Shortcut wanted = {press.key, press.ctrl, press.shift, press.alt};
  const auto all = allActions();
  return std::any_of(all.begin(), all.end(), [&](const Action& a) {
    return a.whileTyping && (a.panel == Panel::Global || a.panel == editor.now.hovered) &&
           std::find(a.keys.begin(), a.keys.end(), wanted) != a.keys.end();
  });
}

bool runCommand(Editor& editor, std::string_view id) {
  const Action* action = findAction(id);
  if (!action || (action->enabled && !action->enabled(editor))) return false;
  action->run(editor);
  return true;
}

std::optional<CommandLook> commandLook(const Editor& editor, std::string_view id) {
  const Action* a = findAction(id);
  if (!a) return std::nullopt;
  return CommandLook{a->label, actionIcon(id), shortcutText(a->keys[0]), !a->enabled || a->enabled(editor),
                     a->checked && a->checked(editor)};
}

}  // namespace pileus::editor
