#include "editor/commands/keyboard.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "editor/commands/actions.h"
#include "editor/commands/panel_commands.h"
#include "editor/preferences/panel_list.h"

namespace pileus::editor {
namespace {

struct Gesture {
  Panel panel;
  const char* what;
  const char* keys;
};
constexpr Gesture kGestures[] = {
    {Panel::Graph, "Pan", "Middle drag, Alt+drag"},
    {Panel::Graph, "Zoom", "Wheel, Alt+right drag"},
    {Panel::Graph, "Select in a box; add; remove", "Drag; Shift+drag; Ctrl+drag"},
    {Panel::Graph, "Nodes that fit a link", "Drop the link on the empty canvas"},
    {Panel::Graph, "Insert a node into a link", "Drop it on the link"},
    {Panel::Graph, "Lasso", "Ctrl+Alt+drag"},
    {Panel::Graph, "A second link from the same source", "Shift+drag at the input"},
    {Panel::Graph, "Move all links of an output", "Ctrl+drag at the output"},
    {Panel::Graph, "Cut links", "Ctrl+right drag, Y+drag"},
    {Panel::Graph, "Mute links", "Ctrl+Alt+right drag"},
    {Panel::Graph, "Dots on links", "Shift+right drag, Ctrl+click"},
    {Panel::Graph, "View a node", "Ctrl+Shift+click"},
    {Panel::Graph, "Move a frame without its nodes", "Ctrl+drag its header"},
    {Panel::Graph, "Rename a frame, enter a group", "Double click"},
    {Panel::Graph, "Take a drag back", "Esc"},
    {Panel::Graph, "Menu of what is below", "Right click"},
    {Panel::Graph, "Menu of the canvas", "Ctrl+right click, or the button in the search"},
    {Panel::Viewport, "Orbit, like Maya", "Alt+drag, drag"},
    {Panel::Viewport, "Pan, like Maya", "Alt+middle drag, middle drag"},
    {Panel::Viewport, "Dolly, like Maya", "Wheel, Alt+right drag, right drag"},
    {Panel::Viewport, "Orbit, pan, dolly, like Blender", "Middle drag; with Shift; with Ctrl"},
    {Panel::Viewport, "Orbit, pan, dolly, like Houdini", "Space or Alt+left, middle, right drag"},
    {Panel::Viewport, "Finer moves; handles and turns in steps", "Shift; Ctrl while dragging"},
    {Panel::Viewport, "Turn the selected environment or sky", "Drag sideways"},
    {Panel::Viewport, "Select what is there; more", "Click; Shift+click"},
    {Panel::Viewport, "Take back a drag, leave a tool", "Esc"},
    {Panel::Parameters, "Change a number", "Drag sideways"},
    {Panel::Parameters, "Finer; round steps", "Shift; Ctrl while dragging"},
    {Panel::Parameters, "Type a number or a sum", "Double click, Ctrl+click"},
    {Panel::Timeline, "Scrub", "Drag in the ruler"},
    {Panel::Timeline, "Zoom, pan", "Wheel, middle drag"},
    {Panel::Timeline, "Select keys; add", "Click, drag a box; with Shift"},
    {Panel::Timeline, "Move keys; by tenths of a frame", "Drag; Ctrl while dragging"},
    {Panel::Timeline, "Menu of keys", "Right click"},
    {Panel::Global, "Hide, maximise a panel", "Buttons in its upper right corner"},
    {Panel::Global, "Maximise a panel", "Double click on its bar"},
    {Panel::Global, "Size of a splitter's panel back to the default", "Double click on the splitter"},
};

std::string keysOf(const Action& a) {
  std::string keys;
  for (const Shortcut& s : a.keys)
    if (s.key) keys += (keys.empty() ? "" : ", ") + shortcutText(s);
  return keys;
}

std::string withoutEllipsis(std::string label) {
  if (label.ends_with("\xe2\x80\xa6")) label.resize(label.size() - 3);
  return label;
}

bool digitAtEnd(const std::string& s) {
  return !s.empty() && std::isdigit(static_cast<unsigned char>(s.back())) &&
         (s.size() < 2 || !std::isdigit(static_cast<unsigned char>(s[s.size() - 2])));
}

/// "View Slot 1", "1" and "View Slot 2", "2": the same but for a last digit that grows by one.
bool continues(const KeyRow& before, const KeyRow& now, char last) {
  return digitAtEnd(now.what) && digitAtEnd(now.keys) && now.what.back() == last + 1 &&
         now.keys.back() == last + 1 &&
         now.what.substr(0, now.what.size() - 1) == before.what.substr(0, now.what.size() - 1) &&
         now.keys.substr(0, now.keys.size() - 1) == before.keys.substr(0, now.keys.size() - 1);
}

KeySection sectionOf(Panel panel, const char* title) {
  KeySection section{title, {}};
  // Rows that may become the first of a series, and the digit it has come to.
  std::vector<std::pair<std::size_t, char>> series;
  for (const Action& a : allActions()) {
    if (a.panel != panel) continue;
    KeyRow row{withoutEllipsis(a.label), keysOf(a)};
    if (row.keys.empty()) continue;
    bool joined = false;
    for (auto& [index, last] : series) {
      KeyRow& first = section.rows[index];
      if (!continues({first.what, first.keys}, row, last)) continue;
      last = row.what.back();
      joined = true;
      break;
    }
    if (joined) continue;
    if (digitAtEnd(row.what) && digitAtEnd(row.keys))
      series.push_back({section.rows.size(), row.what.back()});
    section.rows.push_back(std::move(row));
  }
  for (const auto& [index, last] : series) {
    KeyRow& row = section.rows[index];
    if (last == row.what.back()) continue;
    row.what += fmt::format(" to {}", last);
    row.keys += fmt::format(" to {}", last);
  }
  for (const Gesture& g : kGestures)
    if (g.panel == panel) section.rows.push_back({g.what, g.keys});
  return section;
}

}  // namespace

std::vector<KeySection> keyboardMap() {
  std::vector<KeySection> map{sectionOf(Panel::Global, "Everywhere")};
  for (const PanelInfo& info : allPanels()) map.push_back(sectionOf(info.panel, info.title));
  std::erase_if(map, [](const KeySection& s) { return s.rows.empty(); });
  return map;
}

std::string keyboardMarkdown() {
  std::string text =
      "# Keyboard and mouse\n\nWritten by `pileus keys --markdown` from the table of commands. Keys act on "
      "the "
      "panel under the pointer; those of the first table everywhere. Every command is also found by name: "
      "F3.\n";
  for (const KeySection& s : keyboardMap()) {
    text += "\n## " + s.title + "\n\n| what | how |\n|---|---|\n";
    for (const KeyRow& row : s.rows) text += "| " + row.what + " | " + row.keys + " |\n";
  }
  return text;
}

std::string keyboardText() {
  std::string text;
  for (const KeySection& s : keyboardMap()) {
    text += s.title + "\n";
    for (const KeyRow& row : s.rows) text += fmt::format("  {:44} {}\n", row.what, row.keys);
  }
  return text;
}

}  // namespace pileus::editor
