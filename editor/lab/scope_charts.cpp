#include "editor/lab/scope_charts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "editor/lab/ray_scope.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "renderer/shadow/metric.h"

namespace pileus::editor {
namespace {

constexpr const ImU32* kVolumes[] = {&palette::kSeries0, &palette::kSeries1, &palette::kSeries2,
                                     &palette::kSeries3, &palette::kSeries4, &palette::kSeries5};
constexpr float kGutter = 44;      // design pixels for the labels of y
constexpr std::size_t kLanes = 4;  // of volume bars; the last one takes the rest

bool deep(const truth::RayProbe& p) { return p.map->kind == shadow::ShadowMap::Kind::Deep; }
bool marched(const truth::RayProbe& p) { return p.map->kind == shadow::ShadowMap::Kind::RayMarch; }
bool hasMetric(const truth::RayProbe& p) { return p.map->metric && p.map->metric->block; }

Plot plotIn(const Theme& theme, const ChartSpace& space, float height, dvec2 x, dvec2 y) {
  Plot plot;
  plot.draw = ImGui::GetWindowDrawList();
  plot.theme = &theme;
  plot.lo = {space.left + theme.px(kGutter), space.y};
  plot.hi = {space.right, space.y + height};
  plot.x = x, plot.y = y;
  return plot;
}

void heading(const Theme& theme, ChartSpace& space, const std::string& text,
             const std::vector<std::pair<std::string, ImU32>>& keys = {}) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  drawText(draw, theme.small, {space.left, space.y}, palette::kTextDim, text, space.right - space.left);
  float x = space.right;
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    const float w = textWidth(theme.small, key->first);
    x -= w;
    if (x < space.left + textWidth(theme.small, text) + theme.space(6)) break;
    drawText(draw, theme.small, {x, space.y}, palette::kTextDim, key->first, w + 1);
    const float y = std::round(space.y + 0.55f * theme.small->FontSize);
    x -= theme.px(20);
    draw->AddLine({x, y}, {x + theme.px(14), y}, key->second, 2 * theme.scale);
    x -= theme.px(12);
  }
  space.y += theme.small->FontSize + theme.px(5);
}

/// The part of the ray that is worth looking at, in metres.
dvec2 shownRange(const truth::RayProbe& p) {
  dvec2 r(p.pointX, p.pointX);
  if (!p.covered.empty()) r = {std::min(r.x, p.covered.front().x), std::max(r.y, p.covered.back().y)};
  const double room = std::max(0.06 * (r.y - r.x), 1e-3);
  r = {std::max(r.x - room, 0.0), std::min(r.y + room, 1.0)};
  if (r.y - r.x > 0.8) r = {0, 1};
  return {p.metres(r.x), p.metres(r.y)};
}

std::vector<double> metresOf(const truth::RayProbe& p) {
  std::vector<double> out;
  for (const double x : p.x) out.push_back(p.metres(x));
  return out;
}

/// A lane for each part, so that those on one lane do not overlap; the last lane takes what is left.
std::vector<int> lanesOf(const truth::RayProbe& p) {
  std::vector<std::size_t> order(p.parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p.parts[a].from < p.parts[b].from; });
  std::vector<double> ends;
  std::vector<int> lanes(p.parts.size(), 0);
  for (const std::size_t i : order) {
    const auto free =
        std::find_if(ends.begin(), ends.end(), [&](double end) { return end <= p.parts[i].from; });
    const auto lane = static_cast<std::size_t>(free - ends.begin());
    if (free == ends.end() && ends.size() < kLanes) ends.push_back(0);
    lanes[i] = static_cast<int>(std::min(lane, ends.size() - 1));
    ends[static_cast<std::size_t>(lanes[i])] = p.parts[i].to;
  }
  return lanes;
}

int laneCount(const truth::RayProbe& p) {
  const std::vector<int> lanes = lanesOf(p);
  return lanes.empty() ? 1 : 1 + *std::max_element(lanes.begin(), lanes.end());
}

