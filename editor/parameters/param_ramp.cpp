// The widget of a colour ramp: the histogram, a bar of colours as the viewport shows them, and its stops
// below as handles; then the selected stop's position and colour.
#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/parameters/color_picker.h"
#include "editor/parameters/data_behind.h"
#include "editor/parameters/param_widgets.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/display_color.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using nodes::Ramp;
using nodes::RampShape;
using nodes::RampStop;

constexpr double kSnap = 0.05;  // of a stop dragged with Ctrl

double tidy(double v) { return std::round(std::clamp(v, 0.0, 1.0) * 1e4) / 1e4; }

/// Where the parts are on the screen: histogram, bar and handles from top to bottom.
struct Lanes {
  float left = 0, right = 0, top = 0, bar = 0, handles = 0, bottom = 0;
  float x(double at) const { return left + static_cast<float>(at) * (right - left); }
  double at(float px) const { return static_cast<double>((px - left) / (right - left)); }
};

void setRamp(const ParamWidget& w, const Ramp& ramp, bool dragging) {
  setParamValue(w.room, w.target, ramp, dragging);
}

int stopAt(const ParamWidget& w, const Ramp& ramp, const Lanes& lanes, ImVec2 mouse) {
  if (mouse.y < lanes.handles - w.room.ui.theme.px(3)) return -1;
  int nearest = -1;
  float reach = w.room.ui.theme.px(8);
  for (std::size_t i = 0; i < ramp.stops.size(); ++i)
    if (const float d = std::abs(lanes.x(ramp.stops[i].at) - mouse.x); d <= reach)
      reach = d, nearest = static_cast<int>(i);
  return nearest;
}

void removeStop(const ParamWidget& w, Ramp ramp, int i) {
  if (ramp.stops.size() < 2) return w.room.ui.messages.hint("A ramp keeps one stop.");
  ramp.stops.erase(ramp.stops.begin() + i);
  w.room.parameters.points.selected = -1;
  setRamp(w, ramp, false);
}

/// With the colour that is there already.
void addStop(const ParamWidget& w, Ramp& ramp, double at) {
  if (ramp.stops.size() >= nodes::kMostPoints) return w.room.ui.messages.hint("There are enough stops.");
  dvec3 color = nodes::rampAt(ramp, at);
  for (int c = 0; c < 3; ++c) color[c] = tidy(color[c]);
  const auto next =
      std::find_if(ramp.stops.begin(), ramp.stops.end(), [at](const RampStop& s) { return s.at > at; });
  PointEdit& edit = w.room.parameters.points;
  edit.selected = static_cast<int>(next - ramp.stops.begin());
  ramp.stops.insert(next, RampStop{tidy(at), color});
  setRamp(w, ramp, true);
}

/// Dragging stops at the neighbours.
void moveStop(const ParamWidget& w, Ramp& ramp, std::size_t i, double at, bool dragging) {
  const double lo = i > 0 ? ramp.stops[i - 1].at : 0,
               hi = i + 1 < ramp.stops.size() ? ramp.stops[i + 1].at : 1;
  at = tidy(std::clamp(at, lo, hi));
  if (at == ramp.stops[i].at) return;
  ramp.stops[i].at = at;
  setRamp(w, ramp, dragging);
}

/// True: the picker of the selected stop is wanted.
bool press(const ParamWidget& w, Ramp& ramp, const Lanes& lanes) {
  PointEdit& edit = w.room.parameters.points;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int over = stopAt(w, ramp, lanes, mouse);
  edit.key = w.target.key();
  edit.selected = over;
  if (ImGui::IsMouseDoubleClicked(0)) {
    if (over >= 0) return true;
    addStop(w, ramp, std::clamp(lanes.at(mouse.x), 0.0, 1.0));
  }
  edit.dragging = edit.selected >= 0;
  if (edit.dragging) edit.raw.x = ramp.stops[static_cast<std::size_t>(edit.selected)].at;
  return false;
}

