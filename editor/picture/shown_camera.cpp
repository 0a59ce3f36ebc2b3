#include "editor/picture/shown_camera.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

#include "editor/app/editor.h"
#include "editor/picture/shadow_place.h"
#include "editor/picture/viewed_node.h"
#include "editor/time/playback.h"
#include "nodes/declare/value.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {
namespace {

constexpr std::string_view kViewType = "output.view";

std::string firstView(const nodes::Graph& graph) {
  for (const auto& [name, node] : graph.nodes)
    if (node->type == kViewType) return name;
  return {};
}

const nodes::SocketSpec* socketOfType(const nodes::NodeType& type, nodes::SocketType wanted) {
  for (const nodes::SocketSpec& s : type.inputs)
    if (s.type == wanted) return &s;
  return nullptr;
}

Box3 volumeBounds(const Editor& editor, const std::string& user) {
  Box3 box;
  const nodes::Graph& graph = editor.document.root();
  const nodes::Node* node = nodes::findNode(graph, user);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const nodes::SocketSpec* volumes = type ? socketOfType(*type, nodes::SocketType::Volume) : nullptr;
  if (!volumes) return box;
  for (const nodes::Link& link : graph.links) {
    if (link.toNode != user || link.toSocket != volumes->id || link.muted) continue;
    const nodes::SocketValue* value = editor.preview.evaluator().output(link.fromNode, link.fromSocket);
    if (const auto* v = value ? std::get_if<nodes::VolumeValue>(value) : nullptr)
      box.extend(volume::worldBounds(v->items));
  }
  return box;
}

double aspect(const Editor& editor) {
  const ivec2 size = editor.document.root().settings.size;
  return size.y > 0 ? static_cast<double>(size.x) / size.y : 1.0;
}

void setExposure(Editor& editor, double stops) {
  const std::string view = displayNode(editor);
  if (!view.empty())
    tryEditRoot(editor, nodes::setParamAt(editor.document.root(), view, "exposure", stops, editor.frame),
                "Exposure", "exposure keys");
}

double exposure(const Editor& editor) {
  const nodes::Node* node = nodes::findNode(editor.document.root(), displayNode(editor));
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const nodes::ParamSpec* spec = type ? type->param("exposure") : nullptr;
  const nodes::ParamValue value =
      spec ? nodes::paramValue(*node, *spec, editor.frame) : nodes::ParamValue(0.0);
  return std::get_if<double>(&value) ? std::get<double>(value) : 0.0;
}

}  // namespace

std::string shownView(const Editor& editor) {
  const nodes::Graph& graph = editor.document.root();
  return viewable(graph, editor.viewport.activeView) ? editor.viewport.activeView : firstView(graph);
}

std::string displayNode(const Editor& editor) {
  const nodes::Graph& graph = editor.document.root();
  const std::string shown = shownView(editor);
  std::deque<std::string> open{shown};
  std::set<std::string> seen{shown};
  for (; !open.empty(); open.pop_front()) {
    const nodes::Node* node = nodes::findNode(graph, open.front());
    if (node && node->type == kViewType) return open.front();
    for (const nodes::Link& link : graph.links)
      if (!link.muted && link.fromNode == open.front() && seen.insert(link.toNode).second)
        open.push_back(link.toNode);
  }
  const nodes::NodeType* type =
      nodes::findNode(graph, shown) ? nodes::findNodeType(nodes::findNode(graph, shown)->type) : nullptr;
  return type && type->isOutput ? shown : firstView(graph);
}

std::string cameraUser(const Editor& editor, const std::string& view) {
  const nodes::Graph& graph = editor.document.root();
  std::deque<std::string> queue{view};
  std::set<std::string> seen;
  while (!queue.empty()) {
    const std::string name = queue.front();
    queue.pop_front();
    if (name.empty() || !seen.insert(name).second) continue;
    const nodes::Node* node = nodes::findNode(graph, name);
    const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
    if (type && socketOfType(*type, nodes::SocketType::Camera)) return name;
    for (const nodes::Link& link : graph.links)
      if (link.toNode == name && !link.muted) queue.push_back(link.fromNode);
  }
  return {};
}

