#include "editor/status/log_panel.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/segments.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using log::Level;

constexpr Level kLevels[] = {Level::Error, Level::Warning, Level::Info, Level::Debug};
constexpr const char* kNames[] = {"Debug", "Info", "Warnings", "Errors"};
constexpr const char* kMarks[] = {icon::kTerminal, icon::kInfo, icon::kWarning, icon::kError};

std::size_t index(Level level) { return static_cast<std::size_t>(level); }

std::size_t total() {
  std::size_t n = 0;
  for (const Level l : kLevels) n += log::count(l);
  return n;
}

ImU32 inkOf(Level level) {
  return level == Level::Error     ? palette::kError
         : level == Level::Warning ? palette::kWarning
         : level == Level::Debug   ? palette::kTextFaint
                                   : palette::kText;
}

bool contains(std::string_view text, std::string_view words) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return words.empty() ||
         std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end();
}

/// Returns whether the list has changed.
bool update(LogPanel& panel) {
  const std::size_t now = total();
  std::string key = fmt::format("{} {} ", now, panel.cleared);
  for (const bool on : panel.levels) key += on ? '1' : '0';
  key += panel.words;
  if (key == panel.key) return false;
  panel.key = std::move(key);
  panel.lines.clear();
  std::vector<log::Line> all = log::history();
  // The history forgets its oldest lines: what was cleared is counted from its end.
  const std::size_t fresh = std::min(now - std::min(panel.cleared, now), all.size());
  for (std::size_t i = all.size() - fresh; i < all.size(); ++i)
    if (panel.levels[index(all[i].level)] && contains(all[i].text, panel.words))
      panel.lines.push_back(std::move(all[i]));
  return true;
}

std::string textOf(const log::Line& line) {
  constexpr const char* kWords[] = {"debug", "info", "warning", "error"};
  return fmt::format("{:10.2f}  {:7}  {}", line.seconds, kWords[index(line.level)], line.text);
}

void copyAll(Ui& ui, const LogPanel& logPanel) {
  std::string text;
  for (const log::Line& line : logPanel.lines) text += textOf(line) + "\n";
  ImGui::SetClipboardText(text.c_str());
  ui.messages.note(fmt::format("Copied {} lines.", logPanel.lines.size()));
}

void clear(LogPanel& panel) {
  panel.cleared = total();
  for (const Level l : kLevels) panel.clearedAt[index(l)] = log::count(l);
}

bool quietButton(Ui& ui, const char* label, const char* trace) {
  ImGui::SameLine();
  const bool pressed = ImGui::Button(label);
  ui.trace.item(trace);
  return pressed;
}

void drawBar(Ui& ui, LogPanel& logPanel, ImVec2 min, ImVec2 max) {
  const Theme& theme = ui.theme;
  LogPanel& panel = logPanel;
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  bool first = true;
  for (const Level l : kLevels) {
    if (!first) ImGui::SameLine(0, 1);
    const std::string label = fmt::format("{} {}", kNames[index(l)], panel.count(l));
    if (segment(ui, std::string("log/") + kNames[index(l)], label, "Show or hide these lines",
                panel.levels[index(l)], first, l == Level::Debug))
      panel.levels[index(l)] = !panel.levels[index(l)];
    first = false;
  }
  ImGui::SameLine(0, theme.space(3));
  const float buttons = theme.px(250), close = theme.px(36);
  const float room = max.x - close - buttons - ImGui::GetCursorScreenPos().x;
  if (room > theme.px(70)) {
    ImGui::SetNextItemWidth(std::min(room, theme.px(260)));
    ImGui::InputTextWithHint("##words", "Search", &panel.words);
    ui.trace.item("log/search");
    ImGui::SameLine();
  }
  ImGui::Checkbox("Follow", &panel.follow);
  ui.trace.item("log/follow");
  if (quietButton(ui, "Copy", "log/copy")) copyAll(ui, logPanel);
  if (quietButton(ui, "Clear", "log/clear")) clear(panel);
  ImGui::SetCursorScreenPos({max.x - close, min.y});
  if (ImGui::InvisibleButton("log close", {close, close})) ui.requests.push(ShowPanel{Panel::Log, false});
  ui.trace.item("log/close");
  drawText(ImGui::GetWindowDrawList(), theme.small,
           {max.x - 0.5f * (close + textWidth(theme.small, icon::kTimes)),
            min.y + 0.5f * (close - theme.small->FontSize)},
           ImGui::IsItemHovered() ? palette::kText : palette::kTextDim, icon::kTimes, close);
}

void drawLine(Ui& ui, const log::Line& line, int row) {
  const Theme& theme = ui.theme;
  const ImU32 ink = inkOf(line.level);
  ImGui::PushID(row);
  // The whole row is one thing to point at: a click copies it.
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered, faded(palette::kRowHover, 0.5f));
  if (ImGui::Selectable("##line", false, ImGuiSelectableFlags_AllowItemOverlap, {0, theme.mono->FontSize})) {
    ImGui::SetClipboardText(textOf(line).c_str());
    ui.messages.note("Copied the line.");
  }
  ImGui::PopStyleColor();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const std::string time = fmt::format("{:9.2f}", line.seconds);
  drawText(draw, theme.mono, {at.x, at.y}, palette::kTextFaint, time, theme.px(90));
  drawText(draw, theme.small, {at.x + theme.px(94), at.y + theme.px(1)}, ink, kMarks[index(line.level)],
           theme.px(20));
  ImGui::SameLine(theme.px(118));
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  const std::size_t end = line.text.find('\n');
  ImGui::TextUnformatted(line.text.c_str(), end == std::string::npos ? nullptr : line.text.c_str() + end);
  ImGui::PopStyleColor();
  if (end != std::string::npos && ImGui::IsItemHovered()) tooltip(theme, line.text);
  ImGui::PopID();
}

}  // namespace

std::size_t LogPanel::count(Level level) const {
  return log::count(level) - std::min(clearedAt[index(level)], log::count(level));
}

void showLog(Ui& ui, LogPanel& logPanel, Level level) {
  for (const Level l : kLevels)
    if (l >= level) logPanel.levels[index(l)] = true;
  logPanel.words.clear();
  ui.requests.push(ShowPanel{Panel::Log});
}

void drawLog(Ui& ui, LogPanel& logPanel, ImVec2 min, ImVec2 max) {
  const Theme& theme = ui.theme;
  LogPanel& panel = logPanel;
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  drawBar(ui, logPanel, min, max);
  const float bar = theme.px(36);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + bar});
  ImGui::BeginChild("lines", {max.x - min.x - theme.space(3), max.y - min.y - bar - theme.space(1)}, false,
                    ImGuiWindowFlags_HorizontalScrollbar);
  const bool grown = update(panel);
  ImGui::PushFont(theme.mono);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(panel.lines.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      drawLine(ui, panel.lines[static_cast<std::size_t>(i)], i);
  ImGui::PopFont();
  if (panel.lines.empty())
    ImGui::TextDisabled(panel.key.empty() || total() == 0 ? "Nothing has been logged."
                                                          : "No line passes the filters.");
  if (panel.follow && (grown || ImGui::IsWindowAppearing())) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
  ui.trace.rect("log", min, max);
  ui.trace.note("log", std::to_string(panel.lines.size()));
}

}  // namespace pileus::editor
