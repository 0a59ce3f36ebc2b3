#include "editor/commands/shortcut_sheet.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "editor/editor.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/fields.h"
#include "editor/toolkit/modals.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui_trace.h"

namespace pileus::editor {
namespace {

bool contains(std::string_view text, std::string_view words) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return words.empty() ||
         std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end();
}

constexpr float kRow = 22, kHead = 34;

/// `y` is where the column has come to.
void drawRow(const Theme& theme, float x, float& y, float width, const KeyRow& row) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float keys = std::min(textWidth(theme.small, row.keys), 0.6f * width);
  const float left =
      drawText(draw, theme.body, {x, y}, palette::kText, row.what, width - keys - theme.space(3));
  const float middle = y + 0.55f * theme.body->FontSize;
  // Dots lead the eye from a short name to its keys.
  for (float dot = x + left + theme.space(2); dot < x + width - keys - theme.space(2); dot += theme.px(6))
    draw->AddRectFilled({dot, middle}, {dot + theme.px(1), middle + theme.px(1)}, palette::kLine);
  drawText(draw, theme.small, {x + width - keys, y + theme.px(1)}, palette::kTextDim, row.keys, keys + 1);
  y += theme.px(kRow);
}

}  // namespace

void drawShortcutSheet(Editor& editor) {
  const Theme& theme = editor.theme;
  ShortcutSheet& sheet = editor.sheet;
  if (ImGui::IsWindowAppearing()) {
    sheet.map = keyboardMap();
    sheet.words.clear();
    editor.fields.focusHere();
  }
  ImGui::SetNextItemWidth(theme.px(260));
  ImGui::InputTextWithHint("##words", "Search", &sheet.words);
  editor.trace.item("shortcuts/search");
  ImGui::SameLine(0, theme.space(3));
  ImGui::TextDisabled("Keys act on the panel under the pointer.");

  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::BeginChild("sheet", {0, std::min(theme.px(560), display.y * 0.66f)});
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float whole = ImGui::GetContentRegionAvail().x - theme.space(2), gap = theme.space(8);
  const int columns = whole > theme.px(980) ? 3 : whole > theme.px(560) ? 2 : 1;
  const float width = (whole - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  // Sections go to the column that is shortest so far, in order.
  std::vector<float> y(static_cast<std::size_t>(columns), origin.y);
  std::size_t shown = 0;
  for (const KeySection& section : sheet.map) {
    std::vector<const KeyRow*> rows;
    for (const KeyRow& row : section.rows)
      if (contains(row.what, sheet.words) || contains(row.keys, sheet.words)) rows.push_back(&row);
    if (rows.empty()) continue;
    shown += rows.size();
    const std::size_t column = static_cast<std::size_t>(std::min_element(y.begin(), y.end()) - y.begin());
    const float x = origin.x + static_cast<float>(column) * (width + gap);
    if (y[column] > origin.y) y[column] += theme.space(2);
    drawText(ImGui::GetWindowDrawList(), theme.strong, {x, y[column] + theme.space(1)}, palette::kTextStrong,
             section.title, width);
    y[column] += theme.px(kHead) - theme.space(1);
    for (const KeyRow* row : rows) drawRow(theme, x, y[column], width, *row);
  }
  if (shown == 0) ImGui::TextDisabled("No command or key has that in its name.");
  ImGui::Dummy({1, *std::max_element(y.begin(), y.end()) - origin.y});
  ImGui::EndChild();
  editor.trace.note("shortcuts", std::to_string(shown));
}

}  // namespace pileus::editor
