#pragma once
// The one table of commands: menus, shortcuts and context menus all read it.
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "editor/app/editor.h"
#include "editor/toolkit/window.h"

namespace pileus::editor {

struct Shortcut {
  int key = 0;  ///< GLFW's code; 0 = none
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const Shortcut&) const = default;
};

struct Action {
  const char* id;     ///< "file.save"
  const char* label;  ///< "Save"; menus add the shortcut
  const char* menu;   ///< the menu bar's menu it stands in; "" = none
  Panel panel;        ///< whose keys these are; Global ones act everywhere
  std::array<Shortcut, 3> keys;
  void (*run)(Editor&);
  bool (*enabled)(const Editor&) = nullptr;  ///< null: always
  bool (*checked)(const Editor&) = nullptr;  ///< not null: a toggle
  bool separator = false;                    ///< menus draw a line above it
  bool whileTyping = false;                  ///< its keys act while a text field is active
};

std::span<const Action> allActions();
const Action* findAction(std::string_view id);

/// "Ctrl+Shift+Z"; "" for none.
std::string shortcutText(const Shortcut& shortcut);
/// Runs the action of a key for the panel under the pointer, else the global one. False: no such shortcut.
bool runShortcut(Editor& editor, const KeyPress& key);
/// A row of an open ImGui menu.
void actionMenuItem(Editor& editor, std::string_view id);

}  // namespace pileus::editor
