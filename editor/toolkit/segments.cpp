#include "editor/toolkit/segments.h"

#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {

float segmentWidth(const Theme& theme, std::string_view label) {
  return textWidth(theme.body, label) + 2 * theme.space(3);
}

bool segment(Ui& ui, const std::string& trace, std::string_view label, std::string_view help, bool on,
             bool first, bool last) {
  const Theme& theme = ui.theme;
  const float width = segmentWidth(theme, label), height = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos(), end = {at.x + width, at.y + height};
  const bool clicked = ImGui::InvisibleButton(trace.c_str(), {width, height});
  const bool hovered = ImGui::IsItemHovered();
  ui.trace.item(trace);
  const ImDrawFlags corners = first && last ? ImDrawFlags_RoundCornersAll
                              : first       ? ImDrawFlags_RoundCornersLeft
                              : last        ? ImDrawFlags_RoundCornersRight
                                            : ImDrawFlags_RoundCornersNone;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, end,
                      on        ? palette::kAccentDim
                      : hovered ? palette::kFieldHover
                                : palette::kField,
                      theme.px(4), corners);
  drawText(draw, theme.body, {at.x + theme.space(3), at.y + 0.5f * (height - theme.body->FontSize)},
           on        ? palette::kTextStrong
           : hovered ? palette::kText
                     : palette::kTextDim,
           label, width);
  if (hovered && !help.empty()) tooltip(theme, help);
  return clicked;
}

}  // namespace pileus::editor
