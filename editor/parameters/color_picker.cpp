#include "editor/parameters/color_picker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "editor/parameters/parameters.h"
#include "editor/picture/display_color.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "renderer/scene/light.h"

namespace pileus::editor {
namespace {

constexpr int kRings = 8, kSpokes = 48;
constexpr std::size_t kMostRecent = 9;

double rounded(double x) { return std::round(x * 1e4) / 1e4; }
dvec3 tidy(const dvec3& c, double lo, double hi) {
  const auto one = [&](double x) { return std::clamp(rounded(x), lo, hi); };
  return {one(c.x), one(c.y), one(c.z)};
}

/// The vertices' colours: centre, then rings outwards. Made again when the display transform changes.
void updateWheel(Shown& shown, Parameters& parameters) {
  ColorPicker& picker = parameters.picker;
  if (!picker.wheel.empty() && picker.wheelRevision == parameters.colors.revision) return;
  std::vector<vec4> colors;
  for (int ring = 0; ring <= kRings; ++ring)
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double s = static_cast<double>(ring) / kRings;
      const Hsv hsv{static_cast<double>(spoke) / kSpokes, s * s, 1};
      colors.emplace_back(vec3(rgbOf(hsv) * 0.8), 1.0f);
    }
  toDisplay(shown, colors);
  picker.wheel.clear();
  for (const vec4& c : colors) {
    const vec4 v = glm::clamp(c, vec4(0), vec4(1));
    picker.wheel.push_back(ImGui::ColorConvertFloat4ToU32({v.x, v.y, v.z, 1}));
  }
  picker.wheelRevision = parameters.colors.revision;
}

ImVec2 onWheel(ImVec2 center, float radius, double hue, double saturation) {
  const double angle = 2 * std::numbers::pi * hue, r = std::sqrt(saturation) * static_cast<double>(radius);
  return {center.x + static_cast<float>(std::cos(angle) * r),
          center.y - static_cast<float>(std::sin(angle) * r)};
}

void paintWheel(const ColorPicker& picker, ImVec2 center, float radius) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  const int count = (kRings + 1) * kSpokes;
  draw->PrimReserve(kRings * kSpokes * 6, count);
  const auto base = draw->_VtxCurrentIdx;
  for (int i = 0; i < count; ++i) {
    const double s = static_cast<double>(i / kSpokes) / kRings;
    draw->PrimWriteVtx(onWheel(center, radius, static_cast<double>(i % kSpokes) / kSpokes, s * s), white,
                       picker.wheel[static_cast<std::size_t>(i)]);
  }
  for (int ring = 0; ring < kRings; ++ring)
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const int next = (spoke + 1) % kSpokes;
      const int quad[6] = {ring * kSpokes + spoke, ring * kSpokes + next,       (ring + 1) * kSpokes + next,
                           ring * kSpokes + spoke, (ring + 1) * kSpokes + next, (ring + 1) * kSpokes + spoke};
      for (const int v : quad) draw->PrimWriteIdx(static_cast<ImDrawIdx>(base + static_cast<unsigned>(v)));
    }
}

