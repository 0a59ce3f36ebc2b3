#pragma once
// The handles over a node in the viewport: what they look like on the screen, which is under the pointer, and
// what dragging one makes of the target. Pure functions; the state of a drag is a value.
#include <string>
#include <vector>

#include "editor/picture/node_placement.h"

namespace pileus::editor {

enum class GizmoMode { Select, Move, Rotate, Scale };

struct GizmoHandle {
  enum class Part {
    Axis,
    Plane,
    Free,
    Ring,
    ViewRing,
    ScaleAxis,
    ScalePlane,
    ScaleAll,
    Aim,
    Cone,
    SunDisc,
    SunAzimuth,
    SunElevation
  };
  Part part = Part::Free;
  int axis = 0;  ///< Plane: of its normal
  bool operator==(const GizmoHandle&) const = default;
};

/// A gizmo as it stands in the world this frame.
struct GizmoFrame {
  GizmoTarget target;
  GizmoMode mode = GizmoMode::Select;
  dvec3 center{0};
  glm::dmat3 axes{1.0};  ///< columns: the directions of the handles
  bool local = false;
  double size = 1;  ///< metres of an arm, so that it is the same length on the screen everywhere
  dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  ///< of the view
};

/// Nothing where the target is behind the camera or has no handles in this mode. `armPixels`: length of an
/// arm; `sunCenter`: where suns, which are nowhere, have their handles.
std::optional<GizmoFrame> gizmoFrame(const GizmoTarget& target, GizmoMode mode, bool local,
                                     const Projection& view, float armPixels, const dvec3& sunCenter);

/// One drawn line or area of a handle.
struct GizmoShape {
  enum class Ink { X, Y, Z, Neutral, Light };
  enum class Tip { None, Arrow, Box, Dot, Sun };
  std::optional<GizmoHandle> handle;  ///< none: only to be seen
  std::vector<vec2> line;             ///< pixels
  bool closed = false, filled = false, faint = false;
  Ink ink = Ink::Neutral;
  Tip tip = Tip::None;  ///< at the last point
};

/// In the order they are drawn.
std::vector<GizmoShape> gizmoShapes(const GizmoFrame& frame, const Projection& view, float pixel);
/// The handle at a point of the screen; `reach` in pixels.
std::optional<GizmoHandle> gizmoAt(const std::vector<GizmoShape>& shapes, vec2 at, float reach);

struct GizmoDrag {
  GizmoHandle handle;
  GizmoFrame start;
  Ray from;
};
struct GizmoDragged {
  GizmoTarget target;
  std::string readout;  ///< what to write beside the pointer
};
/// `snap`: to multiples of `grid` metres, 15 degrees or tenths. Nothing where the ray says nothing.
std::optional<GizmoDragged> dragGizmo(const GizmoDrag& drag, const Ray& to, bool snap, double grid);

}  // namespace pileus::editor
