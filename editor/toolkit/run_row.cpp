#include "editor/toolkit/run_row.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {

RunClick runRow(Ui& ui, const std::string& prefix, const char* label, bool running, bool ready, bool waits,
                double fraction, const std::string& doing, float width) {
  const Theme& theme = ui.theme;
  RunClick click = RunClick::None;
  const float button = theme.px(84);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (running) {
    if (ImGui::Button("Cancel", {button, 0})) click = RunClick::Stop;
    ui.trace.item(prefix + "/cancel");
  } else {
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
    ImGui::BeginDisabled(!ready);
    if (ImGui::Button(label, {button, 0})) click = RunClick::Start;
    ImGui::EndDisabled();
    ImGui::PopStyleColor();
    ui.trace.item(prefix + "/run");
    return click;
  }
  const float height = ImGui::GetFrameHeight(), x = at.x + button + theme.space(3), y = at.y + 0.5f * height,
              bar = std::min(theme.px(110), width - button - theme.space(6));
  if (bar < theme.px(30)) return click;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({x, y - theme.px(3)}, {x + bar, y + theme.px(3)}, palette::kField, theme.px(3));
  draw->AddRectFilled({x, y - theme.px(3)},
                      {x + bar * static_cast<float>(std::clamp(fraction, 0.0, 1.0)), y + theme.px(3)},
                      palette::kAccent, theme.px(3));
  const std::string text = fmt::format("{} %  {}", static_cast<int>(std::floor(100 * fraction)),
                                       waits ? "Waits for the picture" : doing);
  drawText(draw, theme.small, {x + bar + theme.space(2), y - 0.5f * theme.small->FontSize}, palette::kTextDim,
           text, std::max(width - (x + bar + theme.space(2) - at.x), 1.0f));
  ui.trace.note(prefix + " doing", text);
  return click;
}

}  // namespace pileus::editor
