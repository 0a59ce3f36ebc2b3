#include "editor/toolkit/widgets.h"

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"

namespace pileus::editor {

bool beginCombo(const Theme& theme, const char* id, std::string_view shown, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(id, "", ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLarge);
  // Within an open combo the window is the list: draw on the one below.
  ImDrawList* draw = open ? ImGui::GetForegroundDrawList() : ImGui::GetWindowDrawList();
  const float x = at.x + width - theme.px(15), y = at.y + 0.5f * height, r = theme.px(3.5f);
  drawText(draw, theme.body, {at.x + theme.space(2), y - 0.5f * theme.body->FontSize}, palette::kText, shown,
           width - theme.px(32));
  const ImVec2 chevron[3] = {{x - r, y - 0.5f * r}, {x, y + 0.5f * r}, {x + r, y - 0.5f * r}};
  draw->AddPolyline(chevron, 3, palette::kTextDim, 0, 1.5f * theme.scale);
  return open;
}

void tooltip(const Theme& theme, std::string_view text, ImU32 ink) {
  if (CutTexts* cut = cutTexts()) cut->told += text;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(theme.px(360));
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

std::string tellCutText(const Theme& theme) {
  const CutTexts* cut = cutTexts();
  if (!cut || cut->under.empty() || cut->told.find(cut->under) != std::string::npos) return {};
  const std::string text = cut->under;
  tooltip(theme, text);
  return text;
}

}  // namespace pileus::editor
