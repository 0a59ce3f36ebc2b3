#pragma once
// The menu bar, read from the table of commands.
#include <string>
#include <string_view>
#include <vector>

namespace pileus::editor {

struct Action;
struct Editor;

struct MenuBar {
  std::vector<char> recentThere;  ///< by recent file: does it still exist? Asked when the list opens
  bool recentOpen = false;
  std::string layoutName;  ///< typed in "Save Layout"
};

/// The menus from left to right.
inline constexpr const char* kMenus[] = {"File", "Edit", "Graph", "Viewport", "View", "Help"};
/// Where an action stands: "View/Panels" is a menu within View. What acts on a view of one panel stands in
/// that panel's menu.
std::string_view menuOf(const Action& action);
/// An icon for what has a well-known one; null for the others.
const char* actionIcon(std::string_view id);
/// As the gallery calls it; "first_light.json" -> "First light" where it is not there.
std::string presetLabel(std::string_view path);

/// Returns its height in pixels.
float drawMenuBar(Editor& editor);

}  // namespace pileus::editor