bool handleMouse(const ParamWidget& w, Ramp& ramp, const Lanes& lanes, bool hovered) {
  PointEdit& edit = w.room.parameters.points;
  const ImGuiIO& io = ImGui::GetIO();
  const int selected = edit.of(w.target.key(), ramp.stops.size());
  if (edit.dragging && selected >= 0) {
    const bool cancelled = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (!cancelled && ImGui::IsMouseDown(0)) {
      if (io.MouseDelta.x == 0) return false;
      edit.raw.x +=
          (io.KeyShift ? 0.1 : 1) * static_cast<double>(io.MouseDelta.x / (lanes.right - lanes.left));
      const double to = io.KeyCtrl ? std::round(edit.raw.x / kSnap) * kSnap : edit.raw.x;
      moveStop(w, ramp, static_cast<std::size_t>(selected), to, true);
      return false;
    }
    edit.dragging = false;
    endParamEdit(w.room.ui, w.room.session, w.room.parameters, w.target, cancelled);
    return false;
  }
  if (!hovered) return false;
  if (ImGui::IsMouseClicked(0)) return press(w, ramp, lanes);
  const int over = stopAt(w, ramp, lanes, io.MousePos);
  if (over >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (over >= 0 && ImGui::IsMouseClicked(1)) {
    edit.removing = true;
    removeStop(w, ramp, over);
  } else if (selected >= 0 && !w.room.ui.fields.typing() &&
             ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete), false)) {
    removeStop(w, ramp, selected);
  }
  return false;
}

/// Colours through the display transform, a few pixels apart.
void drawBar(const ParamWidget& w, const Ramp& ramp, const Lanes& lanes) {
  const int columns = std::max(1, static_cast<int>(lanes.right - lanes.left) / 2);
  std::vector<vec4> colors;
  for (int i = 0; i < columns; ++i) colors.emplace_back(vec3(nodes::rampAt(ramp, (i + 0.5) / columns)), 1.0f);
  toDisplay(w.room.shown, colors);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (int i = 0; i < columns; ++i) {
    const vec4 c = glm::clamp(colors[static_cast<std::size_t>(i)], vec4(0), vec4(1));
    draw->AddRectFilled(
        {lanes.x(static_cast<double>(i) / columns), lanes.bar},
        {lanes.x(static_cast<double>(i + 1) / columns), lanes.handles - w.room.ui.theme.px(2)},
        ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1}));
  }
}

/// A tag below the bar, in the stop's colour.
void drawStops(const ParamWidget& w, const Ramp& ramp, const Lanes& lanes) {
  const Theme& theme = w.room.ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const int selected = w.room.parameters.points.of(w.target.key(), ramp.stops.size());
  const auto one = [&](std::size_t i) {
    const bool on = static_cast<int>(i) == selected;
    const float x = std::round(lanes.x(ramp.stops[i].at)), r = theme.px(5), y = lanes.handles;
    const ImVec2 tag[5] = {
        {x, y}, {x + r, y + r}, {x + r, lanes.bottom}, {x - r, lanes.bottom}, {x - r, y + r}};
    draw->AddConvexPolyFilled(tag, 5,
                              displayColor(w.room.shown, w.room.parameters.colors, ramp.stops[i].color));
    draw->AddPolyline(tag, 5, on ? palette::kSelect : palette::kTextDim, ImDrawFlags_Closed,
                      theme.px(on ? 2 : 1));
    w.room.ui.trace.rect("stop/" + w.target.spec->id + "/" + std::to_string(i), {x - r, y},
                         {x + r, lanes.bottom});
  };
  for (std::size_t i = 0; i < ramp.stops.size(); ++i) one(i);
  if (selected >= 0) one(static_cast<std::size_t>(selected));  // on top
}

bool drawLanes(const ParamWidget& w, Ramp& ramp) {
  const Theme& theme = w.room.ui.theme;
  const ImVec2 lo = ImGui::GetCursorScreenPos();
  const float pad = theme.px(7);
  Lanes lanes;
  lanes.left = lo.x + pad, lanes.right = lo.x + w.width - pad;
  lanes.top = lo.y + theme.px(4), lanes.bar = lanes.top + theme.px(40),
  lanes.handles = lanes.bar + theme.px(24);
  lanes.bottom = lanes.handles + theme.px(13);
  const ImVec2 hi = {lo.x + w.width, lanes.bottom + theme.px(4)};
  ImGui::InvisibleButton("ramp", {w.width, hi.y - lo.y});
  w.room.ui.trace.item("ramp/" + w.target.spec->id);
  const bool hovered = ImGui::IsItemHovered();
  const bool wanted = handleMouse(w, ramp, lanes, hovered);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(lo, hi, palette::kField, theme.px(4));
  const DataBehind data = dataBehind(w);
  drawHistogram(w, data, {lanes.left, lanes.top}, {lanes.right, lanes.bar});
  drawBar(w, ramp, lanes);
  draw->AddRect({lanes.left, lanes.bar}, {lanes.right, lanes.handles - theme.px(2)}, palette::kLine);
  drawStops(w, ramp, lanes);
  draw->AddRect(lo, hi, hovered ? palette::kTextFaint : palette::kLine, theme.px(4));
  ImGui::SetCursorScreenPos({lo.x, hi.y + theme.px(2)});
  drawRange(w, data, w.width);
  return wanted;
}

