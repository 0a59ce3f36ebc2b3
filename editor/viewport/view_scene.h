#pragma once
// What stands in the shown picture and which nodes it comes from: for framing, picking and overlays. Read
// from the last values of the evaluator, so that nothing vanishes while something is being worked out.
#include <string>
#include <vector>

#include "editor/viewport/handles/gizmo_target.h"
#include "renderer/scene/solid.h"
#include "renderer/volume/instance.h"

namespace pileus::editor {

struct Editor;

struct PlacedVolume {
  volume::Instance instance;
  Box3 bounds;                     ///< world
  std::vector<std::string> chain;  ///< nodes it passes through, from the render's input up to its source
};
struct PlacedSolid {
  scene::Solid solid;
  std::vector<std::string> chain;
};
struct PlacedLight {
  std::string node;
  GizmoTarget target;  ///< where its parameters put it
};

struct ViewScene {
  std::vector<PlacedVolume> volumes;
  std::vector<PlacedSolid> solids;
  std::vector<PlacedLight> lights;
  Box3 bounds;  ///< of the volumes
};

ViewScene viewScene(const Editor& editor);
/// Of the selected nodes as they are seen: also where a transform further down moves them.
Box3 selectionBounds(const Editor& editor, const ViewScene& scene);
/// Where suns, which are nowhere, have their marks: the middle of the volumes if it is in view, else that of
/// the view.
dvec3 sunCenter(const ViewScene& scene, const Projection& view);
/// The middle of what flows into a transform, in its own input's place.
dvec3 pivotOf(const Editor& editor, const std::string& node);
/// The only selected node, if there is just one.
std::string onlySelected(const Editor& editor);

}  // namespace pileus::editor