/// Dragging in the wheel chooses hue and saturation; Shift is a tenth of the way.
bool drawWheel(Ui& ui, const Parameters& parameters, Hsv& hsv, ColorEdit& edit) {
  const Theme& theme = ui.theme;
  const float radius = theme.px(86);
  const ImVec2 at = ImGui::GetCursorScreenPos(), center = {at.x + radius, at.y + radius};
  ImGui::InvisibleButton("wheel", {2 * radius, 2 * radius});
  ui.trace.item("picker/wheel");
  const bool active = ImGui::IsItemActive();
  edit.finished |= ImGui::IsItemDeactivated();
  paintWheel(parameters.picker, center, radius - theme.px(2));
  const ImVec2 mark = onWheel(center, radius - theme.px(2), hsv.hue, hsv.saturation);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddCircle(mark, theme.px(6), palette::kHandleEdge, 0, theme.px(4));
  draw->AddCircle(mark, theme.px(6), palette::kHandle, 0, theme.px(2));
  const ImGuiIO& io = ImGui::GetIO();
  if (!active || (!ImGui::IsItemActivated() && io.MouseDelta.x == 0 && io.MouseDelta.y == 0)) return false;
  ImVec2 to = io.MousePos;
  if (io.KeyShift) to = {mark.x + 0.1f * io.MouseDelta.x, mark.y + 0.1f * io.MouseDelta.y};
  const double x = static_cast<double>(to.x - center.x), y = static_cast<double>(center.y - to.y);
  const double r = std::min(1.0, std::hypot(x, y) / static_cast<double>(radius - theme.px(2)));
  const double turns = std::atan2(y, x) / (2 * std::numbers::pi);
  hsv.saturation = r * r;
  if (r > 0.01) hsv.hue = turns - std::floor(turns);
  edit.dragging = true;
  return true;
}

struct Line {
  const char *id, *label;
  double value;
  NumberField field;
};

/// One labelled number; true if it changed.
bool drawLine(Ui& ui, Line& line, ColorEdit& edit, std::optional<double>* kelvin = nullptr) {
  const Theme& theme = ui.theme;
  const float label = theme.px(86);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
  ImGui::TextUnformatted(line.label);
  ImGui::PopStyleColor();
  ImGui::SameLine(label, 0);
  const NumberEdit n = numberField(ui.fields.number, theme, line.id, line.value, line.field, theme.px(120));
  ui.trace.item(std::string("picker/") + line.id);
  edit.dragging |= n.dragging;
  edit.finished |= n.finished;
  edit.cancelled |= n.cancelled;
  if (kelvin) *kelvin = n.kelvin;
  if (n.refused || ui.fields.number.wasRefused) ui.trace.note("picker refusal", ui.fields.number.refusal);
  return n.changed;
}

NumberField intensityField(double lo, double hi, double most) {
  NumberField f;
  f.hardMin = lo, f.hardMax = hi;
  f.softMin = 0, f.softMax = std::max(1.0, most);
  f.takesKelvin = true;
  return f;
}

bool drawLines(Ui& ui, Parameters& parameters, dvec3& color, Hsv& hsv, double lo, double hi,
               ColorEdit& edit) {
  ColorPicker& picker = parameters.picker;
  const ImU32 marks[3] = {palette::kAxisX, palette::kAxisY, palette::kAxisZ};
  const char *ids[3] = {"r", "g", "b"}, *labels[3] = {"Red", "Green", "Blue"};
  bool changed = false;
  std::optional<double> kelvin;
  for (int i = 0; i < 3; ++i) {
    Line line{ids[i], labels[i], color[i], intensityField(lo, hi, std::ceil(hsv.value))};
    line.field.mark = marks[i];
    std::optional<double> typed;
    if (drawLine(ui, line, edit, &typed)) color[i] = line.value, changed = true;
    if (typed) kelvin = typed;
  }
  Line intensity{"intensity", "Intensity", hsv.value, intensityField(0, hi, 1)};
  intensity.field.logarithmic = true;
  intensity.field.softMax = std::max(10.0, hsv.value);
  if (drawLine(ui, intensity, edit)) {
    hsv.value = intensity.value;
    color = tidy(rgbOf(hsv), lo, hi);
    changed = true;
  }
  Line temperature{"kelvin", "Temperature", picker.kelvin, {}};
  temperature.field.hardMin = 1667, temperature.field.hardMax = 25000;
  temperature.field.softMin = 1700, temperature.field.softMax = 15000;
  temperature.field.logarithmic = true;
  temperature.field.unit = "K";
  if (drawLine(ui, temperature, edit)) kelvin = temperature.value;
  if (kelvin) {
    picker.kelvin = std::clamp(*kelvin, 1667.0, 25000.0);
    color = tidy(dvec3(scene::temperatureColor(picker.kelvin)), lo, hi);
    changed = true;
  }
  return changed;
}

