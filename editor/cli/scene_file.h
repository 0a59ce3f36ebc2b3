#pragma once
// A graph file opened for measuring: the scene of one of its render nodes, or the picture of one of its
// outputs, without a window.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "nodes/graph/graph.h"
#include "renderer/gl/context.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"
#include "renderer/view/renderer.h"

namespace pileus::cli {

struct SceneFile {
  std::unique_ptr<gl::HeadlessContext> context;
  std::unique_ptr<view::Renderer> renderer;
  nodes::Graph graph;
  std::string renderNode;
  view::RenderScene scene;  ///< at the file's first frame; its picture has the size and samples of the file
};

/// `renderNode` "": the one that feeds an output, else the first by name that has lights. Faults and warnings
/// are printed on standard error. Error (Input) naming the file: faults, no render node, no lights, no
/// volumes; Error (Arguments): no such node; Error (Cancelled) on SIGINT and SIGTERM.
Result<SceneFile> openScene(const std::filesystem::path& file, const std::string& renderNode);

struct PictureFile {
  std::unique_ptr<gl::HeadlessContext> context;
  std::unique_ptr<view::Renderer> renderer;
  nodes::Graph graph;
  std::string output;                            ///< node
  std::shared_ptr<const view::Picture> picture;  ///< finished, of the first frame, with its scene
};

/// What `pileus render` would write of the file's first frame; `output` "": the only output node. Faults,
/// warnings and progress go to standard error. Error (Input) naming the file or node: faults, no picture, or
/// one that was made from others; Error (Arguments): which output is meant; Error (Cancelled) on SIGINT and
/// SIGTERM.
Result<PictureFile> openPicture(const std::filesystem::path& file, const std::string& output,
                                std::optional<ivec2> size);

/// The scene, as openScene() has it, of a graph that was read from, or will lie in, `file`, on a renderer
/// that is there. GL thread.
Result<view::RenderScene> sceneOf(view::Renderer& renderer, const nodes::Graph& graph,
                                  const std::string& renderNode, const std::filesystem::path& file);

/// Has SIGINT or SIGTERM been received since openScene() or openPicture()?
bool interrupted();

/// One changing line on a terminal; otherwise a line whenever `what` changes.
class MeasureProgress {
 public:
  void show(double fraction, const std::string& what);
  void finish();

 private:
  bool terminal_ = isTerminal();
  std::string last_;
  static bool isTerminal();
};

}  // namespace pileus::cli
