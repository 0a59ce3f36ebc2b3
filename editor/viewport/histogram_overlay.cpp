#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/corner_widgets.h"
#include "editor/viewport/picture_overlays.h"
#include "editor/viewport/viewport_room.h"

namespace pileus::editor {
namespace {

std::string stopText(int stop) {
  return stop == 0 ? "0" : fmt::format("{}{}", stop < 0 ? "\xe2\x88\x92" : "+", std::abs(stop));
}

vec2 histogramSize(const Theme& theme) { return {theme.px(264), theme.px(132)}; }

bool histogramFits(const Theme& theme, vec2 lo, vec2 hi) {
  const vec2 room = hi - lo - 2 * theme.space(2), size = histogramSize(theme);
  return room.x >= size.x && room.y >= size.y;
}

/// Where the histogram begins, from the top; hi.y where it is off or has no room.
float histogramTop(const Theme& theme, const Settings& settings, vec2 lo, vec2 hi) {
  const bool shown = settings.showHistogram && histogramFits(theme, lo, hi);
  return shown ? hi.y - theme.space(2) - histogramSize(theme).y : hi.y;
}

}  // namespace

void drawHistogram(Ui& ui, const Shown& shown, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  if (!histogramFits(theme, lo, hi)) return;
  const vec2 size = histogramSize(theme), b = hi - theme.space(2), a = b - size;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(a), im(b), palette::kChip, theme.px(4));
  ui.trace.rect("histogram", im(a), im(b));
  const vec2 pad(theme.space(2), theme.px(6));
  const float text = theme.small->FontSize;
  const std::string space = shown.displayed.colors ? shown.displayed.colors->workingSpace() : "";
  drawText(draw, theme.small, a + pad, palette::kTextDim, "Stops around 0.18, " + space, size.x - 2 * pad.x);
  const view::ScanResult* scan = shown.mode.scan.result();
  const vec2 plotLo(a.x + pad.x, a.y + pad.y + text + theme.px(4)),
      plotHi(b.x - pad.x, b.y - pad.y - text - theme.px(3));
  using H = view::Histogram;
  const auto xOf = [&](double stop) {
    return plotLo.x +
           (plotHi.x - plotLo.x) * static_cast<float>((stop - H::kLowest) / (H::kHighest - H::kLowest));
  };
  for (int stop = static_cast<int>(H::kLowest); stop <= static_cast<int>(H::kHighest); stop += 2) {
    const float x = std::round(xOf(stop));
    draw->AddLine({x, plotLo.y}, {x, plotHi.y}, faded(palette::kTextFaint, stop == 0 ? 0.8f : 0.25f));
    if (stop % 4 != 0) continue;
    const std::string t = stopText(stop);
    const float w = textWidth(theme.small, t);
    drawText(draw, theme.small, {std::clamp(x - 0.5f * w, plotLo.x, plotHi.x - w), plotHi.y + theme.px(3)},
             palette::kTextDim, t, w + 1);
  }
  if (!scan) return;
  // The same height for all four, by the highest bin but for single spikes.
  float top = 1e-6f;
  for (const auto& parts : scan->histogram.parts) {
    std::array<float, H::kBins> sorted = parts;
    std::nth_element(sorted.begin(), sorted.end() - 2, sorted.end());
    top = std::max(top, sorted[H::kBins - 2]);
  }
  const float step = (plotHi.x - plotLo.x) / H::kBins;
  const ImU32 inks[] = {palette::kAxisX, palette::kAxisY, palette::kAxisZ, palette::kText};
  for (std::size_t c = 0; c < 4; ++c) {
    ImVec2 line[H::kBins];
    for (std::size_t i = 0; i < H::kBins; ++i) {
      // The square root shows what is rare, too.
      const float h = std::sqrt(std::min(scan->histogram.parts[c][i] / top, 1.0f)) * (plotHi.y - plotLo.y);
      const float x = plotLo.x + step * static_cast<float>(i);
      line[i] = {x + 0.5f * step, plotHi.y - h};
      if (c < 3 && h > 0) draw->AddRectFilled({x, plotHi.y - h}, {x + step, plotHi.y}, faded(inks[c], 0.25f));
    }
    draw->AddPolyline(line, H::kBins, inks[c], 0, theme.px(c == 3 ? 2 : 1));
  }
  std::string note = fmt::format("black {:.0f} %", 100 * scan->histogram.black);
  if (scan->notFinite > 0) note += fmt::format(", {} nan or inf", scan->notFinite);
  const float w = textWidth(theme.small, note);
  drawText(draw, theme.small, {plotHi.x - w, a.y + pad.y},
           scan->notFinite > 0 ? palette::kError : palette::kTextFaint, note, w + 1);
  float peak = 0;
  int at = 0;
  for (int i = 0; i < H::kBins; ++i)
    if (scan->histogram.parts[3][static_cast<std::size_t>(i)] > peak)
      peak = scan->histogram.parts[3][static_cast<std::size_t>(i)], at = i;
  ui.trace.note("histogram", fmt::format("{} texels, peak {:.2f}", scan->texels, H::stopOf(at)));
}

