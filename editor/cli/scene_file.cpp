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

/// Until it is complete. Warnings of nodes are printed.
Result<void> evaluate(nodes::Evaluator& evaluator, const nodes::Graph& graph, const std::string& node,
                      nodes::EvalSettings settings, const std::string& doing) {
  settings.budgetMs = 250;
  MeasureProgress progress;
  for (nodes::EvalReport r; !r.complete;) {
    if (interrupted()) return fail(Code::Cancelled, "cancelled");
    r = evaluator.evaluate(graph, {node}, settings);
    progress.show(r.fraction, doing);
    if (r.waitingForJobs) std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  progress.finish();
  for (const auto& [name, made] : graph.nodes) {
    const nodes::NodeStatus& s = evaluator.status(name);
    for (const std::string& w : s.warnings) fmt::print(stderr, "pileus: warning: {}: {}\n", name, w);
    if (s.state == nodes::NodeState::Failed) return s.error;
  }
  return {};
}

void catchSignals() {
  stopped = 0;
  ::signal(SIGINT, onSignal);
  ::signal(SIGTERM, onSignal);
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
  nodes::Evaluator evaluator(&renderer);
  PILEUS_CHECK(evaluate(evaluator, graph, renderNode, settings, "Evaluating " + renderNode));
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
  catchSignals();
  SceneFile out;
  PILEUS_TRY(out.graph, loadFaultless(file, "measured"));
  PILEUS_TRY(out.renderNode, chooseRender(out.graph, file, renderNode));
  PILEUS_TRY(out.context, gl::HeadlessContext::create());
  PILEUS_TRY(out.renderer, view::Renderer::create());
  PILEUS_TRY(out.scene, sceneOf(*out.renderer, out.graph, out.renderNode, file));
  return out;
}

Result<PictureFile> openPicture(const fs::path& file, const std::string& output, std::optional<ivec2> size) {
  catchSignals();
  PictureFile out;
  PILEUS_TRY(out.graph, loadFaultless(file, "judged"));
  if (size) out.graph.settings.size = *size;
  PILEUS_TRY(out.output, outputNode(out.graph, file, output));
  PILEUS_TRY(out.context, gl::HeadlessContext::create());
  PILEUS_TRY(out.renderer, view::Renderer::create());
  nodes::EvalSettings settings;
  settings.frame = out.graph.settings.frames.x;
  settings.size = out.graph.settings.size;
  settings.folder = fs::absolute(file).parent_path();
  nodes::Evaluator evaluator(out.renderer.get());
  PILEUS_CHECK(evaluate(evaluator, out.graph, out.output, settings, "Rendering " + out.output));
  const nodes::SocketValue* value = evaluator.input(out.output, "image");
  const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  if (!image || !image->picture) return fail(Code::Input, "{}.image: no picture arrives", out.output);
  if (!image->picture->scene)
    return fail(Code::Input, "{}.image: the picture was made from others; link a render node to be judged",
                out.output);
  out.picture = image->picture;
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
