#include "editor/viewport/corner_widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/camera_control.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/handles/shadow_place.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"

namespace pileus::editor {
namespace {

/// A square over the picture that can be pressed. ImGui's own items would take the pointer from drags.
bool pressable(Ui& ui, Viewport& viewport, vec2 lo, vec2 hi, const char* sign, bool on, bool hovered,
               const std::string& trace, const std::string& help) {
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const vec2 p = vec(ImGui::GetIO().MousePos);
  const bool over = hovered && p.x >= lo.x && p.x < hi.x && p.y >= lo.y && p.y < hi.y;
  if (on || over)
    draw->AddRectFilled(im(lo), im(hi), on ? palette::kAccentDim : palette::kButtonHover, theme.px(4));
  const float width = textWidth(theme.body, sign);
  drawText(draw, theme.body, {0.5f * (lo.x + hi.x - width), 0.5f * (lo.y + hi.y - theme.body->FontSize)},
           on ? palette::kTextStrong : palette::kText, sign, width + 4);
  ui.trace.rect(trace, im(lo), im(hi));
  if (!over) return false;
  viewport.tools.overWidget = true;
  if (viewport.drag == Viewport::Drag::None && !viewport.tools.drag) tooltip(theme, help);
  return ImGui::IsMouseClicked(0);
}

void overlayMenu(Ui& ui) {
  static constexpr std::array kIds = {
      "viewport.overlays",    "viewport.show_bounds", "viewport.show_bricks",     "viewport.show_lights",
      "viewport.show_solids", "viewport.show_grid",   "viewport.show_safe_frame", "viewport.show_axes"};
  if (!ImGui::BeginPopup("##overlay menu")) return;
  for (const char* id : kIds) {
    commandMenuItem(ui, id);
    if (id == kIds[0]) ImGui::Separator();
  }
  ImGui::EndPopup();
}

void chipText(Ui& ui, vec2 lo, vec2 hi, const std::string& text, const char* note, float row) {
  const Theme& theme = ui.theme;
  const float width = std::min(textWidth(theme.body, text), hi.x - lo.x - theme.space(8));
  const vec2 pad(theme.space(3), theme.px(6)), size(width, theme.body->FontSize);
  const vec2 at(std::round(0.5f * (lo.x + hi.x - size.x) - pad.x),
                std::round(hi.y - theme.space(4) - (size.y + 2 * pad.y) - row));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(at), im(at + size + 2.0f * pad), palette::kChip, theme.px(5));
  drawText(draw, theme.body, at + pad, palette::kText, text, size.x + 1);
  ui.trace.note(note, text);
}

constexpr float kToolSize = 28, kToolPad = 3, kAxisArm = 26, kAxisDot = 7;

float stripHeight(const Theme& theme) { return theme.px(6 * kToolSize + 2 * kToolPad + 7); }

}  // namespace

float toolStripWidth(const Theme& theme, vec2 min, vec2 max) {
  const bool fits =
      min.y + theme.px(40) + stripHeight(theme) <= max.y - theme.px(8) && max.x - min.x >= theme.px(240);
  return fits ? theme.space(2) + theme.px(kToolSize + 2 * kToolPad) : 0;
}

ScreenRect shownCorners(const Shown& shown) { return {shown.places.front().min, shown.places.back().max}; }

float axisCrossHeight(const Theme& theme, const Shown& shown, const Settings& settings, vec2 min, vec2 max) {
  const auto& overlays = settings.view.overlays;
  if (!overlays.on || !overlays.axes || max.x - min.x < theme.px(240) || max.y - min.y < theme.px(150))
    return 0;
  return theme.space(2) + 2 * theme.px(kAxisArm + kAxisDot) + (shown.compare.on ? theme.px(28) : 0);
}

