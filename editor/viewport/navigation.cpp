// The pointer over the picture: who takes it, and moves of the camera.
#include <algorithm>
#include <cmath>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/picture/camera_control.h"
#include "editor/picture/shadow_place.h"
#include "editor/picture/shown_camera.h"
#include "editor/viewport/corner_widgets.h"
#include "editor/viewport/handles/gizmo_tool.h"
#include "editor/viewport/overlays.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {
namespace {

constexpr int kSpace = 32;  // GLFW's code
constexpr const char* kDragKey = "camera drag";

/// The selection if it is in view, else what is seen under the pointer, else what the camera looks at.
dvec3 orbitPivot(const Editor& editor, const Projection& view, const scene::Camera& camera, vec2 at) {
  if (!editor.viewport.tools.look.light.empty()) return camera.target;
  if (const Box3 box = selectionBounds(editor, editor.viewport.tools.scene); !box.empty())
    if (const auto seen = view.screen(box.center()); seen && view.contains(*seen)) return box.center();
  const auto& picture = editor.preview.picture();
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

void continueMove(Editor& editor, const Projection& view) {
  Viewport& viewport = editor.viewport;
  ViewportTools& tools = viewport.tools;
  const ImGuiIO& io = ImGui::GetIO();
  using Drag = Viewport::Drag;
  const vec2 at = vec(io.MousePos);
  if (tools.maybeClick && glm::length(at - tools.pressedAt) >= editor.theme.px(4)) tools.maybeClick = false;
  const double fine = io.KeyShift && !tools.usesShift ? 0.2 : 1;
  const dvec2 moved = fine * dvec2(vec(io.MouseDelta)) / static_cast<double>(view.max().y - view.min().y);
  if (moved != dvec2(0) && !tools.maybeClick) {
    const scene::Camera camera = currentCamera(editor);
    if (viewport.drag == Drag::Orbit) {
      if (!tools.turning) tools.pivot = orbitPivot(editor, view, camera, tools.pressedAt);
      tools.turning = true;
      setCamera(editor, orbitedAbout(camera, tools.pivot, moved * kPi), "Orbit camera", kDragKey);
    } else if (viewport.drag == Drag::Pan) {
      setCamera(editor, panned(camera, moved), "Pan camera", kDragKey);
    } else {
      setCamera(editor, dollied(camera, std::exp(2.5 * (moved.y - moved.x))), "Dolly camera", kDragKey);
    }
  }
  if (ImGui::IsAnyMouseDown()) return;
  if (tools.maybeClick && view.contains(at)) {
    if (editor.scope.picking)
      pickRay(editor, dvec2((at - view.min()) / (view.max() - view.min())));
    else if (editor.document.scope().empty()) {
      const std::string name = nodeAt(editor, view, at);
      std::set<std::string> chosen = io.KeyShift ? editor.document.selection() : std::set<std::string>{};
      if (!name.empty() && !chosen.insert(name).second) chosen.erase(name);
      editor.document.select(std::move(chosen));
      editor.canvas.selectedLink.reset();
    }
  }
  viewport.drag = Drag::None;
  tools.maybeClick = false;
  editor.document.endMerge();
}

/// A button goes down over the picture.
void press(Editor& editor, const Projection& view, int button) {
  Viewport& viewport = editor.viewport;
  ViewportTools& tools = viewport.tools;
  const ImGuiIO& io = ImGui::GetIO();
  const vec2 at = vec(io.MousePos);
  const NavigationChoice choice = navigationMove(
      editor.settings.view.navigation, {button, io.KeyShift, io.KeyCtrl, io.KeyAlt, io.KeysDown[kSpace]});
  if (button == 0 && choice.plain) {
    if (clickShadowPlace(editor, view, at)) return;
    if (editor.settings.view.overlays.on && beginGizmoDrag(editor, view)) return;
  }
  using Drag = Viewport::Drag;
  viewport.drag = choice.move == CameraMove::Orbit   ? Drag::Orbit
                  : choice.move == CameraMove::Pan   ? Drag::Pan
                  : choice.move == CameraMove::Dolly ? Drag::Dolly
                                                     : Drag::None;
  tools.maybeClick = button == 0 && choice.plain;
  tools.usesShift = choice.usesShift;
  tools.turning = false;
  tools.pressedAt = at;
}

/// The part of the screen with a picture that the pointer is over.
Projection viewUnder(const Editor& editor, const scene::Camera& camera, vec2 min, vec2 max) {
  for (const Viewport::Rect& r : editor.viewport.shown) {
    const Projection view(camera, r.min, r.max);
    if (view.contains(vec(ImGui::GetIO().MousePos))) return view;
  }
  return editor.viewport.shown.empty()
             ? Projection(camera, min, max)
             : Projection(camera, editor.viewport.shown[0].min, editor.viewport.shown[0].max);
}

bool hasPicture(const Editor& editor) {
  return editor.viewport.texture != 0 && editor.preview.error().empty();
}

}  // namespace

void drawViewportTools(Editor& editor, bool hovered) {
  ViewportTools& tools = editor.viewport.tools;
  tools.overWidget = false;
  // It changes with document and frame, and once more when their values have been worked out.
  const std::string shown = shownView(editor);
  if (!tools.sceneComplete || !editor.preview.complete() ||
      tools.sceneRevision != editor.document.revision() || tools.sceneView != shown ||
      tools.sceneFrame != editor.frame || tools.sceneAnswered != editor.preview.answered()) {
    tools.scene = viewScene(editor);
    tools.sceneComplete = editor.preview.complete();
    tools.sceneRevision = editor.document.revision();
    tools.sceneView = shown;
    tools.sceneFrame = editor.frame;
    tools.sceneAnswered = editor.preview.answered();
  }
  if (!tools.look.light.empty() && !lightViewCamera(editor)) tools.look = {};
  if (!hasPicture(editor)) return;
  const scene::Camera camera = currentCamera(editor);
  if (editor.settings.view.overlays.on) {
    for (const Viewport::Rect& r : editor.viewport.shown) {
      const Projection view(camera, r.min, r.max);
      ImGui::PushClipRect(im(r.min), im(r.max), true);
      drawSceneOverlays(editor, view);
      drawGizmo(editor, view);
      ImGui::PopClipRect();
    }
  }
  const auto [lo, hi] = shownCorners(editor.viewport);
  if (editor.settings.view.overlays.on) drawAxisCross(editor, Projection(camera, lo, hi), hovered);
  drawToolStrip(editor, lo, hi, hovered);
  drawToolHints(editor, lo, hi, hovered);
}

void routeViewportPointer(Editor& editor, vec2 min, vec2 max, bool hovered) {
  Viewport& viewport = editor.viewport;
  ViewportTools& tools = viewport.tools;
  const ImGuiIO& io = ImGui::GetIO();
  const Projection view = viewUnder(editor, currentCamera(editor), min, max);
  tools.over.reset();
  if (tools.drag) {
    // Halves of a comparison: a drag goes on where it began.
    continueGizmoDrag(editor, view);
  } else if (viewport.drag != Viewport::Drag::None) {
    continueMove(editor, view);
  } else if (hovered && !tools.overWidget) {
    if (editor.settings.view.overlays.on && !io.KeyAlt && hasPicture(editor))
      if (const auto frame = currentGizmo(editor, view))
        tools.over =
            gizmoAt(gizmoShapes(*frame, view, editor.theme.px(1)), vec(io.MousePos), editor.theme.px(7));
    if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) followShadowPlace(editor, view, vec(io.MousePos));
    for (const int button : {0, 2, 1})
      if (ImGui::IsMouseClicked(button)) {
        press(editor, view, button);
        break;
      }
    if (io.MouseWheel != 0 && viewport.drag == Viewport::Drag::None) {
      const double fine = io.KeyShift ? 0.2 : 1;
      const scene::Camera camera = currentCamera(editor);
      setCamera(editor,
                dolliedTo(camera, dollyPoint(view, camera, vec(io.MousePos)),
                          std::pow(0.88, fine * static_cast<double>(io.MouseWheel))),
                "Dolly camera", "camera wheel");
      viewport.wheelEdit = true;
      viewport.wheelAt = ImGui::GetTime();
    }
  }
  if (viewport.wheelEdit && ImGui::GetTime() - viewport.wheelAt > 0.5) {
    viewport.wheelEdit = false;
    editor.document.endMerge();
  }
}

bool viewportHoldsKeys(const Editor& editor) { return editor.viewport.tools.drag.has_value(); }

bool escapeViewport(Editor& editor) {
  ViewportTools& tools = editor.viewport.tools;
  if (tools.drag) return cancelGizmoDrag(editor), true;
  if (tools.place.stage != ShadowPlace::Stage::Off) return cancelShadowPlace(editor), true;
  if (!tools.look.light.empty()) return leaveLightView(editor), true;
  return false;
}

void setGizmoMode(Editor& editor, GizmoMode mode) { editor.viewport.tools.mode = mode; }

void frameSelected(Editor& editor) {
  const Box3 box = selectionBounds(editor, viewScene(editor));
  if (box.empty()) return frameVolumes(editor);
  const ivec2 size = editor.document.root().settings.size;
  setCamera(editor, scene::frameBounds(box, double(size.x) / std::max(size.y, 1), currentCamera(editor)),
            "Frame selection", {});
}

}  // namespace pileus::editor
