#pragma once
// What of a node can be dragged in the viewport, as one value: read from its parameters, changed by a gizmo,
// written back.
#include <optional>
#include <string>

#include "editor/picture/gizmo_math.h"
#include "nodes/graph/graph.h"

namespace pileus::editor {

struct GizmoTarget {
  std::string node;  ///< its path where it is in a group

  bool moves = false;
  dvec3 position{0};  ///< world; of a transform with a pivot: where the pivot is
  bool turns = false;
  dvec3 rotate{0};  ///< degrees
  bool scales = false;
  dvec3 scale{1};        ///< or the edge lengths
  bool uniform = false;  ///< one number: a radius
  bool flat = false;     ///< Y has no size
  dvec3 pivot{0};        ///< transforms: what stays in place where it turns or grows, before the transform

  bool aims = false;
  dvec3 aim{0};  ///< spot and camera: what they look at
  bool hasCone = false;
  double cone = 60;  ///< full angle, degrees

  bool sun = false;
  double azimuth = 0, elevation = 0;  ///< degrees

  bool any() const { return moves || aims || sun; }
  dmat4 placement() const;  ///< of a volume before the transform
  bool operator==(const GizmoTarget&) const = default;
};

/// What the node's type lets be dragged, as it is at `frame`; nothing for others. `pivot`: the middle of what
/// flows into a transform.
std::optional<GizmoTarget> gizmoTarget(const nodes::Graph& graph, const std::string& node, const dvec3& pivot,
                                       double frame);
/// The graph with what differs from `before` written into the node, as keys at `frame` where it is animated;
/// `scale`: metres that count as coarse, for rounding.
Result<nodes::Graph> withTarget(const nodes::Graph& graph, const GizmoTarget& before,
                                const GizmoTarget& after, double scale, double frame);

/// A new node's size and place for a scene with these bounds, written as values: in a scene of 500 m a plane
/// of 10 m would not be seen. Where the scene is about as large as the defaults are meant for, or the node is
/// nothing that stands in it, the graph as it is.
struct FittedNode {
  nodes::Graph graph;
  std::string note;  ///< what was done; "" = nothing
};
FittedNode fittedToScene(const nodes::Graph& graph, const std::string& node, const Box3& bounds);

}  // namespace pileus::editor