bool drawRecent(Ui& ui, Shown& shown, Parameters& parameters, dvec3& color) {
  const Theme& theme = ui.theme;
  const std::vector<dvec3> recent = parameters.picker.recent;
  bool chosen = false;
  for (std::size_t i = 0; i < recent.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, theme.px(4));
    ImGui::PushID(static_cast<int>(i));
    if (colorSwatch(ui.theme, shown, parameters, "recent", recent[i], {theme.px(24), theme.px(20)}))
      color = recent[i], chosen = true;
    ui.trace.item("picker/recent/" + std::to_string(i));
    ImGui::PopID();
  }
  return chosen;
}

}  // namespace

bool colorSwatch(const Theme& theme, Shown& shown, Parameters& parameters, const char* id, const dvec3& color,
                 ImVec2 size, bool mixed) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), end = {at.x + size.x, at.y + size.y};
  const bool clicked = ImGui::InvisibleButton(id, size);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float r = theme.px(4);
  draw->AddRectFilled(at, end, mixed ? palette::kField : displayColor(shown, parameters.colors, color), r);
  if (mixed) {
    const float y = std::round(0.5f * (at.y + end.y));
    draw->AddLine({at.x + 0.35f * size.x, y}, {end.x - 0.35f * size.x, y}, palette::kText, theme.px(1));
  }
  draw->AddRect(at, end, ImGui::IsItemHovered() ? palette::kTextDim : palette::kLine, r);
  return clicked;
}

ColorEdit drawColorPicker(Ui& ui, Shown& shown, Parameters& parameters, dvec3& color, double lo, double hi) {
  const Theme& theme = ui.theme;
  ColorPicker& picker = parameters.picker;
  ColorEdit edit;
  updateWheel(shown, parameters);
  if (ImGui::IsWindowAppearing()) picker.before = color, picker.hsv = {};
  picker.open = true;
  Hsv hsv = hsvOf(color, picker.hsv);
  ImGui::BeginGroup();
  if (drawWheel(ui, parameters, hsv, edit)) {
    if (hsv.value <= 0) hsv.value = 1;
    color = tidy(rgbOf(hsv), lo, hi);
    edit.changed = true;
  }
  ImGui::EndGroup();
  ImGui::SameLine(0, theme.space(3));
  ImGui::BeginGroup();
  edit.changed |= drawLines(ui, parameters, color, hsv, lo, hi, edit);
  ImGui::EndGroup();
  // What it was, what it is; then the way into the picture.
  const float half = theme.px(60), height = ImGui::GetFrameHeight();
  if (colorSwatch(ui.theme, shown, parameters, "before", picker.before, {half, height}))
    color = picker.before, edit.changed = edit.finished = true;
  if (ImGui::IsItemHovered()) tooltip(theme, "As it was; click to go back");
  ImGui::SameLine(0, theme.px(4));
  colorSwatch(ui.theme, shown, parameters, "now", color, {half, height});
  ImGui::SameLine(0, theme.space(3));
  edit.eyedropper = ImGui::Button((std::string(icon::kEyedropper) + "  Pick from picture").c_str());
  ui.trace.item("picker/eyedropper");
  if (ImGui::IsItemHovered())
    tooltip(theme, "Then click in the viewport: its scene-linear value is taken. Esc: not after all.");
  if (!picker.recent.empty() && drawRecent(ui, shown, parameters, color)) edit.changed = edit.finished = true;
  picker.hsv = hsvOf(color, hsv);
  return edit;
}

void closeColorPicker(ColorPicker& picker, const dvec3& color) {
  if (!picker.open) return;
  picker.open = false;
  if (color == picker.before) return;
  std::erase(picker.recent, color);
  picker.recent.insert(picker.recent.begin(), color);
  if (picker.recent.size() > kMostRecent) picker.recent.resize(kMostRecent);
}

}  // namespace pileus::editor
