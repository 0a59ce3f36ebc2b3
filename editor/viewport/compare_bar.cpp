#include "editor/viewport/compare_bar.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/picture/shown.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/segments.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

void chooseScale(Ui& ui, Shown& shown) {
  CompareMode& mode = shown.compare;
  const bool shadow = mode.of == CompareOf::Shadow;
  double& scale = shadow ? mode.shadowScale : mode.radianceScale;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Scale");
  ImGui::SameLine();
  NumberField field;
  field.softMin = shadow ? 0.001 : 1e-4, field.softMax = shadow ? 1 : 100;
  field.hardMin = 1e-6, field.hardMax = shadow ? 1 : 1e6;
  field.logarithmic = true;
  const NumberEdit edit =
      numberField(ui.fields.number, ui.theme, "##compare scale", scale, field, ui.theme.px(84));
  ui.trace.item("compare/scale");
  if (edit.changed && !shadow) mode.autoScale = false;
  if (ImGui::IsItemHovered() && !edit.dragging)
    tooltip(ui.theme,
            shadow
                ? "The error in T shown in the strongest colours"
                : "The error in radiance shown in the strongest colours. Right click: follow the picture.");
  if (!shadow && ImGui::IsItemClicked(1)) mode.autoScale = true;
  if (!shadow) return;
  ImGui::SameLine(0, ui.theme.space(3));
  if (segment(ui, "compare/worst", "Worst",
              "The largest error on a pixel's ray, not the mean of what is seen", mode.worst, true, true))
    mode.worst = !mode.worst;
}

std::string progressText(const Shown& shown) {
  const CompareMode& mode = shown.compare;
  if (!mode.error.empty()) return {};
  if (!mode.coarse) return "Truth waits for the picture";
  const double fraction = compareFraction(mode), left = compareSecondsLeft(mode);
  if (fraction >= 1) return "Truth complete";
  if (mode.coarse->fraction() >= 1 && !shown.preview.settled())
    return "Truth goes on with the finished picture";
  // Rounded down, but never to nothing for long.
  const std::string done = fraction < 0.1 ? fmt::format("{:.1f}", std::floor(1000 * fraction) / 10)
                                          : fmt::format("{:.0f}", std::floor(100 * fraction));
  if (left < 0) return fmt::format("Truth {} %", done);
  return fmt::format("Truth {} %, about {} left", done,
                     left < 99.5     ? fmt::format("{:.0f} s", std::max(left, 1.0))
                     : left < 5970.0 ? fmt::format("{:.0f} min", left / 60)
                                     : fmt::format("{:.0f} h", left / 3600));
}

}  // namespace

void drawCompareBar(Ui& ui, Shown& shown, ImVec2 min, ImVec2 max) {
  const Theme& theme = ui.theme;
  CompareMode& mode = shown.compare;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(min, max, palette::kPanel);
  draw->AddLine(min, {max.x, min.y}, palette::kLine);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  // In a small panel the choices are lists.
  const float wanted =
      segmentsWidth(theme, mode.layout) + segmentsWidth(theme, mode.of) + theme.space(8) +
      (mode.of == CompareOf::Radiance ? segmentsWidth(theme, mode.against) + theme.space(3) : 0) +
      (mode.layout == CompareLayout::Error ? theme.px(190) : 0);
  const float there = max.x - min.x - (max.y - min.y);
  const float lists = mode.of == CompareOf::Radiance ? 3 : 2;
  const float gaps = theme.space(4) + (lists - 1) * theme.space(3) +
                     (mode.layout == CompareLayout::Error ? theme.px(190) : 0);
  const float room = wanted > there ? std::max((there - gaps) / lists, theme.px(40)) : 0;
  ImGui::BeginGroup();
  segments(ui, "compare", mode.layout, room);
  ImGui::SameLine(0, theme.space(3));
  segments(ui, "compare/of", mode.of, room);
  if (mode.of == CompareOf::Radiance) {
    ImGui::SameLine(0, theme.space(3));
    segments(ui, "compare/against", mode.against, room);
  }
  if (mode.layout == CompareLayout::Error) {
    ImGui::SameLine(0, theme.space(4));
    chooseScale(ui, shown);
  }
  ImGui::EndGroup();
  const float used = ImGui::GetItemRectMax().x;

  const float side = max.y - min.y, cross = max.x - side;
  ImGui::SetCursorScreenPos({cross, min.y});
  if (ImGui::InvisibleButton("compare close", {side, side})) toggleCompare(ui.messages, shown);
  ui.trace.item("compare/close");
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) tooltip(theme, "Leave compare mode (Tab)");
  drawText(draw, theme.small,
           {cross + 0.5f * (side - textWidth(theme.small, icon::kTimes)),
            min.y + 0.5f * (side - theme.small->FontSize)},
           hovered ? palette::kText : palette::kTextDim, icon::kTimes, side);

  const std::string text = progressText(shown);
  ui.trace.note("compare progress", text);
  const float width = textWidth(theme.small, text);
  if (cross - theme.space(2) - width > used + theme.space(3))
    drawText(draw, theme.small,
             {cross - theme.space(2) - width, min.y + 0.5f * (side - theme.small->FontSize)},
             palette::kTextDim, text, width + 1);
}

}  // namespace pileus::editor