void drawToolStrip(Ui& ui, Settings& settings, Viewport& viewport, vec2 min, vec2 max, bool hovered) {
  const Theme& theme = ui.theme;
  ViewportTools& tools = viewport.tools;
  struct Tool {
    const char* sign;
    const char* id;
    const char* help;
    GizmoMode mode;
  };
  static constexpr Tool kTools[] = {
      {icon::kPointer, "select", "Select: a click chooses what is under the pointer (Q)", GizmoMode::Select},
      {icon::kMove, "move", "Move (W). Ctrl snaps, Shift is fine, Esc takes it back", GizmoMode::Move},
      {icon::kRefresh, "rotate", "Rotate (E). Ctrl snaps to 15 degrees", GizmoMode::Rotate},
      {icon::kExpand, "scale", "Scale (R), always along the node's own axes", GizmoMode::Scale}};
  const float size = theme.px(kToolSize), pad = theme.px(kToolPad), height = stripHeight(theme);
  const vec2 lo(min.x + theme.space(2), min.y + theme.px(40));
  if (toolStripWidth(ui.theme, min, max) == 0) {
    overlayMenu(ui);
    return;
  }
  ImGui::GetWindowDrawList()->AddRectFilled(im(lo), im(lo + vec2(size + 2 * pad, height)), palette::kChip,
                                            theme.px(6));
  vec2 at = lo + pad;
  for (const Tool& t : kTools) {
    if (pressable(ui, viewport, at, at + size, t.sign, tools.mode == t.mode, hovered,
                  std::string("viewport/tool/") + t.id, t.help))
      setGizmoMode(viewport, t.mode);
    at.y += size;
  }
  at.y += theme.px(3);
  ImGui::GetWindowDrawList()->AddLine({at.x + theme.px(4), at.y}, {at.x + size - theme.px(4), at.y},
                                      palette::kLine);
  at.y += theme.px(4);
  bool& local = settings.view.localAxes;
  if (pressable(ui, viewport, at, at + size, local ? icon::kCube : icon::kGlobe, false, hovered,
                "viewport/axes",
                local ? "Handles along the node's own axes (X changes)"
                      : "Handles along the world's axes (X changes)"))
    local = !local;
  at.y += size;
  if (pressable(ui, viewport, at, at + size, icon::kEye, false, hovered, "viewport/overlays",
                "What is drawn over the picture"))
    ImGui::OpenPopup("##overlay menu");
  overlayMenu(ui);
  ui.trace.note("gizmo mode", std::to_string(static_cast<int>(tools.mode)));
}

void drawAxisCross(const ViewportRoom& room, const Projection& view, bool hovered) {
  if (axisCrossHeight(room.ui.theme, room.shown, room.settings, view.min(), view.max()) == 0) return;
  const Theme& theme = room.ui.theme;
  ViewportTools& tools = room.viewport.tools;
  const float arm = theme.px(kAxisArm), dot = theme.px(kAxisDot);
  const float below = room.shown.compare.on ? theme.px(28) : 0;
  const vec2 c(view.max().x - arm - dot - theme.space(3), view.min().y + arm + dot + theme.space(2) + below);
  struct End {
    int axis;
    double sign;
    dvec3 direction;
    vec2 at;
    double depth;
  };
  std::array<End, 6> ends;
  for (int i = 0; i < 6; ++i) {
    dvec3 d(0);
    d[i / 2] = i % 2 ? -1 : 1;
    ends[static_cast<std::size_t>(i)] = {i / 2, d[i / 2], d,
                                         c + arm * vec2(static_cast<float>(glm::dot(d, view.right())),
                                                        -static_cast<float>(glm::dot(d, view.up()))),
                                         glm::dot(d, view.forward())};
  }
  std::sort(ends.begin(), ends.end(),
            [](const End& a, const End& b) { return a.depth > b.depth; });  // nearest last
  const vec2 p = vec(ImGui::GetIO().MousePos);
  const bool near = hovered && glm::length(p - c) < arm + 2 * dot;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (near) {
    tools.overWidget = true;
    draw->AddCircleFilled(im(c), arm + dot + theme.px(3), palette::kChip, 48);
  }
  const End* over = nullptr;
  if (near)
    for (const End& e : ends)
      if (glm::length(p - e.at) < dot + 2) over = &e;
  const ImU32 inks[] = {palette::kAxisX, palette::kAxisY, palette::kAxisZ};
  static constexpr const char* kNames[] = {"X", "Y", "Z"};
  static constexpr const char* kTrace[] = {"axis/x", "axis/y", "axis/z", "axis/-x", "axis/-y", "axis/-z"};
  for (const End& e : ends) {
    const ImU32 ink = &e == over ? palette::kSelect : inks[e.axis];
    const bool front = e.sign > 0;
    if (front) {
      draw->AddLine(im(c), im(e.at), palette::kHandleEdge, 4 * theme.scale);
      draw->AddLine(im(c), im(e.at), ink, 2 * theme.scale);
      draw->AddCircleFilled(im(e.at), dot + 1, palette::kHandleEdge);
      draw->AddCircleFilled(im(e.at), dot, ink);
      const float width = textWidth(theme.small, kNames[e.axis]);
      drawText(draw, theme.small, {e.at.x - 0.5f * width, e.at.y - 0.5f * theme.small->FontSize},
               palette::kHandleEdge | IM_COL32_A_MASK, kNames[e.axis], width + 2);
    } else if (near) {
      draw->AddCircleFilled(im(e.at), dot - 1, faded(ink, 0.45f));
      draw->AddCircle(im(e.at), dot - 1, ink, 0, theme.scale);
    }
    room.ui.trace.rect(kTrace[e.axis + (front ? 0 : 3)], im(e.at - 2.0f), im(e.at + 2.0f));
  }
  room.ui.trace.rect("axis/back", im(c - 2.0f), im(c + 2.0f));
  if (near && room.viewport.drag == Viewport::Drag::None)
    tooltip(theme, over ? std::string("Look along ") + (over->sign > 0 ? "" : "-") + kNames[over->axis] +
                              "; once more looks from the other side"
                   : tools.beforeAxis ? "A right click goes back"
                                      : "Click an axis to look along it");
  if (near && ImGui::IsMouseClicked(1) && tools.beforeAxis) {
    setCamera(room.ui.messages, room.session, room.clock, room.shown, *tools.beforeAxis, "Camera back", {});
    tools.beforeAxis.reset();
  }
  if (over && ImGui::IsMouseClicked(0)) {
    const scene::Camera now = currentCamera(room.session, room.clock, room.shown);
    const bool there = over->depth < -0.999;  // already from that side
    if (!tools.beforeAxis) tools.beforeAxis = now;
    setCamera(room.ui.messages, room.session, room.clock, room.shown,
              seenFrom(now, there ? -over->direction : over->direction), "Look along an axis", {});
  }
}