/// Where which volume is, as bars under the chart.
void drawVolumes(Ui& ui, ChartSpace& space, const truth::RayProbe& p, const Plot& above) {
  const Theme& theme = ui.theme;
  const float lane = theme.px(7);
  Plot plot = above;
  plot.lo.y = space.y, plot.hi.y = space.y + lane * static_cast<float>(laneCount(p));
  const std::vector<int> lanes = lanesOf(p);
  for (std::size_t i = 0; i < p.parts.size(); ++i) {
    const truth::RayPart& part = p.parts[i];
    const int row = lanes[i];
    const float x0 = std::max(plot.px(p.metres(part.from)), plot.lo.x),
                x1 = std::min(std::max(plot.px(p.metres(part.to)), x0 + 1), plot.hi.x);
    const vec2 lo(x0, space.y + lane * static_cast<float>(row)), hi(x1, lo.y + lane - theme.px(2));
    const ImU32 color = *kVolumes[static_cast<std::size_t>(part.volume) % std::size(kVolumes)];
    plot.draw->AddRectFilled(im(lo), im(hi), color, theme.px(2));
    if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) &&
        ImGui::IsMouseHoveringRect(im(lo - vec2(0, 1)), im(hi + vec2(0, 1)))) {
      const std::string text =
          fmt::format("{}: {:.4g} to {:.4g} m", part.name, p.metres(part.from), p.metres(part.to));
      tooltip(theme, text);
      ui.trace.note("scope volume", text);
    }
  }
  space.y = plot.hi.y + theme.px(4);
}

std::string valuesAt(const truth::RayProbe& p, const RayScope& scope, double x) {
  const double exact = interpolated(p.x, p.exact, x);
  std::string text = fmt::format("{:.4g} m\nT {:.4f} exact", p.metres(x), exact);
  if (!p.mapped.empty()) {
    const double mapped = interpolated(p.x, p.mapped, x);
    text += fmt::format("\nT {:.4f} by the map, {:+.4f}", mapped, mapped - exact);
  }
  if (!scope.mutedT.empty())
    text += fmt::format("\nT {:.4f} without what is muted", interpolated(p.x, scope.mutedT, x));
  if (hasMetric(p)) text += fmt::format("\ng {:.4f}", interpolated(p.x, p.u, x));
  return text;
}

void hover(Ui& ui, const RayScope& scope, const truth::RayProbe& p, const Plot& plot) {
  if (!plot.hovered()) return;
  const double metres = plot.xAt(ImGui::GetIO().MousePos.x), x = (metres - p.nearDistance) / p.length;
  plotVertical(plot, metres, palette::kTextFaint, false);
  const std::string text = valuesAt(p, scope, x);
  tooltip(ui.theme, text);
  ui.trace.note("scope hover", text);
}

void drawMetric(Ui& ui, const RayScope& scope, ChartSpace& space, const truth::RayProbe& p,
                const std::vector<double>& metres, dvec2 range) {
  const Theme& theme = ui.theme;
  heading(ui.theme, space, "g, the share of the metric in front");
  const Plot plot = plotIn(ui.theme, space, 0.8f * space.unit, range, {0, 1.06});
  plotFrame(plot, AxisX::Grid, "", 2);
  // Plateaus: where g stands still nothing of the basis is spent.
  const std::vector<double>& u = p.u;
  for (std::size_t i = 0; i + 1 < u.size();) {
    std::size_t j = i;
    while (j + 1 < u.size() && u[j + 1] - u[i] < 1e-6) ++j;
    if (j > i + 2 && u[i] > 1e-3 && u[i] < 1 - 1e-3)
      plot.draw->AddRectFilled({std::max(plot.px(metres[i]), plot.lo.x), plot.lo.y},
                               {std::min(plot.px(metres[j]), plot.hi.x), plot.hi.y}, palette::kBand);
    i = j + 1;
  }
  plotLine(plot, metres, u, palette::kMetricSocket, 1.6f * theme.scale);
  plotVertical(plot, p.metres(p.pointX), palette::kSelect, true);
  hover(ui, scope, p, plot);
  ui.trace.rect("scope/metric", im(plot.lo), im(plot.hi));
  space.y = plot.hi.y + theme.space(2);
}

std::string termText(const truth::RayProbe& p, std::size_t k) {
  const shadow::Basis basis = p.map->basis;
  if (basis == shadow::Basis::Slab) return fmt::format("slab {} of {}", k + 1, p.map->coefficients);
  if (basis == shadow::Basis::Piecewise) {
    const auto count =
        static_cast<std::size_t>(std::max(shadow::pieceOf(p.taps.taps.front().metric, 0).count, 1));
    const std::size_t order = k / count;
    return fmt::format("Interval {}, {}", k % count + 1,
                       order == 0
                           ? "its optical depth"
                           : fmt::format("cos({}\xcf\x80 v)", order == 1 ? "" : std::to_string(order)));
  }
  if (k == 0) return basis == shadow::Basis::Cosine ? "c0, the mean" : "a0, twice the mean";
  if (basis == shadow::Basis::Cosine)
    return fmt::format("c{}, cos({}\xcf\x80 g)", k, k == 1 ? "" : std::to_string(k));
  const std::size_t n = (k + 1) / 2;
  return k % 2 == 1 ? fmt::format("a{}, cos({}\xcf\x80 g)", n, 2 * n)
                    : fmt::format("b{}, sin({}\xcf\x80 g)", n, 2 * n);
}

}  // namespace

