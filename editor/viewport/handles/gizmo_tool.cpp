#include "editor/viewport/handles/gizmo_tool.h"

#include <fmt/core.h>

#include <array>
#include <cfloat>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

using Tip = GizmoShape::Tip;
constexpr const char* kMergeKey = "gizmo drag";

ImU32 inkOf(GizmoShape::Ink ink) {
  switch (ink) {
    case GizmoShape::Ink::X:
      return palette::kAxisX;
    case GizmoShape::Ink::Y:
      return palette::kAxisY;
    case GizmoShape::Ink::Z:
      return palette::kAxisZ;
    case GizmoShape::Ink::Light:
      return palette::kLightSocket;
    case GizmoShape::Ink::Neutral:
      break;
  }
  return palette::kHandle;
}

void drawTip(const Theme& theme, ImDrawList* draw, const GizmoShape& s, ImU32 color) {
  const vec2 at = s.line.back();
  const float r = theme.px(4.5f);
  if (s.tip == Tip::Box) {
    draw->AddRectFilled(im(at - r - 1.0f), im(at + r + 1.0f), palette::kHandleEdge, theme.px(1));
    draw->AddRectFilled(im(at - r), im(at + r), color, theme.px(1));
  } else if (s.tip == Tip::Dot) {
    draw->AddCircleFilled(im(at), r + 1, palette::kHandleEdge);
    draw->AddCircleFilled(im(at), r, color);
  } else if (s.tip == Tip::Sun) {
    draw->AddCircleFilled(im(at), 2 * r + 1.5f, palette::kHandleEdge);
    draw->AddCircleFilled(im(at), 2 * r, color);
    const float width = textWidth(theme.small, icon::kSun);
    drawText(draw, theme.small, {at.x - 0.5f * width, at.y - 0.5f * theme.small->FontSize},
             palette::kHandleEdge, icon::kSun, width + 4);
  } else if (s.tip == Tip::Arrow && s.line.size() > 1) {
    const vec2 d = at - s.line[s.line.size() - 2];
    if (glm::length(d) < 0.5f) return;
    const vec2 u = glm::normalize(d), n(-u.y, u.x);
    const float w = theme.px(5), length = theme.px(13);
    draw->AddTriangleFilled(im(at + u * 1.5f), im(at - u * length - n * (w + 1)),
                            im(at - u * length + n * (w + 1)), palette::kHandleEdge);
    draw->AddTriangleFilled(im(at), im(at - u * (length - 1) - n * w), im(at - u * (length - 1) + n * w),
                            color);
  }
}

void drawShape(const Theme& theme, const GizmoShape& s, bool lit) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 ink = lit ? palette::kSelect : faded(inkOf(s.ink), s.faint ? 0.5f : 1.0f);
  static_assert(sizeof(vec2) == sizeof(ImVec2));
  const auto* points = reinterpret_cast<const ImVec2*>(s.line.data());
  const auto count = static_cast<int>(s.line.size());
  if (s.filled) {
    draw->AddConvexPolyFilled(points, count, faded(ink, lit ? 0.6f : 0.3f));
    draw->AddPolyline(points, count, faded(ink, 0.9f), ImDrawFlags_Closed, theme.scale);
    return;
  }
  if (count > 2 || (count == 2 && s.line[0] != s.line[1])) {
    const ImDrawFlags flags = s.closed ? ImDrawFlags_Closed : ImDrawFlags_None;
    if (!s.faint) draw->AddPolyline(points, count, palette::kHandleEdge, flags, 4.5f * theme.scale);
    draw->AddPolyline(points, count, ink, flags, (s.faint ? 1.5f : 2.5f) * theme.scale);
  }
  drawTip(theme, draw, s, ink);
}

const char* partName(GizmoHandle::Part part) {
  static constexpr std::array kNames = {"axis",       "plane",       "free",         "ring", "view_ring",
                                        "scale_axis", "scale_plane", "scale_all",    "aim",  "cone",
                                        "sun_disc",   "sun_azimuth", "sun_elevation"};
  return kNames[static_cast<std::size_t>(part)];
}

void traceShapes(Ui& ui, const std::vector<GizmoShape>& shapes) {
  if (!ui.trace.on()) return;
  for (const GizmoShape& s : shapes) {
    if (!s.handle) continue;
    // A place that is on the handle: its tip, the middle of an area or line.
    const vec2 at = s.tip != Tip::None ? s.line.back()
                    : s.filled         ? 0.5f * (s.line[0] + s.line[2])
                                       : s.line[s.line.size() / 2];
    ui.trace.rect(fmt::format("gizmo/{}/{}", partName(s.handle->part), s.handle->axis), im(at - 1.0f),
                  im(at + 1.0f));
  }
}

}  // namespace

