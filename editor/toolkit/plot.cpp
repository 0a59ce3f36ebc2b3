#include "editor/toolkit/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"

namespace pileus::editor {
namespace {

double along(double value, dvec2 range, bool logarithmic) {
  if (logarithmic)
    return (std::log(std::max(value, 1e-300)) - std::log(range.x)) /
           std::max(std::log(range.y) - std::log(range.x), 1e-300);
  return (value - range.x) / (range.y == range.x ? 1 : range.y - range.x);
}

std::vector<double> ticks(dvec2 range, bool logarithmic, int count) {
  std::vector<double> out;
  if (logarithmic) {
    const double lo = std::floor(std::log10(range.x)), hi = std::ceil(std::log10(range.y));
    for (double e = lo; e <= hi; ++e) {
      for (const double m : {1.0, 2.0, 5.0}) {
        if (m != 1 && hi - lo > 3) continue;
        const double v = m * std::pow(10.0, e);
        if (v >= range.x * 0.999 && v <= range.y * 1.001) out.push_back(v);
      }
    }
    return out;
  }
  const double step = tickStep(range.y - range.x, count);
  for (double i = std::ceil(range.x / step - 1e-6); i * step <= range.y + 1e-6 * step; ++i)
    out.push_back(i * step);
  return out;
}

/// Fills without the blended edges that would show as seams between neighbouring quads.
struct HardEdges {
  explicit HardEdges(ImDrawList* list) : draw(list), flags(list->Flags) {
    draw->Flags &= ~ImDrawListFlags_AntiAliasedFill;
  }
  ~HardEdges() { draw->Flags = flags; }
  ImDrawList* draw;
  ImDrawListFlags flags;
};

}  // namespace

float Plot::px(double value) const {
  return lo.x + static_cast<float>(along(value, x, logX)) * (hi.x - lo.x);
}
float Plot::py(double value) const {
  const auto t = static_cast<float>(std::clamp(along(value, y, logY), -0.05, 1.05));
  return hi.y - t * (hi.y - lo.y);
}
double Plot::xAt(float pixel) const {
  const double t = static_cast<double>((pixel - lo.x) / std::max(hi.x - lo.x, 1.0f));
  return logX ? x.x * std::pow(x.y / x.x, t) : glm::mix(x.x, x.y, t);
}
bool Plot::hovered() const {
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && ImGui::IsMouseHoveringRect(im(lo), im(hi));
}

double tickStep(double range, int count) {
  const double raw = std::max(range, 1e-12) / std::max(count, 1),
               decade = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * decade >= raw * 0.999) return m * decade;
  return 10 * decade;
}

std::string tickText(double value, double step) {
  if (std::abs(value) < 1e-9 * std::abs(step)) return "0";
  if (std::abs(value) >= 1e5 || std::abs(step) < 1e-4) return fmt::format("{:.3g}", value);
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(std::abs(step)) - 1e-9)), 0, 6);
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text[0] == '-') text = "\xe2\x88\x92" + text.substr(1);
  return text;
}

void plotFrame(const Plot& p, AxisX axis, const char* unit, int ticksY) {
  const Theme& theme = *p.theme;
  ImFont* font = theme.small;
  p.draw->AddRectFilled(im(p.lo), im(p.hi), palette::kField, theme.px(2));
  const double stepY = p.logY ? 0 : tickStep(p.y.y - p.y.x, ticksY);
  for (const double v : ticks(p.y, p.logY, ticksY)) {
    const float y = std::round(p.py(v));
    p.draw->AddLine({p.lo.x, y}, {p.hi.x, y}, v == 0 ? palette::kLine : palette::kGridStrong);
    const std::string text = p.logY ? fmt::format("{:g}", v) : tickText(v, stepY);
    const float w = textWidth(font, text);
    drawText(p.draw, font,
             {p.lo.x - theme.px(5) - w, std::clamp(y - 0.5f * font->FontSize, p.lo.y - theme.px(4),
                                                   p.hi.y - font->FontSize + theme.px(4))},
             palette::kTextFaint, text, w + 1);
  }
  if (axis == AxisX::None) return;
  const int ticksX = std::max(2, static_cast<int>((p.hi.x - p.lo.x) / theme.px(80)));
  const double stepX = p.logX ? 0 : tickStep(p.x.y - p.x.x, ticksX);
  const std::vector<double> xs = ticks(p.x, p.logX, ticksX);
  float free = p.lo.x - theme.px(20);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const float x = std::round(p.px(xs[i]));
    p.draw->AddLine({x, p.lo.y}, {x, p.hi.y}, palette::kGridStrong);
    if (axis == AxisX::Grid) continue;
    std::string text = p.logX ? fmt::format("{:g}", xs[i]) : tickText(xs[i], stepX);
    if (i + 1 == xs.size() && unit && *unit) text += std::string(" ") + unit;
    const float w = textWidth(font, text), at = std::min(x - 0.5f * w, p.hi.x - w);
    if (at < free) continue;
    drawText(p.draw, font, {at, p.hi.y + theme.px(3)}, palette::kTextFaint, text, w + 1);
    free = at + w + theme.px(8);
  }
}

