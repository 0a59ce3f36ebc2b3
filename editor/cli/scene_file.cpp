#include "editor/cli/scene_file.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "editor/cli/graph_file.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "renderer/view/picture.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

volatile sig_atomic_t stopped = 0;
void onSignal(int) { stopped = 1; }

bool hasLights(const nodes::Graph& graph, const std::string& node) {
  return std::any_of(graph.links.begin(), graph.links.end(), [&](const nodes::Link& l) {
    return !l.muted && l.toNode == node && l.toSocket == "lights";
  });
}

Result<std::string> chooseRender(const nodes::Graph& graph, const fs::path& file, const std::string& wanted) {
  const auto isRender = [&](const std::string& name) {
    const nodes::Node* n = nodes::findNode(graph, name);
    return n && n->type == "render.volume";
  };
  if (!wanted.empty()) {
    if (isRender(wanted)) return wanted;
    return fail(Code::Arguments, "--render: {} has no render.volume node named '{}'", file.string(), wanted);
  }
  std::string any;
  for (const std::string& name : nodes::upstreamOrder(graph, nodes::outputNodes(graph)).order)
    if (isRender(name)) any = hasLights(graph, name) || any.empty() ? name : any;
  if (!any.empty() && hasLights(graph, any)) return any;
  for (const auto& [name, node] : graph.nodes)
    if (isRender(name) && (any.empty() || hasLights(graph, name))) any = name;
  if (any.empty()) return fail(Code::Input, "{}: has no render.volume node", file.string());
  if (!hasLights(graph, any)) return fail(Code::Input, "{}: no light is linked to {}", file.string(), any);
  return any;
}

}  // namespace

Result<view::RenderScene> sceneOf(view::Renderer& renderer, const nodes::Graph& graph,
                                  const std::string& renderNode, const fs::path& file) {
  // Only the scene is wanted: a draft of a small picture, with small maps.
  nodes::EvalSettings settings;
  settings.quality = nodes::Quality::Draft;
  settings.frame = graph.settings.frames.x;
  settings.size = glm::max(graph.settings.size / std::max(1, graph.settings.size.x / 64), ivec2(1));
  settings.folder = fs::absolute(file).parent_path();
  settings.budgetMs = 250;
  nodes::Evaluator evaluator(&renderer);
  MeasureProgress progress;
  for (nodes::EvalReport r; !r.complete;) {
    if (interrupted()) return fail(Code::Cancelled, "cancelled");
    r = evaluator.evaluate(graph, {renderNode}, settings);
    progress.show(r.fraction, "Evaluating " + renderNode);
    if (r.waitingForJobs) std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  progress.finish();
  for (const auto& [name, node] : graph.nodes) {
    const nodes::NodeStatus& s = evaluator.status(name);
    for (const std::string& w : s.warnings) fmt::print(stderr, "pileus: warning: {}: {}\n", name, w);
    if (s.state == nodes::NodeState::Failed) return s.error;
  }
  const nodes::SocketValue* value = evaluator.output(renderNode, "image");
  const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  if (!image || !image->picture || !image->picture->scene)
    return fail(Code::Input, "{}: {} gives no picture", file.string(), renderNode);
  view::RenderScene scene = *image->picture->scene;
  scene.options.size = graph.settings.size;
  // What a draft has changed.
  const nodes::Node& node = *nodes::findNode(graph, renderNode);
  const nodes::NodeType& type = *nodes::findNodeType(node.type);
  scene.options.samples = std::get<int>(nodes::paramValue(node, *type.param("samples"), settings.frame));
  scene.options.stepScale =
      std::get<double>(nodes::paramValue(node, *type.param("step_scale"), settings.frame));
  if (scene.lights.empty()) return fail(Code::Input, "{}: no light reaches {}", file.string(), renderNode);
  if (scene.volumes.empty()) return fail(Code::Input, "{}: no volume reaches {}", file.string(), renderNode);
  return scene;
}

Result<SceneFile> openScene(const fs::path& file, const std::string& renderNode) {
  stopped = 0;
  ::signal(SIGINT, onSignal);
  ::signal(SIGTERM, onSignal);
  SceneFile out;
  PILEUS_TRY(out.graph, loadFaultless(file, "measured"));
  PILEUS_TRY(out.renderNode, chooseRender(out.graph, file, renderNode));
  PILEUS_TRY(out.context, gl::HeadlessContext::create());
  PILEUS_TRY(out.renderer, view::Renderer::create());
  PILEUS_TRY(out.scene, sceneOf(*out.renderer, out.graph, out.renderNode, file));
  return out;
}

bool interrupted() { return stopped != 0; }

bool MeasureProgress::isTerminal() { return ::isatty(2) != 0; }

void MeasureProgress::show(double fraction, const std::string& what) {
  if (!terminal_ && what == last_) return;
  last_ = what;
  if (terminal_)
    fmt::print(stderr, "\r{:3.0f} %  {}\033[K", 100 * fraction, what);
  else
    fmt::print(stderr, "{}\n", what);
  std::fflush(stderr);
}

void MeasureProgress::finish() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

}  // namespace pileus::cli
