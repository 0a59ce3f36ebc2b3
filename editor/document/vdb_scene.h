#pragma once
// Volume files become lit clouds: the nodes that show them, added to a graph. Pure: no window, no GPU.
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "nodes/graph/graph.h"
#include "renderer/scene/camera.h"
#include "renderer/volume/vdb_fit.h"

namespace pileus::editor {

struct VdbScene {
  nodes::Graph graph;
  std::set<std::string> added;          ///< names of the new nodes
  std::optional<scene::Camera> camera;  ///< what shows the volumes, where the present view does not
  std::string cameraNode;               ///< it was set on this node; "": it is for the free camera
  std::string summary;                  ///< one sentence of what was made
};

/// Each file as a VDB File and a Medium with the fitted extinction, and a second VDB File with a Black Body
/// where it holds fire; fire alone needs no light. A graph with a render gets them linked to it and to its
/// shadow maps; one without gets a sky (daylight.h), a camera, a render and a view. `render`:
/// which one; "": the first. `present`: the camera it is seen through, if known.
Result<VdbScene> addVdbFiles(const nodes::Graph& graph, std::span<const volume::VdbFit> fits,
                             const std::string& render = {},
                             const std::optional<scene::Camera>& present = {});

/// What a node that reads that file is called: the file's name without its ending, as names may be.
std::string nodeNameOf(const std::filesystem::path& file);

/// What was guessed for one file and why, a line each.
std::vector<std::string> explainFit(const volume::VdbFit& fit);

}  // namespace pileus::editor
