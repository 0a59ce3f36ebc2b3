#include "editor/graph_view/canvas.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "editor/app/editor.h"
#include "editor/commands/actions.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/canvas_draw.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/drag_feedback.h"
#include "editor/graph_view/draw_frame.h"
#include "editor/graph_view/layout/hit_test.h"
#include "editor/graph_view/link_gestures.h"
#include "editor/graph_view/scopes.h"

namespace pileus::editor {
namespace {

/// Centre and the largest level that shows `names` (all when empty).
void frame(Editor& editor, const Layout& layout, const std::set<std::string>& names) {
  Canvas& canvas = editor.canvas;
  vec2 lo, hi;
  canvas.level = editor.theme.defaultZoom;
  if (!bounds(layout, names, lo, hi)) {
    canvas.center = dvec2(0);
    return;
  }
  canvas.center = dvec2(0.5f * (lo + hi));
  const vec2 room = canvas.max - canvas.min - vec2(editor.theme.px(64), editor.theme.px(56));
  while (canvas.level > 0) {
    const float zoom = editor.theme.zoomLevels[static_cast<std::size_t>(canvas.level)].zoom;
    if ((hi.x - lo.x) * zoom <= room.x && (hi.y - lo.y) * zoom <= room.y) break;
    --canvas.level;
  }
}

PointerInput pointerInput(const Editor& editor, bool hovered, Hit hit) {
  const ImGuiIO& io = ImGui::GetIO();
  PointerInput in;
  in.pos = ImGui::IsMousePosValid() ? vec(io.MousePos) : editor.canvas.interaction.last;
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
  if (editor.canvas.interaction.busy() && !ImGui::IsAnyMouseDown() && !in.released[0] && !in.released[1] &&
      !in.released[2])
    in.cancel = true;
  in.wheel = hovered ? io.MouseWheel : 0;
  in.over = hovered;
  in.hit = std::move(hit);
  return in;
}

}  // namespace

CanvasView canvasView(const Editor& editor, ImDrawList* draw) {
  const Canvas& canvas = editor.canvas;
  CanvasView view;
  view.min = canvas.min;
  view.max = canvas.max;
  view.level = editor.theme.zoomLevels[static_cast<std::size_t>(canvas.level)];
  view.draw = draw;
  view.origin = glm::round(0.5f * (canvas.min + canvas.max) - vec2(canvas.center) * view.level.zoom);
  return view;
}

std::string socketKey(std::string_view node, std::string_view socket, bool input) {
  return std::string(node) + (input ? "/in/" : "/out/") + std::string(socket);
}

void drawCanvas(Editor& editor, ImVec2 min, ImVec2 max, bool hovered) {
  Canvas& canvas = editor.canvas;
  followScope(editor);
  canvas.min = vec(min);
  canvas.max = vec(max);
  if (canvas.selectedFrame && *canvas.selectedFrame >= editor.document.graph().frames.size())
    canvas.selectedFrame.reset();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(min, max, true);
  draw->AddRectFilled(min, max, palette::kCanvas);

  std::shared_ptr<const Layout> layout = shownLayout(editor);
  if (canvas.level < 0 || canvas.frameAll)
    frame(editor, *layout, {});
  else if (canvas.frameSelection)
    frame(editor, *layout, editor.document.selection());
  canvas.frameAll = canvas.frameSelection = false;

  CanvasView view = canvasView(editor, draw);
  if (updateOverlays(editor, view, *layout, hovered)) hovered = false;
  const bool active = hovered || canvas.interaction.busy();
  const vec2 pointer = view.canvas(vec(ImGui::GetIO().MousePos));
  Hit hit = active ? hitTest(*layout, shownGraph(editor), pointer, view.level.zoom / editor.theme.scale,
                             canvas.interaction)
                   : Hit{};
  if (canvas.interaction.state == Interaction::State::DraggingLink) hit = snappedToNode(editor, *layout, hit);
  canvas.pointer = pointer;
  canvas.pointerInside = hovered;
  const PointerInput in = pointerInput(editor, hovered, hit);
  const bool selected = editor.document.selection().contains(hit.node);
  for (const Command& c : step(canvas.interaction, in, selected, ImGui::GetIO().MouseDragThreshold))
    carryOut(editor, view, *layout, c);
  layout = shownLayout(editor);
  findDropLink(editor, *layout);
  view = canvasView(editor, draw);

  drawGrid(editor.theme, view);
  drawFrames(editor, view);
  drawLinks(editor, view, *layout, hit);
  drawNodes(editor, view, *layout, hit);
  drawDistantTitles(editor, view);
  drawDragFeedback(editor, view, *layout, hit);
  drawHints(editor, view);
  drawOverlays(editor, view, *layout);
  draw->PopClipRect();
  drawCanvasTooltip(editor, *layout, hit, hovered);
  editor.trace.rect("canvas", min, max);
}

}  // namespace pileus::editor
