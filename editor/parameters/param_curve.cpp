// The widget of a curve: a graph over the densities' histogram; the selected point's numbers, the shape and
// presets below.
#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/parameters/data_behind.h"
#include "editor/parameters/param_widgets.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using nodes::Curve;
using nodes::CurveShape;

constexpr double kSnap = 0.05,
                 kBetween = 0.0005;  // of a point dragged with Ctrl; between neighbours, at least

struct Preset {
  const char *id, *label;
  Curve curve;
};
const Preset kPresets[] = {
    {"identity", "Identity", {{{0, 0}, {1, 1}}, CurveShape::Smooth}},
    {"contrast", "Contrast", {{{0, 0}, {0.25, 0.1}, {0.5, 0.5}, {0.75, 0.9}, {1, 1}}, CurveShape::Smooth}},
    {"invert", "Invert", {{{0, 1}, {1, 0}}, CurveShape::Smooth}},
    {"threshold", "Threshold", {{{0, 0}, {0.5, 0}, {0.501, 1}, {1, 1}}, CurveShape::Linear}},
};

/// The graph's place on the screen and its mouse.
struct Plane {
  ImVec2 lo, hi;
  ImVec2 at(const dvec2& p) const {
    return {lo.x + static_cast<float>(p.x) * (hi.x - lo.x), hi.y - static_cast<float>(p.y) * (hi.y - lo.y)};
  }
  dvec2 value(ImVec2 p) const {
    return {static_cast<double>((p.x - lo.x) / (hi.x - lo.x)),
            static_cast<double>((hi.y - p.y) / (hi.y - lo.y))};
  }
};

double tidy(double v) { return std::round(v * 1e4) / 1e4; }

/// Kept within 0 .. 1 and between its neighbours.
dvec2 allowed(const Curve& curve, std::size_t i, dvec2 p) {
  const auto& points = curve.points;
  const double lo = i > 0 ? points[i - 1].x + kBetween : 0;
  const double hi = i + 1 < points.size() ? points[i + 1].x - kBetween : 1;
  return {tidy(std::min(std::max(p.x, lo), std::max(lo, hi))), tidy(std::clamp(p.y, 0.0, 1.0))};
}

int pointAt(const Curve& curve, const Plane& plane, ImVec2 mouse, float reach) {
  int nearest = -1;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const ImVec2 p = plane.at(curve.points[i]);
    const float distance = std::hypot(p.x - mouse.x, p.y - mouse.y);
    if (distance <= reach) reach = distance, nearest = static_cast<int>(i);
  }
  return nearest;
}

void setCurve(const ParamWidget& w, const Curve& curve, bool dragging) {
  setParamValue(w.room, w.target, curve, dragging);
}

void removePoint(const ParamWidget& w, Curve curve, int i) {
  if (curve.points.size() < 2) return w.room.ui.messages.hint("A curve keeps one point.");
  curve.points.erase(curve.points.begin() + i);
  w.room.parameters.points.selected = -1;
  setCurve(w, curve, false);
}

/// Where a point may be added, its number; nothing where one is in the way.
std::optional<std::size_t> placeFor(const Curve& curve, double x) {
  if (curve.points.size() >= nodes::kMostPoints) return std::nullopt;
  for (const dvec2& p : curve.points)
    if (std::abs(p.x - x) < 2 * kBetween) return std::nullopt;
  const auto next =
      std::find_if(curve.points.begin(), curve.points.end(), [x](const dvec2& p) { return p.x > x; });
  return static_cast<std::size_t>(next - curve.points.begin());
}

void press(const ParamWidget& w, Curve& curve, const Plane& plane) {
  PointEdit& edit = w.room.parameters.points;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  edit.key = w.target.key();
  edit.selected = pointAt(curve, plane, mouse, w.room.ui.theme.px(9));
  const dvec2 at = plane.value(mouse);
  const float away = std::abs(plane.at({at.x, nodes::curveAt(curve, at.x)}).y - mouse.y);
  if (edit.selected < 0 && (ImGui::IsMouseDoubleClicked(0) || away < w.room.ui.theme.px(7)))
    if (const auto place = placeFor(curve, std::clamp(at.x, 0.0, 1.0))) {
      const auto i = static_cast<std::ptrdiff_t>(*place);
      curve.points.insert(curve.points.begin() + i, dvec2(tidy(at.x), at.y));
      curve.points[*place] = allowed(curve, *place, curve.points[*place]);
      edit.selected = static_cast<int>(i);
      setCurve(w, curve, true);
    }
  edit.dragging = edit.selected >= 0;
  if (edit.dragging) edit.raw = curve.points[static_cast<std::size_t>(edit.selected)];
}

