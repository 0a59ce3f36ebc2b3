#pragma once
// What the pointer does over the picture: gizmos, picking, moves of the camera, and the tools that wait for
// clicks.
#include <optional>
#include <string>

#include "editor/viewport/handles/gizmo.h"
#include "editor/viewport/view_scene.h"

namespace pileus::editor {

/// Puts a light by its shadow: a click on what casts, then the shadow follows the pointer.
struct ShadowPlace {
  enum class Stage { Off, Caster, Shadow } stage = Stage::Off;
  std::string light;
  dvec3 caster{0};
  nodes::Graph before;  ///< what Esc brings back
};

/// The viewport's camera is that of a light.
struct LightView {
  std::string light;  ///< "" = off
  dvec3 target{0};
  double distance = 1, fov = 8;
};

struct ViewportTools {
  GizmoMode mode = GizmoMode::Select;
  // A gizmo being dragged.
  std::optional<GizmoHandle> over;
  std::optional<GizmoDrag> drag;
  nodes::Graph before;
  vec2 pointer{0};  ///< moves slower than the real one with Shift
  std::string readout;
  // A camera move.
  bool maybeClick = false, usesShift = false, turning = false;
  vec2 pressedAt{0};
  dvec3 pivot{0};

  ShadowPlace place;
  LightView look;
  std::optional<scene::Camera> beforeAxis;  ///< what a right click on the axis cross goes back to
  ViewScene scene;                          ///< what is shown, and what it was made of:
  std::uint64_t sceneRevision = 0, sceneAnswered = 0;
  std::string sceneView;
  int sceneFrame = 0;
  bool sceneComplete = false;
  bool overWidget = false;
};

/// Overlays, gizmo and the little controls over the picture, wherever it is shown.
void drawViewportTools(Editor& editor, bool hovered);
/// After everything that could be over the picture has been drawn. `hovered`: the pointer is free for it.
void routeViewportPointer(Editor& editor, vec2 min, vec2 max, bool hovered);
/// Esc ends what is going on here; false: nothing was.
bool escapeViewport(Editor& editor);
/// Keys do nothing else while a handle is held.
bool viewportHoldsKeys(const Editor& editor);

// Actions.
void setGizmoMode(Editor& editor, GizmoMode mode);
void insertTransform(Editor& editor);
bool canInsertTransform(const Editor& editor);
void frameSelected(Editor& editor);

/// The node that a click at a pixel chooses; "" = nothing there.
std::string nodeAt(const Editor& editor, const Projection& view, vec2 at);
/// Where a light's mark is drawn; nothing out of view.
std::optional<vec2> lightMark(const Editor& editor, const PlacedLight& light, const Projection& view);

}  // namespace pileus::editor
