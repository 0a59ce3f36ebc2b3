#include "editor/graph_view/search/search_chips.h"

#include <imgui.h>

#include <algorithm>

#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

void walk(NodeSearch& search, const std::vector<std::string>& categories) {
  if (!ImGui::GetIO().KeyAlt) return;
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  const int by = (pressed(ImGuiKey_RightArrow) ? 1 : 0) - (pressed(ImGuiKey_LeftArrow) ? 1 : 0);
  if (by == 0) return;
  const auto count = static_cast<int>(categories.size()) + 1;  // the first place: all
  const auto it = std::find(categories.begin(), categories.end(), search.category);
  int at = it == categories.end() ? 0 : static_cast<int>(it - categories.begin()) + 1;
  at = (at + by + count) % count;
  search.category = at == 0 ? std::string() : categories[static_cast<std::size_t>(at - 1)];
  search.chosen = 0, search.scrollToChosen = true;
}

}  // namespace

std::vector<std::string> searchCategories(const Canvas& canvas) {
  std::vector<std::string> all;
  for (const SearchItem& item : canvas.search.items)
    if (std::find(all.begin(), all.end(), categoryOf(item)) == all.end()) all.push_back(categoryOf(item));
  return all;
}

void drawCategoryChips(Ui& ui, Canvas& canvas) {
  NodeSearch& search = canvas.search;
  const std::vector<std::string> categories = searchCategories(canvas);
  if (categories.size() < 2) return;
  const Theme& theme = ui.theme;
  walk(search, categories);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float height = theme.small->FontSize + theme.px(6), pad = theme.px(7), gap = theme.px(4);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  bool first = true;
  for (const std::string& category : categories) {
    const float width = textWidth(theme.small, category) + 2 * pad;
    if (!first) {
      ImGui::SameLine();
      if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    }
    first = false;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(category.c_str(), {width, height})) {
      search.category = search.category == category ? std::string() : category;
      search.chosen = 0, search.scrollToChosen = true;
    }
    ui.trace.item("search/category/" + category);
    const bool on = search.category == category, over = ImGui::IsItemHovered();
    const ImU32 color = categoryColor(category);
    draw->AddRectFilled(at, {at.x + width, at.y + height},
                        on     ? color
                        : over ? palette::kButtonHover
                               : palette::kButton,
                        0.5f * height);
    drawText(draw, theme.small, {at.x + pad, at.y + theme.px(3)},
             on ? palette::kTextStrong : palette::kTextDim, category, width);
  }
  ImGui::PopStyleVar();
}

void drawSearchKeys(const Theme& theme, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const char* keys = "Enter adds    Up, Down choose    Alt+Left, Alt+Right category    Esc closes";
  ImGui::Dummy({width, theme.small->FontSize + theme.px(4)});
  drawText(ImGui::GetWindowDrawList(), theme.small, {at.x + theme.px(6), at.y + theme.px(3)},
           palette::kTextFaint, keys, width - theme.px(10));
}

}  // namespace pileus::editor