void drag(const ParamWidget& w, Curve& curve, const Plane& plane) {
  PointEdit& edit = w.room.parameters.points;
  const ImGuiIO& io = ImGui::GetIO();
  const auto i = static_cast<std::size_t>(edit.selected);
  const double share = io.KeyShift ? 0.1 : 1;
  edit.raw += share * dvec2(static_cast<double>(io.MouseDelta.x / (plane.hi.x - plane.lo.x)),
                            -static_cast<double>(io.MouseDelta.y / (plane.hi.y - plane.lo.y)));
  dvec2 to = edit.raw;
  if (io.KeyCtrl) to = glm::round(to / kSnap) * kSnap;
  to = allowed(curve, i, to);
  if (to == curve.points[i]) return;
  curve.points[i] = to;
  setCurve(w, curve, true);
}

void handleMouse(const ParamWidget& w, Curve& curve, const Plane& plane, bool hovered) {
  PointEdit& edit = w.room.parameters.points;
  const ImGuiIO& io = ImGui::GetIO();
  const int selected = edit.of(w.target.key(), curve.points.size());
  if (edit.dragging && selected >= 0) {
    const bool cancelled = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (!cancelled && ImGui::IsMouseDown(0)) {
      if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) drag(w, curve, plane);
      return;
    }
    edit.dragging = false;
    return endParamEdit(w.room.ui, w.room.session, w.room.parameters, w.target, cancelled);
  }
  if (!hovered) return;
  if (ImGui::IsMouseClicked(0)) return press(w, curve, plane);
  const int over = pointAt(curve, plane, io.MousePos, w.room.ui.theme.px(9));
  if (over >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (over >= 0 && ImGui::IsMouseClicked(1)) {
    edit.removing = true;
    removePoint(w, curve, over);
  } else if (selected >= 0 && !w.room.ui.fields.typing() &&
             ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete), false)) {
    removePoint(w, curve, selected);
  }
}

void drawGrid(const ParamWidget& w, const Plane& plane) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (int i = 1; i < 4; ++i) {
    const ImVec2 p = plane.at(dvec2(0.25 * i));
    const float x = std::round(p.x), y = std::round(p.y);
    draw->AddLine({x, plane.lo.y}, {x, plane.hi.y}, faded(palette::kLine, 0.7f));
    draw->AddLine({plane.lo.x, y}, {plane.hi.x, y}, faded(palette::kLine, 0.7f));
  }
  draw->AddLine(plane.at({0, 0}), plane.at({1, 1}), faded(palette::kTextFaint, 0.35f), w.room.ui.theme.px(1));
}

void drawLine(const ParamWidget& w, const Curve& curve, const Plane& plane) {
  const Theme& theme = w.room.ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::vector<double> xs;
  const int columns = std::max(2, static_cast<int>((plane.hi.x - plane.lo.x) / 2));
  for (int i = 0; i <= columns; ++i) xs.push_back(static_cast<double>(i) / columns);
  for (const dvec2& p : curve.points) xs.push_back(p.x);  // corners stay sharp
  std::sort(xs.begin(), xs.end());
  std::vector<ImVec2> line;
  for (const double x : xs) line.push_back(plane.at({x, nodes::curveAt(curve, x)}));
  draw->AddPolyline(line.data(), static_cast<int>(line.size()), palette::kAccent, 0, theme.px(2));
  const int selected = w.room.parameters.points.of(w.target.key(), curve.points.size());
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const ImVec2 p = plane.at(curve.points[i]);
    const bool on = static_cast<int>(i) == selected;
    const float r = theme.px(on ? 5 : 4);
    draw->AddCircleFilled(p, r + theme.px(1.5f), palette::kField);
    draw->AddCircleFilled(p, r, on ? palette::kSelect : palette::kAccent);
    const std::string name = "point/" + w.target.spec->id + "/" + std::to_string(i);
    w.room.ui.trace.rect(name, {p.x - r, p.y - r}, {p.x + r, p.y + r});
  }
}

