#include "editor/panels/number_field.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "editor/graph_view/canvas_view.h"

namespace pileus::editor {
namespace {

bool hasSoft(const NumberField& f) { return f.softMax > f.softMin; }

/// 1, 2 or 5 times a power of ten, at most `x`.
double niceStep(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  const double digit = x / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

double dragUnit(const NumberField& f, double value) {
  if (hasSoft(f)) return f.softMax - f.softMin;
  return std::max(std::abs(value), 1.0) * 2;
}

bool parse(const std::string& text, double& value) {
  const std::size_t from = text.find_first_not_of(" \t+"), to = text.find_last_not_of(" \t");
  if (from == std::string::npos) return false;
  const char* end = text.data() + to + 1;
  const auto [rest, error] = std::from_chars(text.data() + from, end, value);
  return error == std::errc() && rest == end && std::isfinite(value);
}

void typeInto(NumberFieldState& state, ImGuiID id, double value, bool integer) {
  state.typing = id;
  state.focus = true;
  state.text = numberText(value, integer);
}

/// Why the text cannot be the value; "" = it can, and `value` is set.
std::string commit(const std::string& text, double& value, const NumberField& f) {
  double typed = 0;
  if (!parse(text, typed)) return fmt::format("\"{}\" is not a number.", text);
  if (f.integer && typed != std::floor(typed)) return "A whole number is needed.";
  if (typed < f.hardMin || typed > f.hardMax)
    return fmt::format("{} is out of range: {} to {}.", text, numberText(f.hardMin, f.integer),
                       numberText(f.hardMax, f.integer));
  value = typed;
  return {};
}

NumberEdit typeField(NumberFieldState& state, double& value, const NumberField& f, float width) {
  NumberEdit edit;
  ImGui::SetNextItemWidth(width);
  const bool first = state.focus;
  if (first) ImGui::SetKeyboardFocusHere();
  state.focus = false;
  const bool enter =
      ImGui::InputText("##typed", &state.text,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                           ImGuiInputTextFlags_CharsScientific);
  const bool cancelled = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (enter || (!first && ImGui::IsItemDeactivated())) {
    if (!cancelled) {
      const double before = value;
      state.refusal = commit(state.text, value, f);
      edit.refused = !state.refusal.empty();
      edit.changed = value != before;
    }
    state.typing = 0;
    edit.finished = true;
  }
  return edit;
}

void drawField(const Theme& theme, ImVec2 lo, ImVec2 hi, double value, const NumberField& f, bool hovered,
               bool active) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float r = theme.px(4);
  draw->AddRectFilled(lo, hi, hovered || active ? palette::kFieldHover : palette::kField, r);
  if (hasSoft(f)) {
    const bool logarithmic = f.logarithmic && f.softMin > 0 && value > 0;
    const double t = logarithmic ? std::log(value / f.softMin) / std::log(f.softMax / f.softMin)
                                 : (value - f.softMin) / (f.softMax - f.softMin);
    const float x = lo.x + (hi.x - lo.x) * static_cast<float>(std::clamp(t, 0.0, 1.0));
    if (x > lo.x + 1) {
      draw->PushClipRect(lo, {x, hi.y}, true);
      draw->AddRectFilled(lo, hi, hovered || active ? palette::kFieldFillHover : palette::kFieldFill, r);
      draw->PopClipRect();
    }
  }
  if (f.mark)
    draw->AddRectFilled({lo.x, lo.y + theme.px(5)}, {lo.x + theme.px(2), hi.y - theme.px(5)}, f.mark,
                        theme.px(1));
  const std::string text = numberText(value, f.integer);
  const float y = 0.5f * (lo.y + hi.y);
  float right = hi.x - theme.space(2);
  if (f.unit && *f.unit) {
    const float unit = textWidth(theme.small, f.unit);
    if (hi.x - lo.x > unit + theme.px(64)) {
      drawText(draw, theme.small, {right - unit, y - 0.5f * theme.small->FontSize}, palette::kTextDim, f.unit,
               unit + 1);
      right -= unit + theme.px(5);
    }
  }
  const float left = lo.x + theme.px(f.mark ? 5 : 8);
  const float width = textWidth(theme.body, text);
  drawText(draw, theme.body, {std::max(left, right - width), y - 0.5f * theme.body->FontSize}, palette::kText,
           text, right - left + 1);
}

}  // namespace

std::string numberText(double value, bool integer) {
  if (integer) return fmt::format("{:.0f}", value);
  // Large numbers are written out; the exponent is for what has no other short form.
  std::string text = std::abs(value) >= 1e5 && std::abs(value) < 1e12 ? fmt::format("{:.12g}", value)
                                                                      : fmt::format("{:.6g}", value);
  return text == "-0" ? "0" : text;
}

double draggedValue(double raw, double pixels, double width, const NumberField& f, bool fine) {
  const double t = pixels / std::max(width, 60.0) * (fine ? 0.1 : 1.0);
  if (f.logarithmic && hasSoft(f) && f.softMax > 0) {
    const double lo = f.softMin > 0 ? f.softMin : f.softMax * 1e-4;
    const double value = std::max(raw, lo) * std::pow(f.softMax / lo, t);
    // A logarithmic field whose range begins at zero reaches it at its lower end.
    return f.softMin <= 0 && value <= lo * 1.001 && t < 0 ? lo : value;
  }
  return raw + t * dragUnit(f, raw);
}

double tidiedValue(double raw, const NumberField& f, bool fine, bool snap) {
  double value = raw;
  if (f.logarithmic && hasSoft(f) && f.softMax > 0 && value > 0) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - (snap ? 0 : fine ? 3 : 2));
    value = std::round(value / step) * step;
    if (f.softMin <= 0 && raw <= f.softMax * 1e-4) value = 0;
  } else {
    double step = niceStep(dragUnit(f, raw) / (snap ? 20 : fine ? 5000 : 500));
    if (f.integer) step = std::max(1.0, std::round(step));
    value = std::round(value / step) * step;
  }
  const double lo = hasSoft(f) ? f.softMin : f.hardMin, hi = hasSoft(f) ? f.softMax : f.hardMax;
  value = std::clamp(value, lo, hi);
  if (f.integer) return std::round(value);
  // Away with the noise of the multiplication: what is shown is what is stored.
  return value == 0 ? 0 : std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr);
}