float chartOverhead(const Theme& theme, const RayScope& scope) {
  const truth::RayProbe& p = *scope.probe;
  const float heading = theme.small->FontSize + theme.px(5), axis = theme.small->FontSize + theme.px(6);
  float out = heading + axis + theme.px(7) * static_cast<float>(laneCount(p)) + theme.px(4) + theme.space(2);
  if (hasMetric(p)) out += heading + theme.space(2);
  if (!scope.overU.exact.empty()) out += heading + axis + theme.space(2);
  if (!p.taps.taps.empty()) out += heading + theme.space(2);
  return out;
}

void drawTransmittance(Ui& ui, const RayScope& scope, ChartSpace& space) {
  const Theme& theme = ui.theme;
  const truth::RayProbe& p = *scope.probe;
  const std::vector<double> metres = metresOf(p);
  const dvec2 range = shownRange(p);
  std::vector<std::pair<std::string, ImU32>> keys{{"exact", palette::kExact}};
  if (!p.mapped.empty()) keys.push_back({"map", palette::kAccent});
  if (!scope.mutedT.empty()) keys.push_back({"muted", palette::kSelect});
  heading(ui.theme, space, "Transmittance T from the light", keys);
  const Plot plot = plotIn(ui.theme, space, 2 * space.unit, range, {0, 1.04});
  plotFrame(plot, AxisX::Labels, "m");
  if (!p.mapped.empty()) plotBetween(plot, metres, p.exact, p.mapped, palette::kLeak, palette::kOverdark);
  plotVertical(plot, p.metres(p.pointX), palette::kSelect, true);
  plotLine(plot, metres, p.exact, palette::kExact, 1.6f * theme.scale);
  plotLine(plot, metres, p.mapped, palette::kAccent, 1.8f * theme.scale);
  plotLine(plot, metres, scope.mutedT, palette::kSelect, 1.6f * theme.scale);
  if (deep(p))
    for (const shadow::DeepVertex& v : p.taps.vertices)
      if (v.x >= 0 && v.x <= 1 && p.metres(v.x) >= range.x && p.metres(v.x) <= range.y)
        plotDot(plot, p.metres(v.x), v.transmittance, palette::kAccent, theme.px(2));
  plotDot(plot, p.metres(p.pointX), interpolated(p.x, p.exact, p.pointX), palette::kExact, theme.px(3.5f));
  if (!p.mapped.empty())
    plotDot(plot, p.metres(p.pointX), interpolated(p.x, p.mapped, p.pointX), palette::kAccent,
            theme.px(3.5f));
  hover(ui, scope, p, plot);
  ui.trace.rect("scope/transmittance", im(plot.lo), im(plot.hi));
  space.y = plot.hi.y + theme.small->FontSize + theme.px(6);
  drawVolumes(ui, space, p, plot);
  space.y += theme.space(2);
  if (hasMetric(p)) drawMetric(ui, scope, space, p, metres, range);
}

void drawExtinction(Ui& ui, const RayScope& scope, ChartSpace& space) {
  const Theme& theme = ui.theme;
  const truth::RayProbe& p = *scope.probe;
  const truth::ExtinctionOverU& e = scope.overU;
  if (e.exact.empty()) return;
  const bool muted = !scope.mutedT.empty();
  std::vector<std::pair<std::string, ImU32>> keys{{"exact", palette::kGhost}};
  if (!e.mapped.empty())
    keys.push_back({muted ? "muted" : "series", muted ? palette::kSelect : palette::kAccent});
  heading(ui.theme, space,
          hasMetric(p) ? "Extinction over g, d\xcf\x84/dg" : "Extinction over x, d\xcf\x84/dx", keys);
  double lo = 0, hi = 1e-6;
  for (const auto* values : {&e.exact, &e.mapped})
    for (const double v : *values) lo = std::min(lo, v), hi = std::max(hi, v);
  // A thin sheet's spike is cut rather than all else flattened.
  std::vector<double> sorted = e.exact;
  std::sort(sorted.begin(), sorted.end());
  double mapped = 1e-6;
  for (const double v : e.mapped) mapped = std::max(mapped, v);
  hi = std::min(hi, std::max(1.6 * mapped, 4 * sorted[sorted.size() * 9 / 10]) + 1e-9);
  const double room = 0.06 * (hi - lo);
  const Plot plot = plotIn(ui.theme, space, 1.4f * space.unit, {0, 1}, {lo < 0 ? lo - room : 0, hi + room});
  plotFrame(plot, AxisX::Labels, "", 5);
  plotArea(plot, e.u, e.exact, 0, faded(palette::kGhost, 0.28f));
  if (!e.mapped.empty()) {
    std::vector<double> negative;
    for (const double v : e.mapped) negative.push_back(std::min(v, 0.0));
    plotArea(plot, e.u, negative, 0, palette::kLeak);
    plotLine(plot, e.u, e.mapped, muted ? palette::kSelect : palette::kAccent, 1.8f * theme.scale);
  }
  plotVertical(plot, interpolated(p.x, p.u, p.pointX), palette::kSelect, true);
  if (plot.hovered()) {
    const double u = plot.xAt(ImGui::GetIO().MousePos.x);
    plotVertical(plot, u, palette::kTextFaint, false);
    std::string text =
        fmt::format("{} {:.4f}\n{:.4g} exact", hasMetric(p) ? "g" : "x", u, interpolated(e.u, e.exact, u));
    if (!e.mapped.empty()) text += fmt::format("\n{:.4g} by the series", interpolated(e.u, e.mapped, u));
    tooltip(theme, text);
  }
  ui.trace.rect("scope/extinction", im(plot.lo), im(plot.hi));
  space.y = plot.hi.y + theme.small->FontSize + theme.px(6) + theme.space(2);
}

