// The pointer over the picture: who takes it, and moves of the camera.
#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/camera_control.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/corner_widgets.h"
#include "editor/viewport/handles/gizmo_tool.h"
#include "editor/viewport/handles/shadow_place.h"
#include "editor/viewport/handles/turn_light.h"
#include "editor/viewport/overlays.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {
namespace {

constexpr int kSpace = 32;  // GLFW's code
constexpr const char* kDragKey = "camera drag";

/// The selection if it is in view, else what is seen under the pointer, else what the camera looks at.
dvec3 orbitPivot(const Session& session, const Shown& shown, const Projection& view,
                 const scene::Camera& camera, vec2 at) {
  if (!shown.look.light.empty()) return camera.target;
  if (const Box3 box = selectionBounds(session, shown.scene); !box.empty())
    if (const auto seen = view.screen(box.center()); seen && view.contains(*seen)) return box.center();
  const auto& picture = shown.preview.picture();
  if (picture && picture->scene && view.contains(at))
    if (const auto point =
            view::visiblePoint(*picture->scene, dvec2((at - view.min()) / (view.max() - view.min()))))
      return *point;
  return camera.target;
}

/// On the plane through the target, under the pointer.
dvec3 dollyPoint(const Projection& view, const scene::Camera& camera, vec2 at) {
  const Ray ray = view.ray(at);
  const double slope = glm::dot(ray.direction, view.forward());
  return ray.origin + ray.direction * (glm::length(camera.target - camera.eye) / std::max(slope, 1e-3));
}

void continueMove(const ViewportRoom& room, const Projection& view) {
  Viewport& viewport = room.viewport;
  ViewportTools& tools = viewport.tools;
  const ImGuiIO& io = ImGui::GetIO();
  using Drag = Viewport::Drag;
  const vec2 at = vec(io.MousePos);
  if (tools.maybeClick && glm::length(at - tools.pressedAt) >= room.ui.theme.px(4)) tools.maybeClick = false;
  const double fine = io.KeyShift && !tools.usesShift ? 0.2 : 1;
  const dvec2 moved = fine * dvec2(vec(io.MouseDelta)) / static_cast<double>(view.max().y - view.min().y);
  if (moved != dvec2(0) && !tools.maybeClick) {
    const scene::Camera camera = currentCamera(room.session, room.clock, room.shown);
    if (viewport.drag == Drag::Turn) {
      // What is seen behind goes with the pointer: to the right is a smaller azimuth.
      continueTurn(room, (view.up().y < 0 ? 180 : -180) * moved.x, io.KeyCtrl);
    } else if (viewport.drag == Drag::Orbit) {
      if (!tools.turning) tools.pivot = orbitPivot(room.session, room.shown, view, camera, tools.pressedAt);
      tools.turning = true;
      setCamera(room.ui.messages, room.session, room.clock, room.shown,
                orbitedAbout(camera, tools.pivot, moved * kPi), "Orbit camera", kDragKey);
    } else if (viewport.drag == Drag::Pan) {
      setCamera(room.ui.messages, room.session, room.clock, room.shown, panned(camera, moved), "Pan camera",
                kDragKey);
    } else {
      setCamera(room.ui.messages, room.session, room.clock, room.shown,
                dollied(camera, std::exp(2.5 * (moved.y - moved.x))), "Dolly camera", kDragKey);
    }
  }
  if (ImGui::IsAnyMouseDown()) return;
  if (tools.maybeClick && view.contains(at)) {
    if (room.shown.ray.picking)
      pickRay(room.ui.messages, room.shown, room.settings,
              dvec2((at - view.min()) / (view.max() - view.min())));
    else {
      const std::string path = nodeAt(room.ui.theme, room.session, room.shown, room.settings, view, at);
      const std::string name = shownInScope(room.session, path);
      tools.inside = path;
      std::set<std::string> chosen =
          io.KeyShift ? room.session.document.selection() : std::set<std::string>{};
      if (!name.empty() && !chosen.insert(name).second) chosen.erase(name);
      room.session.document.select(std::move(chosen));
      room.session.selectedLink.reset();
    }
  }
  viewport.drag = Drag::None;
  tools.maybeClick = false;
  endTurn(room.session, viewport);
}

/// A button goes down over the picture.
void press(const ViewportRoom& room, const Projection& view, int button) {
  Viewport& viewport = room.viewport;
  ViewportTools& tools = viewport.tools;
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 at = vec(io.MousePos);
  const NavigationChoice choice = navigationMove(
      room.settings.view.navigation, {button, io.KeyShift, io.KeyCtrl, io.KeyAlt, io.KeysDown[kSpace]});
  if (button == 0 && choice.plain) {
    if (clickShadowPlace(room.ui, room.session, room.shown, room.viewport, view, at)) return;
    if (room.settings.view.overlays.on && beginGizmoDrag(room, view)) return;
  }
  using Drag = Viewport::Drag;
  viewport.drag = choice.move == CameraMove::Orbit   ? Drag::Orbit
                  : choice.move == CameraMove::Pan   ? Drag::Pan
                  : choice.move == CameraMove::Dolly ? Drag::Dolly
                                                     : Drag::None;
  // Handles go before it, the camera after it.
  if (button == 0 && choice.plain && room.shown.look.light.empty() && beginTurn(room))
    viewport.drag = Drag::Turn;
  tools.maybeClick = button == 0 && choice.plain;
  tools.usesShift = choice.usesShift;
  tools.turning = false;
  tools.pressedAt = at;
}

/// The part of the screen with a picture that the pointer is over.
Projection viewUnder(const Shown& shown, const scene::Camera& camera, vec2 min, vec2 max) {
  for (const ScreenRect& r : shown.places) {
    const Projection view(camera, r.min, r.max);
    if (view.contains(vec(ImGui::GetIO().MousePos))) return view;
  }
  return shown.places.empty() ? Projection(camera, min, max)
                              : Projection(camera, shown.places[0].min, shown.places[0].max);
}

bool hasPicture(const Shown& shown) { return shown.displayed.texture != 0 && shown.preview.error().empty(); }

}  // namespace

