#pragma once
// The one table of commands: menus, shortcuts and context menus all read it.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "editor/exchange/panel.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {

struct Editor;
struct KeyPress;

struct Shortcut {
  int key = 0;  ///< GLFW's code; 0 = none
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const Shortcut&) const = default;
};

struct Action {
  const char* id;               ///< "file.save"
  const char* label;            ///< "Save"; menus add the shortcut
  const char* menu = "";        ///< the menu bar's menu it stands in; "" = none
  Panel panel = Panel::Global;  ///< whose keys these are; Global ones act everywhere
  std::array<Shortcut, 3> keys{};
  void (*run)(Editor&) = nullptr;
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
/// Would a text field that is typed into lose this key to a command?
bool actsWhileTyping(const Editor& editor, const KeyPress& key);
/// Runs a command if it is enabled; false: there is no such one, or it is not.
bool runCommand(Editor& editor, std::string_view id);
/// As menus show it; nothing for one that is not in the table.
std::optional<CommandLook> commandLook(const Editor& editor, std::string_view id);

}  // namespace pileus::editor
