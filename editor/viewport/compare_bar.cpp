#include "editor/viewport/compare_bar.h"

#include <fmt/core.h>

#include <cmath>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/segments.h"

namespace pileus::editor {
namespace {

void chooseScale(Editor& editor) {
  CompareMode& mode = editor.compare;
  const bool shadow = mode.of == CompareOf::Shadow;
  double& scale = shadow ? mode.shadowScale : mode.radianceScale;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Scale");
  ImGui::SameLine();
  NumberField field;
  field.softMin = shadow ? 0.001 : 1e-4, field.softMax = shadow ? 1 : 100;
  field.hardMin = 1e-6, field.hardMax = shadow ? 1 : 1e6;
  field.logarithmic = true;
  const NumberEdit edit = numberField(editor.parameters.numbers, editor.theme, "##compare scale", scale,
                                      field, editor.theme.px(84));
  editor.trace.item("compare/scale");
  if (edit.changed && !shadow) mode.autoScale = false;
  if (ImGui::IsItemHovered() && !edit.dragging)
    tooltip(editor.theme,
            shadow
                ? "The error in T shown in the strongest colours"
                : "The error in radiance shown in the strongest colours. Right click: follow the picture.");
  if (!shadow && ImGui::IsItemClicked(1)) mode.autoScale = true;
  if (!shadow) return;
  ImGui::SameLine(0, editor.theme.space(3));
  if (segment(editor, "compare/worst", "Worst",
              "The largest error on a pixel's ray, not the mean of what is seen", mode.worst, true, true))
    mode.worst = !mode.worst;
}

std::string progressText(const Editor& editor) {
  const CompareMode& mode = editor.compare;
  if (!mode.error.empty()) return {};
  if (!mode.coarse) return "Truth waits for the picture";
  const double fraction = compareFraction(mode);
  if (fraction >= 1) return "Truth complete";
  return fmt::format("Truth {} %", static_cast<int>(std::floor(100 * fraction)));
}

}  // namespace

void drawCompareBar(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  CompareMode& mode = editor.compare;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(min, max, palette::kPanel);
  draw->AddLine(min, {max.x, min.y}, palette::kLine);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  ImGui::BeginGroup();
  segments(editor, "compare", mode.layout);
  ImGui::SameLine(0, theme.space(3));
  segments(editor, "compare/of", mode.of);
  if (mode.layout == CompareLayout::Error) {
    ImGui::SameLine(0, theme.space(4));
    chooseScale(editor);
  }
  ImGui::EndGroup();
  const float used = ImGui::GetItemRectMax().x;

  const float side = max.y - min.y, cross = max.x - side;
  ImGui::SetCursorScreenPos({cross, min.y});
  if (ImGui::InvisibleButton("compare close", {side, side})) toggleCompare(editor);
  editor.trace.item("compare/close");
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) tooltip(theme, "Leave compare mode (Tab)");
  drawText(draw, theme.small,
           {cross + 0.5f * (side - textWidth(theme.small, icon::kTimes)),
            min.y + 0.5f * (side - theme.small->FontSize)},
           hovered ? palette::kText : palette::kTextDim, icon::kTimes, side);

  const std::string text = progressText(editor);
  editor.trace.note("compare progress", text);
  const float width = textWidth(theme.small, text);
  if (cross - theme.space(2) - width > used + theme.space(3))
    drawText(draw, theme.small,
             {cross - theme.space(2) - width, min.y + 0.5f * (side - theme.small->FontSize)},
             palette::kTextDim, text, width + 1);
}

}  // namespace pileus::editor