void drawCoefficients(Ui& ui, RayScope& scope, ChartSpace& space) {
  const Theme& theme = ui.theme;
  const truth::RayProbe& p = *scope.probe;
  if (p.taps.taps.empty() || marched(p)) return;
  const std::vector<double>& c = p.taps.taps.front().coefficients;
  heading(ui.theme, space, fmt::format("Coefficients of texel {}, {}", p.taps.texel.x, p.taps.texel.y));
  if (!scope.mutedT.empty()) {
    const std::string text = "unmute all";
    const float w = textWidth(theme.small, text);
    const vec2 at(space.right - w, space.y - theme.small->FontSize - theme.px(5));
    ImGui::SetCursorScreenPos(im(at));
    if (ImGui::InvisibleButton("unmute", {w, theme.small->FontSize}))
      std::fill(scope.muted.begin(), scope.muted.end(), 0);
    ui.trace.item("scope/unmute");
    drawText(ImGui::GetWindowDrawList(), theme.small, at,
             ImGui::IsItemHovered() ? palette::kText : palette::kAccent, text, w + 1);
  }
  double lo = 0, hi = 1e-9;
  for (const double v : c) lo = std::min(lo, v), hi = std::max(hi, v);
  const double room = 0.08 * (hi - lo);
  const auto n = static_cast<double>(c.size());
  const Plot plot = plotIn(ui.theme, space, 1.1f * space.unit, {0, n}, {lo < 0 ? lo - room : 0, hi + room});
  plotFrame(plot, AxisX::None, "", 5);
  const float zero = std::round(plot.py(0)), gap = n > 16 ? 1.0f : theme.px(2);
  plot.draw->AddLine({plot.lo.x, zero}, {plot.hi.x, zero}, palette::kLine);
  for (std::size_t k = 0; k < c.size(); ++k) {
    const float x0 = plot.px(static_cast<double>(k)) + gap, x1 = plot.px(static_cast<double>(k) + 1) - gap,
                y = plot.py(c[k]);
    ImGui::SetCursorScreenPos({x0 - gap, plot.lo.y});
    ImGui::PushID(static_cast<int>(k));
    if (ImGui::InvisibleButton("bar", {x1 - x0 + 2 * gap, plot.hi.y - plot.lo.y}))
      scope.muted[k] = scope.muted[k] ? 0 : 1;
    ImGui::PopID();
    ui.trace.item(fmt::format("scope/coefficient/{}", k));
    const bool hovered = ImGui::IsItemHovered();
    const vec2 from(x0, std::min(y, zero)), to(x1, std::max(std::max(y, zero), std::min(y, zero) + 1.5f));
    if (scope.muted[k])
      plot.draw->AddRect(im(from), im(to), palette::kTextFaint, theme.px(1.5f));
    else
      plot.draw->AddRectFilled(
          im(from), im(to), hovered ? mixed(palette::kAccent, palette::kHighlight, 0.3f) : palette::kAccent,
          theme.px(1.5f));
    if (hovered)
      tooltip(theme, fmt::format("{}\n{:.5g}\nClick to {}", termText(p, k), c[k],
                                 scope.muted[k] ? "unmute" : "mute"));
  }
  space.y = plot.hi.y + theme.space(2);
}

}  // namespace pileus::editor