NumberEdit numberField(NumberFieldState& state, const Theme& theme, const char* id, double& value,
                       const NumberField& f, float width) {
  NumberEdit edit;
  ImGui::PushID(id);
  const ImGuiID self = ImGui::GetID("field");
  const ImGuiIO& io = ImGui::GetIO();
  if (state.typing == self) {
    edit = typeField(state, value, f, width);
    ImGui::PopID();
    return edit;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  ImGui::InvisibleButton("field", {std::max(width, 8.0f), height});
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  if (ImGui::IsItemActivated()) {
    state.active = self;
    state.raw = value;
    state.moved = false;
    if (io.KeyCtrl || ImGui::IsMouseDoubleClicked(0)) typeInto(state, self, value, f.integer);
  }
  if (active && state.active == self && state.typing != self) {
    if (ImGui::IsMouseDragging(0, 3 * theme.scale) || state.moved) {
      const double pixels = state.moved ? static_cast<double>(io.MouseDelta.x)
                                        : static_cast<double>(ImGui::GetMouseDragDelta(0, 0).x);
      state.moved = true;
      state.raw = draggedValue(state.raw, pixels, static_cast<double>(width), f, io.KeyShift);
      const double lo = hasSoft(f) ? f.softMin : f.hardMin, hi = hasSoft(f) ? f.softMax : f.hardMax;
      // A value typed beyond the soft range is not pulled back by touching it.
      const double reachLo = std::min(lo, value), reachHi = std::max(hi, value);
      state.raw = std::clamp(state.raw, reachLo, reachHi);
      const double next =
          state.raw < lo || state.raw > hi ? value : tidiedValue(state.raw, f, io.KeyShift, io.KeyCtrl);
      edit.changed = next != value;
      value = next;
      edit.dragging = true;
    }
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  } else if (hovered) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (ImGui::IsItemDeactivated() && state.active == self) {
    edit.finished = state.moved;
    state.active = 0;
  }
  drawField(theme, at, {at.x + width, at.y + height}, value, f, hovered, active);
  ImGui::PopID();
  return edit;
}

}  // namespace pileus::editor
