#include "editor/panels/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/editor.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/canvas_menus.h"
#include "editor/menu.h"
#include "editor/panels/lab.h"
#include "editor/panels/log.h"
#include "editor/panels/parameters.h"
#include "editor/panels/ray_scope.h"
#include "editor/panels/status.h"
#include "editor/panels/viewport.h"

namespace pileus::editor {
namespace {

struct Rect {
  ImVec2 min, max;
};

struct Areas {
  Rect viewport, graph, scope, parameters, lab, log, status;
};

constexpr float kGap = 4;  // design pixels between panels: the splitter

Areas areasOf(const Editor& editor, float top) {
  const Theme& theme = editor.theme;
  const Settings& s = editor.settings;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float gap = theme.px(kGap), status = theme.px(26);
  const float bottom = display.y - status;
  const float log =
      s.showLog ? std::min(theme.px(static_cast<float>(s.logHeight)), (bottom - top) * 0.6f) + gap : 0;
  const float lab = s.showLab ? std::min(theme.px(static_cast<float>(s.labHeight)), (bottom - top - log) * 0.6f) + gap : 0;
  const float main = bottom - log - lab;
  const float right = std::clamp(theme.px(static_cast<float>(s.parametersWidth)), theme.px(240),
                                 std::max(theme.px(240), display.x - theme.px(360)));
  const float parameters = display.x - right - gap;
  // The scope leaves the viewport room.
  const float scope = s.showScope ? std::clamp(theme.px(static_cast<float>(s.scopeWidth)), theme.px(280), std::max(theme.px(280), parameters - theme.px(360))) + gap : 0;
  const float x = parameters - scope;
  const float y = std::round(top + (main - top - gap) * static_cast<float>(s.viewportShare));
  return {{{0, top}, {x, y}},
          {{0, y + gap}, {x, main}},
          {{x + gap, top}, {parameters, main}},
          {{parameters + gap, top}, {display.x, main}},
          {{0, main + gap}, {display.x, main + lab}},
          {{0, main + lab + gap}, {display.x, bottom}},
          {{0, bottom}, display}};
}

constexpr ImGuiWindowFlags kFixed =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav;

/// A fixed window without padding for one panel; returns whether the pointer is over it and nothing covers
/// it.
bool beginPanel(const char* id, const Rect& r) {
  ImGui::SetNextWindowPos(r.min);
  ImGui::SetNextWindowSize({std::max(r.max.x - r.min.x, 1.0f), std::max(r.max.y - r.min.y, 1.0f)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(id, nullptr, kFixed);
  ImGui::PopStyleVar(2);
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                                ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

/// A strip between panels that can be dragged; returns the pixels moved.
float splitter(Editor& editor, const char* id, Rect r, bool vertical, bool& released) {
  const float grow = editor.theme.px(2);
  if (vertical)
    r.min.x -= grow, r.max.x += grow;
  else
    r.min.y -= grow, r.max.y += grow;
  ImGui::SetNextWindowPos(r.min);
  ImGui::SetNextWindowSize({r.max.x - r.min.x, r.max.y - r.min.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(id, nullptr,
               (kFixed | ImGuiWindowFlags_NoBackground) & ~ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar(2);
  ImGui::InvisibleButton("grip", {r.max.x - r.min.x, r.max.y - r.min.y});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (active || hovered) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled(r.min, r.max, active ? palette::kAccent : palette::kAccentDim);
  }
  released |= ImGui::IsItemDeactivated();
  editor.trace.item(id);
  ImGui::End();
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  return !active ? 0 : vertical ? moved.x : moved.y;
}

void drawSplitters(Editor& editor, const Areas& a) {
  Settings& s = editor.settings;
  const double scale = static_cast<double>(editor.theme.scale);
  bool released = false;
  const float dx =
      splitter(editor, "splitter/parameters",
               {{a.parameters.min.x - editor.theme.px(kGap), a.viewport.min.y}, {a.parameters.min.x, a.graph.max.y}}, true, released);
  s.parametersWidth = std::clamp(s.parametersWidth - static_cast<double>(dx) / scale, 240.0, 900.0);
  if (s.showScope) {
    const float ds = splitter(editor, "splitter/scope", {{a.viewport.max.x, a.viewport.min.y}, {a.scope.min.x, a.graph.max.y}}, true, released);
    s.scopeWidth = std::clamp(s.scopeWidth - static_cast<double>(ds) / scale, 280.0, 1200.0);
  }
  const float dy =
      splitter(editor, "splitter/graph",
               {{a.viewport.min.x, a.viewport.max.y}, {a.viewport.max.x, a.graph.min.y}}, false, released);
  const double height = static_cast<double>(std::max(a.graph.max.y - a.viewport.min.y, 1.0f));
  s.viewportShare = std::clamp(s.viewportShare + static_cast<double>(dy) / height, 0.15, 0.85);
  if (s.showLab) {
    const float dl = splitter(editor, "splitter/lab", {{0, a.graph.max.y}, {a.lab.max.x, a.lab.min.y}}, false, released);
    s.labHeight = std::clamp(s.labHeight - static_cast<double>(dl) / scale, 160.0, 1000.0);
  }
  if (s.showLog) {
    const float dl = splitter(editor, "splitter/log", {{0, a.log.min.y - editor.theme.px(kGap)}, {a.log.max.x, a.log.min.y}},
                              false, released);
    s.logHeight = std::clamp(s.logHeight - static_cast<double>(dl) / scale, 60.0, 800.0);
  }
}

}  // namespace

void drawPanels(Editor& editor) {
  const float top = drawMenuBar(editor);
  const Areas a = areasOf(editor, top);
  Panel hovered = Panel::Global;
  const auto over = [&](bool is, Panel panel) {
    if (is) hovered = panel;
    return is;
  };

  over(beginPanel("##viewport", a.viewport), Panel::Viewport);
  drawViewport(editor, a.viewport.min, a.viewport.max, ImGui::IsWindowHovered());
  ImGui::End();

  over(beginPanel("##graph", a.graph), Panel::Graph);
  drawCanvas(editor, a.graph.min, a.graph.max, ImGui::IsWindowHovered());
  drawCanvasMenu(editor);
  drawSearch(editor);
  ImGui::End();

  if (editor.settings.showScope) {
    over(beginPanel("##scope", a.scope), Panel::Scope);
    drawRayScope(editor, a.scope.min, a.scope.max);
    ImGui::End();
  }

  over(beginPanel("##parameters", a.parameters), Panel::Parameters);
  drawParameters(editor, a.parameters.min, a.parameters.max);
  ImGui::End();

  if (editor.settings.showLab) {
    over(beginPanel("##lab", a.lab), Panel::Lab);
    drawLab(editor, a.lab.min, a.lab.max);
    ImGui::End();
  }

  if (editor.settings.showLog) {
    over(beginPanel("##log", a.log), Panel::Log);
    drawLog(editor, a.log.min, a.log.max);
    ImGui::End();
  }
  beginPanel("##status", a.status);
  drawStatusLine(editor, a.status.min, a.status.max);
  ImGui::End();
  drawSplitters(editor, a);
  editor.hovered = hovered;
}

}  // namespace pileus::editor