void drawViewportTools(const ViewportRoom& room, bool hovered) {
  ViewportTools& tools = room.viewport.tools;
  tools.overWidget = false;
  followScene(room.session, room.clock, room.shown);
  if (!room.shown.look.light.empty() && !lightViewCamera(room.session, room.clock, room.shown))
    room.shown.look = {};
  if (!hasPicture(room.shown)) return;
  const scene::Camera camera = currentCamera(room.session, room.clock, room.shown);
  if (room.settings.view.overlays.on) {
    for (const ScreenRect& r : room.shown.places) {
      const Projection view(camera, r.min, r.max);
      ImGui::PushClipRect(im(r.min), im(r.max), true);
      drawSceneOverlays(room, view);
      drawGizmo(room, view);
      ImGui::PopClipRect();
    }
  }
  drawTurn(room);
  const auto [lo, hi] = shownCorners(room.shown);
  if (room.settings.view.overlays.on) drawAxisCross(room, Projection(camera, lo, hi), hovered);
  drawToolStrip(room.ui, room.settings, room.viewport, lo, hi, hovered);
  drawToolHints(room, lo, hi, hovered);
}

void routeViewportPointer(const ViewportRoom& room, vec2 min, vec2 max, bool hovered) {
  Viewport& viewport = room.viewport;
  ViewportTools& tools = viewport.tools;
  const ImGuiIO& io = ImGui::GetIO();
  const Projection view =
      viewUnder(room.shown, currentCamera(room.session, room.clock, room.shown), min, max);
  tools.over.reset();
  if (tools.drag) {
    // Halves of a comparison: a drag goes on where it began.
    continueGizmoDrag(room, view);
  } else if (viewport.drag != Viewport::Drag::None) {
    continueMove(room, view);
  } else if (hovered && !tools.overWidget) {
    if (room.settings.view.overlays.on && !io.KeyAlt && hasPicture(room.shown))
      if (const auto frame = currentGizmo(room, view))
        tools.over =
            gizmoAt(gizmoShapes(*frame, view, room.ui.theme.px(1)), vec(io.MousePos), room.ui.theme.px(7));
    if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) followShadowPlace(room, view, vec(io.MousePos));
    if (!tools.over && !io.KeyAlt && room.shown.look.light.empty() && hasPicture(room.shown))
      hintAtTurn(room);
    for (const int button : {0, 2, 1})
      if (ImGui::IsMouseClicked(button)) {
        press(room, view, button);
        break;
      }
    if (io.MouseWheel != 0 && viewport.drag == Viewport::Drag::None) {
      const double fine = io.KeyShift ? 0.2 : 1;
      const scene::Camera camera = currentCamera(room.session, room.clock, room.shown);
      setCamera(room.ui.messages, room.session, room.clock, room.shown,
                dolliedTo(camera, dollyPoint(view, camera, vec(io.MousePos)),
                          std::pow(0.88, fine * static_cast<double>(io.MouseWheel))),
                "Dolly camera", "camera wheel");
      viewport.wheelEdit = true;
      viewport.wheelAt = ImGui::GetTime();
    }
  }
  if (viewport.wheelEdit && ImGui::GetTime() - viewport.wheelAt > 0.5) {
    viewport.wheelEdit = false;
    room.session.document.endMerge();
  }
}

bool viewportHoldsKeys(const Viewport& viewport) {
  return viewport.tools.drag.has_value() || viewport.tools.turn.has_value();
}

bool escapeViewport(Session& session, Shown& shown, Viewport& viewport) {
  ViewportTools& tools = viewport.tools;
  if (tools.drag) return cancelGizmoDrag(session, viewport), true;
  if (tools.turn) return cancelTurn(session, viewport), true;
  if (tools.place.stage != ShadowPlace::Stage::Off) return cancelShadowPlace(session, viewport), true;
  if (!shown.look.light.empty()) return leaveLightView(session, shown), true;
  return false;
}

void setGizmoMode(Viewport& viewport, GizmoMode mode) { viewport.tools.mode = mode; }

void frameSelected(Ui& ui, Session& session, Clock& clock, Shown& shown) {
  followScene(session, clock, shown);
  const Box3 box = selectionBounds(session, shown.scene);
  if (box.empty()) return frameVolumes(ui.messages, session, clock, shown);
  const ivec2 size = session.document.root().settings.size;
  setCamera(
      ui.messages, session, clock, shown,
      scene::frameBounds(box, double(size.x) / std::max(size.y, 1), currentCamera(session, clock, shown)),
      "Frame selection", {});
}

}  // namespace pileus::editor