void drawToolHints(const ViewportRoom& room, vec2 min, vec2 max, bool hovered) {
  const Theme& theme = room.ui.theme;
  ViewportTools& tools = room.viewport.tools;
  float row = 0;
  const float step = theme.body->FontSize + theme.px(18);
  if (const std::string hint = shadowPlaceHint(tools); !hint.empty())
    chipText(room.ui, min, max, hint, "viewport hint", row), row += step;
  if (!room.shown.look.light.empty()) {
    const std::string text = "Light: " + room.shown.look.light + "  " + icon::kTimes;
    const float width = textWidth(theme.body, text);
    const vec2 pad(theme.space(3), theme.px(6));
    const vec2 lo(std::round(0.5f * (min.x + max.x - width) - pad.x), min.y + theme.space(2));
    const vec2 hi = lo + vec2(width, theme.body->FontSize) + 2.0f * pad;
    ImGui::GetWindowDrawList()->AddRectFilled(im(lo), im(hi), palette::kChip, theme.px(5));
    ImGui::GetWindowDrawList()->AddRect(im(min + 1.0f), im(max - 1.0f), palette::kLightSocket, 0, 0,
                                        2 * theme.scale);
    if (pressable(room.ui, room.viewport, lo, hi, text.c_str(), false, hovered, "viewport/light",
                  "Orbiting moves the light. A click or Esc goes back to the camera"))
      leaveLightView(room.session, room.shown);
    room.ui.trace.note("viewport light", room.shown.look.light);
  }
  if (aroundCamera(room.session, room.shown) && room.shown.look.light.empty()) {
    const std::string text =
        fmt::format("{}  Looking around \xc2\xb7 Back to {}", icon::kEye, room.shown.around.camera);
    const float width = textWidth(theme.body, text);
    const vec2 pad(theme.space(3), theme.px(6));
    const vec2 lo(std::round(0.5f * (min.x + max.x - width) - pad.x), min.y + theme.space(2));
    const vec2 hi = lo + vec2(width, theme.body->FontSize) + 2.0f * pad;
    ImGui::GetWindowDrawList()->AddRectFilled(im(lo), im(hi), palette::kChip, theme.px(5));
    if (pressable(room.ui, room.viewport, lo, hi, text.c_str(), false, hovered, "viewport/around",
                  "The camera is locked and stays as it is. A click or Backspace goes back to it"))
      backToCamera(room.shown);
    room.ui.trace.note("looking around", room.shown.around.camera);
  }
  // What the chosen tool cannot do with this node.
  const std::string name = onlySelected(room.session);
  if (tools.drag || tools.mode == GizmoMode::Select || !canInsertTransform(room.session)) return;
  const auto target = gizmoTarget(room.session.document.graph(), name, {}, room.clock.frame);
  const bool able = target && (tools.mode == GizmoMode::Move     ? target->moves
                               : tools.mode == GizmoMode::Rotate ? target->turns
                                                                 : target->scales);
  if (able) return;
  const std::string text = std::string(icon::kPlus) + "  Insert Transform after " + name;
  const float width = textWidth(theme.body, text);
  const vec2 pad(theme.space(3), theme.px(6));
  const vec2 lo(std::round(0.5f * (min.x + max.x - width) - pad.x),
                std::round(max.y - theme.space(4) - theme.body->FontSize - 2 * pad.y - row));
  const vec2 hi = lo + vec2(width, theme.body->FontSize) + 2.0f * pad;
  ImGui::GetWindowDrawList()->AddRectFilled(im(lo), im(hi), palette::kChip, theme.px(5));
  if (pressable(room.ui, room.viewport, lo, hi, text.c_str(), false, hovered, "viewport/insert_transform",
                "This volume has nothing to drag that way: a Transform node has"))
    insertTransform(room.ui, room.session);
}

}  // namespace pileus::editor