void plotLine(const Plot& p, std::span<const double> x, std::span<const double> y, ImU32 color, float width) {
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const vec2 at = p.at(x[i], y[i]);
    if (points.empty() || std::abs(at.x - points.back().x) > 0.3f || std::abs(at.y - points.back().y) > 0.3f)
      points.push_back(im(at));
  }
  p.draw->PushClipRect(im(p.lo), im(p.hi), true);
  p.draw->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, width);
  p.draw->PopClipRect();
}

void plotBetween(const Plot& p, std::span<const double> x, std::span<const double> a,
                 std::span<const double> b, ImU32 above, ImU32 below) {
  const HardEdges hard(p.draw);
  p.draw->PushClipRect(im(p.lo), im(p.hi), true);
  for (std::size_t i = 0; i + 1 < std::min({x.size(), a.size(), b.size()}); ++i) {
    if (std::abs(a[i] - b[i]) + std::abs(a[i + 1] - b[i + 1]) < 1e-9) continue;
    const ImU32 color = b[i] + b[i + 1] >= a[i] + a[i + 1] ? above : below;
    p.draw->AddQuadFilled(im(p.at(x[i], a[i])), im(p.at(x[i], b[i])), im(p.at(x[i + 1], b[i + 1])),
                          im(p.at(x[i + 1], a[i + 1])), color);
  }
  p.draw->PopClipRect();
}

void plotArea(const Plot& p, std::span<const double> x, std::span<const double> y, double level,
              ImU32 color) {
  const HardEdges hard(p.draw);
  p.draw->PushClipRect(im(p.lo), im(p.hi), true);
  for (std::size_t i = 0; i + 1 < std::min(x.size(), y.size()); ++i)
    p.draw->AddQuadFilled(im(p.at(x[i], level)), im(p.at(x[i], y[i])), im(p.at(x[i + 1], y[i + 1])),
                          im(p.at(x[i + 1], level)), color);
  p.draw->PopClipRect();
}

void plotVertical(const Plot& p, double x, ImU32 color, bool dashed) {
  const float at = std::round(p.px(x));
  if (at < p.lo.x || at > p.hi.x) return;
  const float dash = p.theme->px(3);
  if (!dashed) return p.draw->AddLine({at, p.lo.y}, {at, p.hi.y}, color);
  for (float y = p.lo.y; y < p.hi.y; y += 2 * dash)
    p.draw->AddLine({at, y}, {at, std::min(y + dash, p.hi.y)}, color);
}

void plotDot(const Plot& p, double x, double y, ImU32 color, float radius) {
  const vec2 at = p.at(x, y);
  p.draw->AddCircleFilled(im(at), radius + 1.5f, palette::kField);
  p.draw->AddCircleFilled(im(at), radius, color);
}

double interpolated(std::span<const double> x, std::span<const double> y, double at) {
  if (x.empty() || y.size() != x.size()) return 0;
  const auto next = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
  if (next == 0) return y.front();
  if (next == x.size()) return y.back();
  const double t = (at - x[next - 1]) / std::max(x[next] - x[next - 1], 1e-300);
  return glm::mix(y[next - 1], y[next], t);
}

}  // namespace pileus::editor