std::optional<GizmoFrame> currentGizmo(const ViewportRoom& room, const Projection& view) {
  const ViewportTools& tools = room.viewport.tools;
  const std::string name = handledNode(room.session, tools.inside, room.clock.frame);
  if (name.empty() || name == room.shown.look.light) return std::nullopt;
  const nodes::Graph& graph = room.session.document.root();
  std::optional<GizmoTarget> target = gizmoTarget(graph, name, pivotOf(room.shown, name), room.clock.frame);
  if (!target) return std::nullopt;
  // The camera that is looked through has no place to take hold of.
  if (name == linkedCamera(room.session, shownView(room.session, room.shown)) &&
      !aroundCamera(room.session, room.shown))
    target->moves = false;
  return gizmoFrame(*target, tools.mode, room.settings.view.localAxes, view, room.ui.theme.px(96),
                    sunCenter(room.shown.scene, view));
}

void drawReadout(const Theme& theme, vec2 at, const std::string& text) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const vec2 pad(theme.space(2), theme.px(4)), size(textWidth(theme.mono, text), theme.mono->FontSize);
  const vec2 lo = glm::round(at + vec2(theme.px(18), theme.px(14)));
  draw->AddRectFilled(im(lo), im(lo + size + 2.0f * pad), palette::kChip, theme.px(4));
  drawText(draw, theme.mono, lo + pad, palette::kText, text, size.x + 2);
}

void drawGizmo(const ViewportRoom& room, const Projection& view) {
  const ViewportTools& tools = room.viewport.tools;
  const auto frame = currentGizmo(room, view);
  if (!frame) return;
  const auto shapes = gizmoShapes(*frame, view, room.ui.theme.px(1));
  for (const GizmoShape& s : shapes) {
    const bool held = tools.drag && s.handle == tools.drag->handle,
               hovered = !tools.drag && s.handle && s.handle == tools.over;
    drawShape(room.ui.theme, s, held || hovered);
  }
  traceShapes(room.ui, shapes);
  if (tools.drag && !tools.readout.empty()) {
    drawReadout(room.ui.theme, vec(ImGui::GetIO().MousePos), tools.readout);
    room.ui.trace.note("gizmo readout", tools.readout);
  }
}

bool beginGizmoDrag(const ViewportRoom& room, const Projection& view) {
  ViewportTools& tools = room.viewport.tools;
  const auto frame = currentGizmo(room, view);
  if (!frame) return false;
  const vec2 at = vec(ImGui::GetIO().MousePos);
  const auto handle = gizmoAt(gizmoShapes(*frame, view, room.ui.theme.px(1)), at, room.ui.theme.px(7));
  if (!handle) return false;
  holdFrame(room.clock, *nodes::findNodeAt(room.session.document.root(), frame->target.node));
  room.session.document.endMerge();
  tools.drag = GizmoDrag{*handle, *frame, view.ray(at)};
  tools.before = room.session.document.root();
  tools.pointer = at;
  tools.readout.clear();
  return true;
}

void continueGizmoDrag(const ViewportRoom& room, const Projection& view) {
  ViewportTools& tools = room.viewport.tools;
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 by = vec(io.MouseDelta) * (io.KeyShift ? 0.1f : 1.0f);
  tools.pointer += by;
  if (by != vec2(0) || tools.readout.empty()) {
    const GizmoFrame& start = tools.drag->start;
    const dvec3 place = tools.drag->handle.part == GizmoHandle::Part::Aim ? start.target.aim : start.center;
    const double metres = std::max(view.metresPerPixel(place), 1e-9);
    const auto dragged = dragGizmo(*tools.drag, view.ray(tools.pointer), io.KeyCtrl,
                                   roundStep(metres * static_cast<double>(room.ui.theme.px(10))));
    if (dragged && glm::length(tools.pointer - vec(io.MouseClickedPos[0])) > 0.5f) {
      tools.readout = dragged->readout;
      // A tenth of a pixel is six digits of that many.
      Result<nodes::Graph> graph =
          withTarget(tools.before, start.target, dragged->target, metres * 1e4, room.clock.frame);
      const bool turns = dragged->target.rotate != start.target.rotate,
                 grows = dragged->target.scale != start.target.scale;
      const char* verb = start.target.sun || turns ? "Turn " : grows ? "Scale " : "Move ";
      tryEditRoot(room.session, room.ui.messages, std::move(graph), verb + start.target.node, kMergeKey);
      room.shown.preview.touch();
    }
  }
  if (!ImGui::IsMouseDown(0)) {
    tools.drag.reset();
    room.session.document.endMerge();
  }
}

void cancelGizmoDrag(Session& session, Viewport& viewport) {
  ViewportTools& tools = viewport.tools;
  if (!tools.drag) return;
  tools.drag.reset();
  // Back where it began: the step vanishes with it.
  session.document.editRoot(tools.before, "", kMergeKey);
  session.document.endMerge();
}

}  // namespace pileus::editor
