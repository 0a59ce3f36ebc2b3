#include "editor/graph_view/canvas.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/canvas_draw.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/drag_feedback.h"
#include "editor/graph_view/draw_frame.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/layout/hit_test.h"
#include "editor/graph_view/link_gestures.h"
#include "editor/graph_view/scopes.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

/// Centre and the largest level that shows `names` (all when empty).
void frame(const Theme& theme, Canvas& canvas, const Layout& layout, const std::set<std::string>& names) {
  vec2 lo, hi;
  canvas.level = theme.defaultZoom;
  if (!bounds(layout, names, lo, hi)) {
    canvas.center = dvec2(0);
    return;
  }
  canvas.center = dvec2(0.5f * (lo + hi));
  const vec2 room = canvas.max - canvas.min - vec2(theme.px(64), theme.px(56));
  while (canvas.level > 0) {
    const float zoom = theme.zoomLevels[static_cast<std::size_t>(canvas.level)].zoom;
    if ((hi.x - lo.x) * zoom <= room.x && (hi.y - lo.y) * zoom <= room.y) break;
    --canvas.level;
  }
}

PointerInput pointerInput(const Canvas& canvas, bool hovered, Hit hit) {
  const ImGuiIO& io = ImGui::GetIO();
  PointerInput in;
  in.pos = ImGui::IsMousePosValid() ? vec(io.MousePos) : canvas.interaction.last;
  for (int i = 0; i < 3; ++i) {
    in.pressed[i] = ImGui::IsMouseClicked(i);
    in.released[i] = ImGui::IsMouseReleased(i);
  }
  in.doubleClick = ImGui::IsMouseDoubleClicked(0);
  in.shift = io.KeyShift;
  in.ctrl = io.KeyCtrl;
  in.alt = io.KeyAlt;
  in.knife = io.KeysDown[GLFW_KEY_Y];
  in.cancel = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  // The window lost the pointer without telling.
  if (canvas.interaction.busy() && !ImGui::IsAnyMouseDown() && !in.released[0] && !in.released[1] &&
      !in.released[2])
    in.cancel = true;
  in.wheel = hovered ? io.MouseWheel : 0;
  in.over = hovered;
  in.hit = std::move(hit);
  return in;
}

}  // namespace

CanvasView canvasView(const Theme& theme, const Canvas& canvas, ImDrawList* draw) {
  CanvasView view;
  view.min = canvas.min;
  view.max = canvas.max;
  view.level = theme.zoomLevels[static_cast<std::size_t>(canvas.level)];
  view.draw = draw;
  view.origin = glm::round(0.5f * (canvas.min + canvas.max) - vec2(canvas.center) * view.level.zoom);
  return view;
}

std::string socketKey(std::string_view node, std::string_view socket, bool input) {
  return std::string(node) + (input ? "/in/" : "/out/") + std::string(socket);
}

void drawCanvas(const GraphRoom& room, ImVec2 min, ImVec2 max, bool hovered) {
  Canvas& canvas = room.canvas;
  followScope(room.session, room.canvas);
  canvas.min = vec(min);
  canvas.max = vec(max);
  if (canvas.selectedFrame && *canvas.selectedFrame >= room.session.document.graph().frames.size())
    canvas.selectedFrame.reset();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(min, max, true);
  draw->AddRectFilled(min, max, palette::kCanvas);

  std::shared_ptr<const Layout> layout = shownLayout(room.session, room.clock, room.settings, room.canvas);
  if (canvas.level < 0 || canvas.frameAll)
    frame(room.ui.theme, room.canvas, *layout, {});
  else if (canvas.frameSelection)
    frame(room.ui.theme, room.canvas, *layout, room.session.document.selection());
  canvas.frameAll = canvas.frameSelection = false;

  CanvasView view = canvasView(room.ui.theme, room.canvas, draw);
  if (updateOverlays(room, view, *layout, hovered)) hovered = false;
  const bool active = hovered || canvas.interaction.busy();
  const vec2 pointer = view.canvas(vec(ImGui::GetIO().MousePos));
  Hit hit = active ? hitTest(*layout, shownGraph(room.session, room.canvas), pointer,
                             view.level.zoom / room.ui.theme.scale, canvas.interaction)
                   : Hit{};
  if (canvas.interaction.state == Interaction::State::DraggingLink)
    hit = snappedToNode(room.session, room.canvas, *layout, hit);
  canvas.pointer = pointer;
  canvas.pointerInside = hovered;
  const PointerInput in = pointerInput(room.canvas, hovered, hit);
  const bool selected = room.session.document.selection().contains(hit.node);
  for (const Command& c : step(canvas.interaction, in, selected, ImGui::GetIO().MouseDragThreshold))
    carryOut(room, view, *layout, c);
  layout = shownLayout(room.session, room.clock, room.settings, room.canvas);
  findDropLink(room.session, room.canvas, *layout);
  view = canvasView(room.ui.theme, room.canvas, draw);

  drawGrid(room.ui.theme, view);
  drawFrames(room.ui, room.session, room.canvas, view);
  drawLinks(room.ui.theme, room.session, room.canvas, view, *layout, hit);
  drawNodes(room, view, *layout, hit);
  canvas.pictures.prune(shownGraph(room.session, room.canvas));
  if (room.ui.trace.on()) room.ui.trace.note("thumbnails", std::to_string(canvas.pictures.count()));
  drawDistantTitles(room.ui.theme, room.session, room.canvas, view);
  drawDragFeedback(room.ui, room.session, room.canvas, view, *layout, hit);
  drawHints(room.ui.theme, room.session, room.canvas, view);
  drawOverlays(room.ui, room.session, room.settings, room.canvas, view, *layout);
  draw->PopClipRect();
  drawCanvasTooltip(room.ui, room.session, room.shown, room.canvas, *layout, hit, hovered);
  room.ui.trace.rect("canvas", min, max);
}

}  // namespace pileus::editor