void drawBandLegend(Ui& ui, const Shown& shown, const Settings& settings, vec2 lo, vec2 hi, float right) {
  const Theme& theme = ui.theme;
  constexpr int kBands = view::kExposureBands;
  const float label = textWidth(theme.small,
                                "\xe2\x89\xa4\xe2\x88\x92"
                                "7");
  const float text = theme.small->FontSize, bar = theme.px(14),
              width = bar + label + theme.px(6) + 2 * theme.space(2);
  const float cross = axisCrossHeight(ui.theme, shown, settings, lo, hi),
              histogram = histogramTop(ui.theme, settings, lo, {right, hi.y});
  // Below the axis cross, where it does not stand beside the picture.
  const auto topAt = [&](float x) { return std::round(lo.y + (x < hi.x ? cross : 0.0f) + theme.space(2)); };
  const auto bandHeight = [&](float top, float bottom) {
    return std::floor(std::min(theme.px(17), (bottom - top - theme.space(4) - 2 * text) / kBands));
  };
  vec2 a(right - theme.space(2) - width, 0);
  a.y = topAt(a.x);
  float height = bandHeight(a.y, histogram);
  if (height < theme.px(6) && histogram < hi.y) {  // too low above the histogram: beside it
    a.x -= histogramSize(theme).x + theme.space(2);
    a.y = topAt(a.x);
    height = bandHeight(a.y, hi.y);
  }
  if (height < 4 || a.x < lo.x) return;
  const vec2 b = a + vec2(width, height * kBands + text + theme.px(6) + 2 * theme.px(6));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(a), im(b), palette::kChip, theme.px(4));
  drawText(draw, theme.small, {a.x + theme.space(2), a.y + theme.px(6)}, palette::kTextDim, "stops", width);
  vec2 at(a.x + theme.space(2), a.y + theme.px(12) + text);
  for (int i = kBands - 1; i >= 0; --i, at.y += height) {
    const vec3 c = view::exposureBands()[static_cast<std::size_t>(i)] * 255.0f;
    draw->AddRectFilled(im(at), {at.x + bar, at.y + height},
                        IM_COL32(static_cast<int>(c.r), static_cast<int>(c.g), static_cast<int>(c.b), 255));
    const int stop = i - kBands / 2;
    if (height < text && stop % 2 != 0) continue;
    const std::string t = i == 0            ? "\xe2\x89\xa4" + stopText(stop)
                          : i == kBands - 1 ? "\xe2\x89\xa5" + stopText(stop)
                                            : stopText(stop);
    drawText(draw, theme.small, {at.x + bar + theme.px(6), at.y + 0.5f * (height - text)},
             stop == 0 ? palette::kTextStrong : palette::kTextDim, t, theme.px(40));
  }
  ui.trace.rect("false colour legend", im(a), im(b));
}

}  // namespace pileus::editor
