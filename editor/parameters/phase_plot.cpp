#include "editor/parameters/phase_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "editor/document/session.h"
#include "editor/parameters/parameter_room.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "nodes/declare/value.h"

namespace pileus::editor {
namespace {

constexpr int kPoints = 361;           ///< around, more of them where a lobe may be sharp
constexpr double kLeastDecades = 1.5;  ///< shown, so that an even one is a circle and not a dot

std::optional<scene::Phase> phaseOf(const ParameterRoom& room, const std::string& name) {
  const nodes::SocketValue* value =
      room.shown.preview.evaluator().output(room.session.document.scopedName(name), "volume");
  const auto* volumes = value ? std::get_if<nodes::VolumeValue>(value) : nullptr;
  if (!volumes) return {};
  for (const volume::Instance& i : volumes->items)
    if (!i.emission) return i.medium.phase;
  return {};
}

/// Angles from -pi to pi, cubed, so that a lobe a hundredth of a degree wide is not cut off.
double angleOf(int i) {
  const double s = 2.0 * i / (kPoints - 1) - 1;
  return kPi * s * s * s;
}

}  // namespace

void drawPhasePlot(const ParameterRoom& room, const std::string& name) {
  const std::optional<scene::Phase> phase = phaseOf(room, name);
  if (!phase) return;
  const Theme& theme = room.ui.theme;
  std::array<double, kPoints> logs;
  double least = 1e30, most = -1e30;
  for (int i = 0; i < kPoints; ++i) {
    logs[std::size_t(i)] = std::log10(std::max(scene::phaseValue(*phase, std::cos(angleOf(i))), 1e-12));
    least = std::min(least, logs[std::size_t(i)]), most = std::max(most, logs[std::size_t(i)]);
  }
  // The innermost ring is a decade below the least; rings are whole decades of 1/sr.
  const double inner = std::floor(least) - 1, outer = std::max(most, inner + kLeastDecades);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = std::min(width, theme.px(180)),
              radius = 0.5f * height - theme.px(6);
  const ImVec2 middle{at.x + 0.5f * width, at.y + 0.5f * height};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (double decade = inner + 1; decade <= outer; ++decade) {
    const float r = radius * float((decade - inner) / (outer - inner));
    draw->AddCircle(middle, r, faded(palette::kTextFaint, 0.35f), 64);
  }
  const float reach = 0.5f * width - theme.px(2);
  draw->AddLine({middle.x - reach, middle.y}, {middle.x + reach, middle.y}, faded(palette::kTextFaint, 0.5f));
  std::array<ImVec2, kPoints> line;
  for (int i = 0; i < kPoints; ++i) {
    const double r = double(radius) * (logs[std::size_t(i)] - inner) / (outer - inner), a = angleOf(i);
    line[std::size_t(i)] = {middle.x + float(r * std::cos(a)), middle.y - float(r * std::sin(a))};
  }
  draw->AddPolyline(line.data(), kPoints, palette::kAccent, ImDrawFlags_None, theme.px(1.5f));
  drawText(draw, theme.small, {at.x + theme.px(2), middle.y + theme.px(3)}, palette::kTextFaint, "back",
           width);
  const float end = textWidth(theme.small, "forward");
  drawText(draw, theme.small, {at.x + width - end - theme.px(2), middle.y + theme.px(3)}, palette::kTextFaint,
           "forward", width);
  ImGui::Dummy({width, height});
  room.ui.trace.item("phase plot");
  if (ImGui::IsItemHovered())
    tooltip(theme,
            "How scattered light is spread: light comes from the left, the distance from the middle is "
            "the logarithm of the phase function, each ring a factor of ten.");
  const std::string mean =
      fmt::format("mean cosine {:.3f}, {:.3g} /sr ahead, {:.3g} /sr back", scene::meanCosine(*phase),
                  scene::phaseValue(*phase, 1), scene::phaseValue(*phase, -1));
  ImGui::PushFont(theme.small);
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
  ImGui::TextWrapped("%s", mean.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  room.ui.trace.note("phase", mean);
}

}  // namespace pileus::editor