void drawGraph(const ParamWidget& w, Curve& curve) {
  const Theme& theme = w.room.ui.theme;
  const float height = theme.px(150), pad = theme.px(7);
  const ImVec2 lo = ImGui::GetCursorScreenPos(), hi = {lo.x + w.width, lo.y + height};
  ImGui::InvisibleButton("graph", {w.width, height});
  w.room.ui.trace.item("curve/" + w.target.spec->id);
  const bool hovered = ImGui::IsItemHovered();
  const Plane plane{{lo.x + pad, lo.y + pad}, {hi.x - pad, hi.y - pad}};
  handleMouse(w, curve, plane, hovered);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(lo, hi, palette::kField, theme.px(4));
  const DataBehind data = dataBehind(w);
  drawHistogram(w, data, plane.lo, plane.hi);
  drawGrid(w, plane);
  drawLine(w, curve, plane);
  draw->AddRect(lo, hi, hovered ? palette::kTextFaint : palette::kLine, theme.px(4));
  ImGui::SetCursorScreenPos({lo.x, hi.y + theme.px(2)});
  drawRange(w, data, w.width);
}

/// A coordinate of the selected point.
void drawCoordinate(const ParamWidget& w, Curve& curve, int selected, int axis, float width) {
  const Theme& theme = w.room.ui.theme;
  const char* label = axis == 0 ? "In" : "Out";
  const float room = theme.px(28);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
  const float x = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(label);
  ImGui::PopStyleColor();
  ImGui::SameLine();
  ImGui::SetCursorPosX(x + room);
  NumberField f;
  f.hardMin = f.softMin = 0, f.hardMax = f.softMax = 1;
  f.mixed = f.locked = selected < 0;
  double value = selected < 0 ? 0 : curve.points[static_cast<std::size_t>(selected)][axis];
  const NumberEdit edit = numberField(w.room.ui.fields.number, theme, label, value, f, width - room);
  w.room.ui.trace.item(axis == 0 ? "point/in" : "point/out");
  if (edit.changed && selected >= 0) {
    dvec2 p = curve.points[static_cast<std::size_t>(selected)];
    p[axis] = value;
    curve.points[static_cast<std::size_t>(selected)] = allowed(curve, static_cast<std::size_t>(selected), p);
    setCurve(w, curve, edit.dragging);
  }
  followField(w, edit);
}

void drawPresets(const ParamWidget& w, float width) {
  const bool open = beginCombo(w.room.ui.theme, "##preset", "Presets", width);
  if (!open) return w.room.ui.trace.item("presets/" + w.target.spec->id);
  for (const Preset& p : kPresets) {
    if (ImGui::Selectable(p.label)) {
      w.room.parameters.points.selected = -1;
      setCurve(w, p.curve, false);
    }
    w.room.ui.trace.item(std::string("preset/") + p.id);
  }
  ImGui::EndCombo();
}

}  // namespace

void drawCurve(const ParamWidget& w) {
  const Theme& theme = w.room.ui.theme;
  nodes::Curve curve = std::get<nodes::Curve>(w.state.value);
  drawGraph(w, curve);
  const int selected = w.room.parameters.points.of(w.target.key(), curve.points.size());
  const float gap = theme.px(8), half = std::floor(0.5f * (w.width - gap));
  drawCoordinate(w, curve, selected, 0, half);
  ImGui::SameLine(0, gap);
  drawCoordinate(w, curve, selected, 1, half);
  if (const auto shape = shapeField(w, curve.shape, half)) {
    curve.shape = *shape;
    setCurve(w, curve, false);
  }
  ImGui::SameLine(0, gap);
  drawPresets(w, half);
}

}  // namespace pileus::editor
