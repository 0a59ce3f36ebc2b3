#pragma once
// What stands in the shown picture and which nodes it comes from: for framing, picking and overlays. Read
// from the last values of the evaluator, so that nothing vanishes while something is being worked out.
#include <cstdint>
#include <string>
#include <vector>

#include "editor/picture/node_placement.h"
#include "renderer/scene/solid.h"
#include "renderer/volume/instance.h"

namespace pileus::editor {

struct Clock;
struct Session;
struct Shown;

struct PlacedVolume {
  volume::Instance instance;
  Box3 bounds;  ///< world
  /// Nodes it passes through, by their paths, from the render's input up to its source.
  std::vector<std::string> chain;
};
struct PlacedSolid {
  scene::Solid solid;
  std::vector<std::string> chain;
};
struct PlacedLight {
  std::string node;    ///< its path
  GizmoTarget target;  ///< where its parameters put it
};

struct ViewScene {
  std::vector<PlacedVolume> volumes;
  std::vector<PlacedSolid> solids;
  std::vector<PlacedLight> lights;
  Box3 bounds;  ///< of the volumes
};

/// The scene of the picture as it was last looked at, and what it was made of.
struct SceneCache : ViewScene {
  std::uint64_t revision = 0, answered = 0;
  std::string view;
  int frame = 0;
  bool complete = false;
};
/// Looks again where document, frame or their values have changed; once a frame.
void followScene(const Session& session, const Clock& clock, Shown& shown);
/// Of the selected nodes as they are seen: also where a transform further down moves them.
Box3 selectionBounds(const Session& session, const ViewScene& scene);
/// Where suns, which are nowhere, have their marks: the middle of the volumes if it is in view, else that of
/// the view.
dvec3 sunCenter(const ViewScene& scene, const Projection& view);
/// The middle of what flows into a transform, given by its path, in its own input's place.
dvec3 pivotOf(const Shown& shown, const std::string& node);
/// The only selected node, if there is just one.
std::string onlySelected(const Session& session);
/// Is the node with that path selected, or a group it is in?
bool selects(const Session& session, const std::string& path);
/// What the canvas shows of it, in the group that was entered: its name, or that of the group it is in; "" =
/// nothing.
std::string shownInScope(const Session& session, const std::string& path);
/// The path of the node whose handles are shown: the only selected one; of a group the node `inside` it, or
/// the only one in it that has some. "" = none.
std::string handledNode(const Session& session, const std::string& inside, double frame);

}  // namespace pileus::editor