std::string linkedCamera(const Editor& editor, const std::string& view) {
  const std::string user = cameraUser(editor, view);
  const nodes::Graph& graph = editor.document.root();
  for (const nodes::Link& link : graph.links) {
    if (link.toNode != user || link.muted) continue;
    const nodes::Node* source = nodes::findNode(graph, link.fromNode);
    const nodes::NodeType* type = source ? nodes::findNodeType(source->type) : nullptr;
    const int output = type ? type->outputIndex(link.fromSocket) : -1;
    if (output >= 0 && type->outputs[static_cast<std::size_t>(output)].type == nodes::SocketType::Camera &&
        type->param("eye") && type->param("target"))
      return link.fromNode;
  }
  return {};
}

scene::Camera currentCamera(const Editor& editor) {
  if (const auto light = lightViewCamera(editor)) return *light;
  const std::string view = shownView(editor), name = linkedCamera(editor, view);
  if (name.empty()) {
    if (editor.viewport.freeCamera) return *editor.viewport.freeCamera;
    return scene::frameBounds(volumeBounds(editor, cameraUser(editor, view)), aspect(editor));
  }
  const nodes::Node& node = *nodes::findNode(editor.document.root(), name);
  const nodes::NodeType& type = *nodes::findNodeType(node.type);
  scene::Camera camera;
  const auto vector = [&](const char* id, dvec3& out) {
    if (const nodes::ParamSpec* spec = type.param(id)) {
      const nodes::ParamValue value = nodes::paramValue(node, *spec, editor.frame);
      if (const dvec3* v = std::get_if<dvec3>(&value)) out = *v;
    }
  };
  vector("eye", camera.eye);
  vector("target", camera.target);
  vector("up", camera.up);
  if (const nodes::ParamSpec* spec = type.param("fov")) {
    const nodes::ParamValue value = nodes::paramValue(node, *spec, editor.frame);
    if (const double* v = std::get_if<double>(&value)) camera.fov = *v;
  }
  return camera;
}

void setCamera(Editor& editor, const scene::Camera& camera, const std::string& label,
               const std::string& mergeKey) {
  const std::string name = linkedCamera(editor, shownView(editor));
  editor.preview.touch();
  if (lightViewCamera(editor)) return moveLightView(editor, camera, mergeKey);
  if (name.empty()) {
    editor.viewport.freeCamera = camera;
    return;
  }
  const double scale = glm::length(camera.eye - camera.target);
  const scene::Camera now = currentCamera(editor);
  holdFrame(editor, *nodes::findNode(editor.document.root(), name));
  Result<nodes::Graph> graph = editor.document.root();
  // What stays as it is, but for rounding, gets no key.
  const auto moved = [&](const dvec3& a, const dvec3& b) { return glm::length(a - b) > 1e-9 * scale; };
  const auto set = [&](const char* id, const nodes::ParamValue& value, bool changed) {
    if (graph && changed) graph = nodes::setParamAt(*graph, name, id, value, editor.frame);
  };
  set("eye", tidy(camera.eye, scale), moved(camera.eye, now.eye));
  set("target", tidy(camera.target, scale), moved(camera.target, now.target));
  // A place that was saved has an angle of its own.
  set("fov", camera.fov, camera.fov != now.fov);
  set("up", camera.up, camera.up != now.up);
  tryEditRoot(editor, std::move(graph), label, mergeKey);
}

void frameVolumes(Editor& editor) {
  const std::string user = cameraUser(editor, shownView(editor));
  const Box3 box = volumeBounds(editor, user);
  if (box.empty()) return editor.messages.hint("There is no volume to frame yet.");
  setCamera(editor, scene::frameBounds(box, aspect(editor), currentCamera(editor)), "Frame volumes", {});
}

void changeExposure(Editor& editor, double stops) { setExposure(editor, exposure(editor) + stops); }
void resetExposure(Editor& editor) { setExposure(editor, 0); }

}  // namespace pileus::editor
