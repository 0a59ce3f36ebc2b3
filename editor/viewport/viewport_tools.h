#pragma once
// What the pointer does over the picture: gizmos, picking, moves of the camera, and the tools that wait for
// clicks.
#include <optional>
#include <string>

#include "editor/picture/view_scene.h"
#include "editor/viewport/handles/gizmo.h"
#include "editor/viewport/handles/turn_light.h"

namespace pileus::editor {

struct Clock;
struct Session;
struct Settings;
struct Shown;
struct Theme;
struct Ui;
struct Viewport;
struct ViewportRoom;

/// Puts a light by its shadow: a click on what casts, then the shadow follows the pointer.
struct ShadowPlace {
  enum class Stage { Off, Caster, Shadow } stage = Stage::Off;
  std::string light;
  dvec3 caster{0};
  nodes::Graph before;  ///< what Esc brings back
};

struct ViewportTools {
  GizmoMode mode = GizmoMode::Select;
  std::string inside;  ///< path of the node in a selected group that was clicked in the picture
  // A gizmo being dragged.
  std::optional<GizmoHandle> over;
  std::optional<GizmoDrag> drag;
  nodes::Graph before;
  vec2 pointer{0};  ///< moves slower than the real one with Shift
  std::string readout;
  std::optional<TurnDrag> turn;  ///< light from everywhere that is being turned
  std::string turnHint;          ///< the node that the status line said can be
  // A camera move.
  bool maybeClick = false, usesShift = false, turning = false;
  vec2 pressedAt{0};
  dvec3 pivot{0};

  ShadowPlace place;
  std::optional<scene::Camera> beforeAxis;  ///< what a right click on the axis cross goes back to
  bool overWidget = false;
};

/// Overlays, gizmo and the little controls over the picture, wherever it is shown.
void drawViewportTools(const ViewportRoom& room, bool hovered);
/// After everything that could be over the picture has been drawn. `hovered`: the pointer is free for it.
void routeViewportPointer(const ViewportRoom& room, vec2 min, vec2 max, bool hovered);
/// Esc ends what is going on here; false: nothing was.
bool escapeViewport(Session& session, Shown& shown, Viewport& viewport);
/// Keys do nothing else while a handle is held.
bool viewportHoldsKeys(const Viewport& viewport);

// Actions.
void setGizmoMode(Viewport& viewport, GizmoMode mode);
void insertTransform(Ui& ui, Session& session);
bool canInsertTransform(const Session& session);
void frameSelected(Ui& ui, Session& session, Clock& clock, Shown& shown);

/// The path of the node that a click at a pixel chooses; "" = nothing there.
std::string nodeAt(const Theme& theme, const Session& session, const Shown& shown, const Settings& settings,
                   const Projection& view, vec2 at);
/// Where a light's mark is drawn; nothing out of view.
std::optional<vec2> lightMark(const Theme& theme, const Shown& shown, const PlacedLight& light,
                              const Projection& view);

}  // namespace pileus::editor