void drawPosition(const ParamWidget& w, Ramp& ramp, int selected, float width) {
  NumberField f;
  f.hardMin = f.softMin = 0, f.hardMax = f.softMax = 1;
  f.mixed = f.locked = selected < 0;
  double value = selected < 0 ? 0 : ramp.stops[static_cast<std::size_t>(selected)].at;
  const NumberEdit edit = numberField(w.room.ui.fields.number, w.room.ui.theme, "position", value, f, width);
  w.room.ui.trace.item("stop/position");
  if (edit.changed && selected >= 0)
    moveStop(w, ramp, static_cast<std::size_t>(selected), value, edit.dragging);
  followField(w, edit);
}

/// The picker of the selected stop, while it is open.
void drawPicker(const ParamWidget& w, Ramp& ramp, int selected) {
  const ParameterRoom& room = w.room;
  ColorPicker& picker = room.parameters.picker;
  const std::string key = w.target.key() + " stop";
  const bool there = selected >= 0;
  if (!ImGui::BeginPopup("picker")) {
    if (picker.open && picker.key == key)
      closeColorPicker(picker, there ? ramp.stops[static_cast<std::size_t>(selected)].color : picker.before);
    return;
  }
  if (there) {
    const auto i = static_cast<std::size_t>(selected);
    picker.key = key;
    const ColorEdit edit = drawColorPicker(room.ui, room.shown, room.parameters, ramp.stops[i].color,
                                           w.target.spec->hardMin, w.target.spec->hardMax);
    const ImVec2 at = ImGui::GetWindowPos();
    room.ui.trace.rect("picker", at, {at.x + ImGui::GetWindowWidth(), at.y + ImGui::GetWindowHeight()});
    if (edit.changed && !edit.cancelled) setRamp(w, ramp, edit.dragging);
    if (edit.finished) endParamEdit(room.ui, room.session, room.parameters, w.target, edit.cancelled);
    if (edit.eyedropper) {
      room.parameters.eyedropper.target = w.target;
      room.parameters.eyedropper.into = [i](const nodes::ParamValue& own, const dvec3& color) {
        Ramp next = std::get<Ramp>(own);
        if (i < next.stops.size()) next.stops[i].color = color;
        return nodes::ParamValue(next);
      };
    }
    if (edit.eyedropper) ImGui::CloseCurrentPopup();
  } else {
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

void drawRamp(const ParamWidget& w) {
  const Theme& theme = w.room.ui.theme;
  Ramp ramp = std::get<Ramp>(w.state.value);
  const bool wanted = drawLanes(w, ramp);
  const int selected = w.room.parameters.points.of(w.target.key(), ramp.stops.size());
  const float gap = theme.px(8), swatch = std::round(ImGui::GetFrameHeight() * 1.3f);
  const float half = std::floor(0.5f * (w.width - gap));
  drawPosition(w, ramp, selected, half - swatch - theme.px(4));
  ImGui::SameLine(0, theme.px(4));
  const dvec3 color = selected < 0 ? dvec3(0) : ramp.stops[static_cast<std::size_t>(selected)].color;
  const bool clicked = colorSwatch(w.room.ui.theme, w.room.shown, w.room.parameters, "swatch", color,
                                   {swatch, ImGui::GetFrameHeight()}, selected < 0);
  w.room.ui.trace.item("swatch/" + w.target.spec->id);
  if (selected < 0 && ImGui::IsItemHovered())
    tooltip(theme, "Click a stop below the bar; a double click on the bar adds one");
  ImGui::SameLine(0, gap);
  if (const auto shape = shapeField(w, ramp.shape, half)) {
    ramp.shape = *shape;
    setRamp(w, ramp, false);
  }
  if (wanted || (clicked && selected >= 0)) ImGui::OpenPopup("picker");
  drawPicker(w, ramp, selected);
}

}  // namespace pileus::editor
