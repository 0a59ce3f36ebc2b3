#include "editor/commands/command_palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "editor/commands/actions.h"
#include "editor/commands/files.h"
#include "editor/commands/menu.h"
#include "editor/document/preset_shelf.h"
#include "editor/editor.h"
#include "editor/exchange/requests.h"
#include "editor/graph_view/search/fuzzy.h"
#include "editor/preferences/panel_list.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/fields.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/ui_trace.h"
#include "embedded_presets.h"

namespace pileus::editor {
namespace {

constexpr char kPopup[] = "##commands";
constexpr float kWidth = 560, kRow = 30, kRows = 12;

std::vector<PaletteEntry> allCommands(const Editor& editor) {
  std::vector<PaletteEntry> all;
  for (const Action& a : allActions()) {
    PaletteEntry c;
    c.id = a.id, c.label = a.label, c.place = menuOf(a), c.keys = shortcutText(a.keys[0]);
    if (c.place.empty()) c.place = a.panel == Panel::Global ? "" : panelInfo(a.panel).title;
    std::replace(c.place.begin(), c.place.end(), '/', ' ');
    c.enabled = !a.enabled || a.enabled(editor);
    c.checked = a.checked && a.checked(editor);
    c.panel = a.panel;
    c.request = RunCommand{a.id};
    all.push_back(std::move(c));
  }
  for (const EmbeddedFile& file : embedded_presets()) {
    if (file.path.find('/') != std::string_view::npos || !file.path.ends_with(".json")) continue;
    const std::string name(file.path);
    all.push_back(
        {presetLabel(name), "Preset", "", "preset:" + name, true, false, Panel::Global, OpenPreset{name}});
  }
  for (const nodes::PresetEntry& e : editor.presets.entries())
    if (e.fault.empty())
      all.push_back({e.name, "Preset", "", "preset:" + e.file.string(), true, false, Panel::Global,
                     UsePreset{e.file, {}, {}}});
  std::error_code ec;
  for (const std::string& path : editor.settings.recentFiles)
    all.push_back({std::filesystem::path(path).filename().string(), "Recent file", "", "file:" + path,
                   std::filesystem::exists(path, ec), false, Panel::Global, OpenFile{path}});
  return all;
}

void drawRow(Editor& editor, const PaletteEntry& command, int row, float width, int& clicked) {
  const Theme& theme = editor.theme;
  CommandPalette& palette = editor.commands;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = theme.px(kRow), y = at.y + 0.5f * (height - theme.body->FontSize),
              ySmall = at.y + 0.5f * (height - theme.small->FontSize);
  ImGui::PushID(row);
  if (ImGui::InvisibleButton("row", {width, height})) clicked = row;
  if (ImGui::IsItemHovered() && (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0))
    palette.chosen = row;
  editor.trace.item("commands/" + std::to_string(row));
  editor.trace.note("commands/" + std::to_string(row), command.id);
  ImGui::PopID();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const bool chosen = row == palette.chosen;
  if (chosen) draw->AddRectFilled(at, {at.x + width, at.y + height}, palette::kAccentDim, theme.px(4));
  const char* mark = command.checked ? icon::kCheck : actionIcon(command.id);
  if (command.id.starts_with("preset:")) mark = icon::kCloud;
  if (command.id.starts_with("file:")) mark = icon::kClock;
  const ImU32 ink = !command.enabled ? palette::kTextFaint : chosen ? palette::kTextStrong : palette::kText;
  const ImU32 quiet = chosen ? palette::kText : palette::kTextDim;
  if (mark) drawText(draw, theme.small, {at.x + theme.space(2), ySmall}, quiet, mark, theme.px(20));
  float right = at.x + width - theme.space(2);
  if (!command.keys.empty()) {
    right -= textWidth(theme.small, command.keys);
    drawText(draw, theme.small, {right, ySmall}, quiet, command.keys, width);
    right -= theme.space(4);
  }
  const float left = at.x + theme.space(8);
  const float label = drawText(draw, theme.body, {left, y}, ink, command.label, right - left);
  if (right - left - label > theme.space(10))
    drawText(draw, theme.small, {left + label + theme.space(3), ySmall},
             command.enabled ? quiet : palette::kTextFaint, command.place,
             right - left - label - theme.space(3));
}

void moveChosen(CommandPalette& p) {
  const int before = p.chosen;
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  if (pressed(ImGuiKey_DownArrow)) ++p.chosen;
  if (pressed(ImGuiKey_UpArrow)) --p.chosen;
  if (pressed(ImGuiKey_PageDown)) p.chosen += static_cast<int>(kRows) - 1;
  if (pressed(ImGuiKey_PageUp)) p.chosen -= static_cast<int>(kRows) - 1;
  p.chosen = std::clamp(p.chosen, 0, std::max(static_cast<int>(p.found.size()) - 1, 0));
  if (p.chosen != before) p.scrollToChosen = true;
}

/// Returns the row that was chosen to run; -1: none.
int drawRows(Editor& editor) {
  CommandPalette& p = editor.commands;
  const Theme& theme = editor.theme;
  const float rows = std::clamp(static_cast<float>(p.found.size()), 1.0f, kRows);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("rows", {0, rows * theme.px(kRow)});
  int clicked = -1;
  const float width = ImGui::GetContentRegionAvail().x;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(p.found.size()), theme.px(kRow));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      drawRow(editor, p.found[static_cast<std::size_t>(i)], i, width, clicked);
  if (p.found.empty()) {
    ImGui::SetCursorPos({theme.space(2), theme.px(6)});
    ImGui::TextDisabled("Nothing is called that.");
  }
  if (std::exchange(p.scrollToChosen, false)) {
    const float top = static_cast<float>(p.chosen) * theme.px(kRow), view = ImGui::GetWindowHeight();
    if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
    if (top + theme.px(kRow) > ImGui::GetScrollY() + view) ImGui::SetScrollY(top + theme.px(kRow) - view);
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  return clicked;
}

}  // namespace

std::vector<PaletteEntry> findCommands(const Editor& editor, const std::string& query) {
  std::vector<PaletteEntry> all = allCommands(editor);
  const std::vector<std::string>& recent = editor.settings.recentCommands;
  struct Rank {
    std::size_t index;
    int score;
  };
  std::vector<Rank> ranks;
  for (std::size_t i = 0; i < all.size(); ++i) {
    // "view light theme" finds it as "light theme" does, only a little later.
    const std::optional<int> label = fuzzyScore(query, all[i].label);
    const std::optional<int> whole = fuzzyScore(query, all[i].place + " " + all[i].label);
    if (!label && !whole) continue;
    const auto used = static_cast<int>(std::find(recent.begin(), recent.end(), all[i].id) - recent.begin());
    const int fresh = used < static_cast<int>(recent.size()) ? 12 - used : 0;
    int score = std::max(label.value_or(-1000), whole.value_or(-1000) - 4);
    score += query.empty() ? 100 * std::max(fresh, 0) : std::max(fresh, 0) / 3;
    ranks.push_back({i, all[i].enabled ? score : score - 2});
  }
  std::stable_sort(ranks.begin(), ranks.end(),
                   [](const Rank& a, const Rank& b) { return a.score > b.score; });
  std::vector<PaletteEntry> found;
  for (const Rank& r : ranks) found.push_back(std::move(all[r.index]));
  return found;
}

void drawCommandPalette(Editor& editor) {
  CommandPalette& p = editor.commands;
  const Theme& theme = editor.theme;
  if (std::exchange(p.opening, false)) {
    p.query.clear();
    p.chosen = 0;
    p.foundFor = "\n";
    ImGui::OpenPopup(kPopup);
  }
  if (!ImGui::IsPopupOpen(kPopup)) return;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({std::round(display.x * 0.5f), std::round(display.y * 0.14f)}, ImGuiCond_Always,
                          {0.5f, 0});
  ImGui::SetNextWindowSize({std::min(theme.px(kWidth), display.x - theme.space(8)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(2), theme.space(2)});
  const bool open = ImGui::BeginPopup(kPopup, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  if (!open) return;
  if (ImGui::IsWindowAppearing()) editor.fields.focusHere();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##query", "Type a command, a preset or a recent file", &p.query);
  editor.trace.item("commands/field");
  if (p.foundFor != p.query) {
    p.foundFor = p.query;
    p.found = findCommands(editor, p.query);
    p.chosen = 0;
    p.scrollToChosen = true;
  }
  moveChosen(p);
  int run = drawRows(editor);
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) && !p.found.empty()) run = p.chosen;
  if (run >= 0 && p.found[static_cast<std::size_t>(run)].enabled) {
    const PaletteEntry command = p.found[static_cast<std::size_t>(run)];
    remember(editor.settings.recentCommands, command.id);
    ImGui::CloseCurrentPopup();
    if (command.panel != Panel::Global) editor.requests.push(ShowPanel{command.panel});
    editor.requests.push(command.request);
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
