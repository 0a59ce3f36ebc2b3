#include "editor/app/panels.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "editor/app/panel_areas.h"
#include "editor/commands/menu.h"
#include "editor/commands/panel_commands.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/canvas_menus.h"
#include "editor/graph_view/frames.h"
#include "editor/lab/lab.h"
#include "editor/lab/ray_scope.h"
#include "editor/lights/lights_panel.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/compare_mode.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/panel_list.h"
#include "editor/preferences/settings.h"
#include "editor/status/log_panel.h"
#include "editor/status/status_line.h"
#include "editor/status/toasts.h"
#include "editor/timeline_view/timeline_panel.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/viewport.h"

namespace pileus::editor {
namespace {

constexpr float kBar = 36, kGrip = 6;

void drawGraphPanel(Editor& editor, ImVec2 min, ImVec2 max, bool hovered) {
  drawCanvas(editor.graphRoom, min, max, hovered);
  drawCanvasMenu(editor.graphRoom);
  drawFrameTitleField(editor.ui, editor.session, editor.canvas);
  drawSearch(editor.graphRoom);
  drawFind(editor.ui, editor.session, editor.clock, editor.canvas);
}

void drawContent(Editor& editor, Panel panel, ImVec2 min, ImVec2 max, bool hovered) {
  switch (panel) {
    case Panel::Viewport:
      return drawViewport(editor.viewportRoom, min, max, hovered);
    case Panel::Graph:
      return drawGraphPanel(editor, min, max, hovered);
    case Panel::Parameters:
      return drawParameters(editor.parameterRoom, min, max);
    case Panel::Scope:
      return drawRayScope(editor.ui, editor.shown, editor.settings, editor.scope, min, max);
    case Panel::Lab:
      return drawLab(editor.labRoom, min, max);
    case Panel::Log:
      return drawLog(editor.ui, editor.logPanel, min, max);
    case Panel::Timeline:
      return drawTimeline(editor.timelineRoom, min, max);
    case Panel::Lights:
      return drawLights(editor.lightsRoom, min, max);
    case Panel::Global:
      return;
  }
}

/// A panel that cannot be seen holds neither keys nor clicks.
void forgetHidden(Editor& editor, Panel panel) {
  if (panel == Panel::Graph) {
    editor.canvas.interaction.armed.reset();
    editor.canvas.search.opening = editor.canvas.find.opening = false;
  } else if (panel == Panel::Parameters) {
    editor.parameters.eyedropper.target.reset();
    if (std::exchange(editor.parameters.points.dragging, false)) editor.session.document.endMerge();
  }
}

constexpr ImGuiWindowFlags kFixed =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav;

/// A fixed window without padding.
void beginFixed(const char* id, ImVec2 min, ImVec2 max, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos(min);
  ImGui::SetNextWindowSize({std::max(max.x - min.x, 1.0f), std::max(max.y - min.y, 1.0f)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(id, nullptr, flags);
  ImGui::PopStyleVar(2);
}

bool inside(const PanelRect& r, ImVec2 p) {
  return p.x >= r.min.x && p.x < r.max.x && p.y >= r.min.y && p.y < r.max.y;
}

/// The parameters' corner holds buttons of the node.
bool hasCorner(const PanelInfo& info) { return info.panel != Panel::Parameters; }

/// The corner that shows, while the pointer is in it or in the panel's bar, buttons to maximise and hide it.
PanelRect cornerOf(const Editor& editor, const PanelInfo& info, const PanelRect& r) {
  const Theme& theme = editor.theme;
  const float size = theme.px(28), right = r.max.x - theme.px(info.inset) - theme.px(4);
  const float buttons = info.inset > 0 ? 1 : 2;  // those with a button of their own close by that
  const float top = r.min.y + theme.px(4);
  return {{right - buttons * size, top}, {right, top + size}};
}

bool cornerButton(Editor& editor, ImVec2 at, float size, const char* mark, const std::string& trace,
                  const std::string& help) {
  const Theme& theme = editor.theme;
  ImGui::SetCursorScreenPos(at);
  const bool pressed = ImGui::InvisibleButton(trace.c_str(), {size, size});
  editor.trace.item(trace);
  const bool over = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (over) draw->AddRectFilled(at, {at.x + size, at.y + size}, palette::kButtonHover, theme.px(4));
  drawText(
      draw, theme.small,
      {at.x + 0.5f * (size - textWidth(theme.small, mark)), at.y + 0.5f * (size - theme.small->FontSize)},
      over ? palette::kTextStrong : palette::kTextDim, mark, size);
  if (over) tooltip(theme, help);
  return pressed;
}

/// On top of the panel's own content, in a window of its own so that clicks do not go through.
void drawCorner(Editor& editor, const PanelInfo& info, const PanelRect& r) {
  const Theme& theme = editor.theme;
  const PanelRect corner = cornerOf(editor, info, r);
  const std::string id = std::string("##corner ") + info.id, trace = std::string("panel/") + info.id;
  beginFixed(id.c_str(), im(corner.min), im(corner.max),
             (kFixed | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing) &
                 ~ImGuiWindowFlags_NoBringToFrontOnFocus);
  const float size = corner.max.y - corner.min.y;
  ImGui::GetWindowDrawList()->AddRectFilled(im(corner.min), im(corner.max), palette::kBar, theme.px(4));
  const bool whole = editor.now.maximised == info.panel;
  if (cornerButton(editor, im(corner.min), size, whole ? icon::kCompress : icon::kExpand, trace + "/maximise",
                   whole ? "Back to all panels (Ctrl+Space)" : "Fill the window (Ctrl+Space)"))
    toggleMaximised(editor, info.panel);
  if (info.inset == 0 && cornerButton(editor, {corner.min.x + size, corner.min.y}, size, icon::kTimes,
                                      trace + "/hide", "Hide; View > Panels brings it back"))
    setPanelOpen(editor, info.panel, false);
  ImGui::End();
}

/// Returns whether the pointer is over the panel and nothing covers it.
bool drawPanel(Editor& editor, const PanelInfo& info, const PanelRect& r) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool inCorner = hasCorner(info) && inside(cornerOf(editor, info, r), mouse);
  beginFixed((std::string("##") + info.id).c_str(), im(r.min), im(r.max), kFixed);
  const bool over =
      ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  drawContent(editor, info.panel, im(r.min), im(r.max), ImGui::IsWindowHovered() && !inCorner);
  // Double click on the empty part of its bar.
  const PanelRect bar{r.min, {r.max.x, r.min.y + editor.theme.px(info.bar)}};
  if (info.bar > 0 && over && inside(bar, mouse) && ImGui::IsMouseDoubleClicked(0) &&
      !ImGui::IsAnyItemHovered())
    toggleMaximised(editor, info.panel);
  ImGui::End();
  const PanelRect band{{std::max(r.min.x, r.max.x - editor.theme.px(180)), r.min.y},
                       {r.max.x, r.min.y + editor.theme.px(kBar)}};
  const bool held = ImGui::IsMouseDown(0) || ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2);
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (hasCorner(info) && inside(band, mouse) && (over || inCorner) && (inCorner || !held) && !popup)
    drawCorner(editor, info, r);
  return over || (inCorner && !popup);
}

void drawSplitter(Editor& editor, const PanelSplitter& s) {
  PanelRect r = s.strip;
  // Easier to hit than to see.
  const vec2 more = s.vertical ? vec2(0.5f * (editor.theme.px(kGrip) - (r.max.x - r.min.x)), 0)
                               : vec2(0, 0.5f * (editor.theme.px(kGrip) - (r.max.y - r.min.y)));
  r = {r.min - more, r.max + more};
  beginFixed(s.id, im(r.min), im(r.max),
             (kFixed | ImGuiWindowFlags_NoBackground) & ~ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::InvisibleButton("grip", im(r.max - r.min));
  editor.trace.item(s.id);
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (active || hovered) {
    ImGui::SetMouseCursor(s.vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled(im(s.strip.min), im(s.strip.max),
                                              active ? palette::kAccent : palette::kAccentDim);
  }
  double& length = editor.settings.*s.length;
  if (hovered && ImGui::IsMouseDoubleClicked(0)) {
    length = PanelLayout{}.*s.length;
  } else if (active) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    length += static_cast<double>(s.vertical ? moved.x : moved.y) * s.perPixel;
    clampLengths(editor.settings);
  }
  ImGui::End();
}

}  // namespace

void drawPanels(Editor& editor) {
  const float top = drawMenuBar(editor);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float bottom = std::max(display.y - editor.theme.px(26), top + 1);
  // A panel that was closed in another way while it filled the window gives it back.
  if (editor.now.maximised != Panel::Global && !(editor.settings.*panelInfo(editor.now.maximised).shown))
    editor.now.maximised = Panel::Global;
  const PanelAreas areas =
      panelAreas(editor.settings, editor.now.maximised, {0, top}, {display.x, bottom}, editor.theme);
  Panel hovered = Panel::Global;
  for (const PanelInfo& info : allPanels())
    if (areas[info.panel].empty())
      forgetHidden(editor, info.panel);
    else if (drawPanel(editor, info, areas[info.panel]))
      hovered = info.panel;
  beginFixed("##status", {0, bottom}, display, kFixed);
  drawStatusLine(editor.statusRoom, {0, bottom}, display);
  ImGui::End();
  for (const PanelSplitter& s : areas.splitters) drawSplitter(editor, s);
  drawToasts(editor.ui, {display.x, bottom});
  editor.now.hovered = hovered;
}

}  // namespace pileus::editor
