#include "editor/picture/shown_camera.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/light_view.h"
#include "editor/picture/look_around.h"
#include "editor/picture/shown.h"
#include "editor/picture/viewed_node.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "nodes/declare/value.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_groups.h"
#include "renderer/volume/autofit.h"

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

/// The type of a node by its path; null: there is none.
const nodes::NodeType* typeAt(const Session& session, const std::string& path) {
  const nodes::Node* node = nodes::findNodeAt(session.document.root(), path);
  return node ? nodes::findNodeType(node->type) : nullptr;
}

Box3 volumeBounds(const Session& session, const Shown& shown, const std::string& user) {
  Box3 box;
  const nodes::NodeType* type = typeAt(session, user);
  const nodes::SocketSpec* volumes = type ? socketOfType(*type, nodes::SocketType::Volume) : nullptr;
  if (!volumes) return box;
  for (const nodes::SocketAt& from : nodes::sourcesOf(session.document.root(), user, volumes->id)) {
    const nodes::SocketValue* value = shown.preview.evaluator().output(from.node, from.socket);
    if (const auto* v = value ? std::get_if<nodes::VolumeValue>(value) : nullptr)
      box.extend(volume::worldBulkBounds(v->items));
  }
  return box;
}

double aspect(const Session& session) {
  const ivec2 size = session.document.root().settings.size;
  return size.y > 0 ? static_cast<double>(size.x) / size.y : 1.0;
}

void setExposure(Messages& messages, Session& session, const Clock& clock, const Shown& shown, double stops) {
  const std::string view = displayNode(session, shown);
  if (!view.empty())
    tryEditRoot(session, messages,
                nodes::setParamAt(session.document.root(), view, "exposure", stops, clock.frame), "Exposure",
                "exposure keys");
}

double exposure(const Session& session, const Clock& clock, const Shown& shown) {
  const nodes::Node* node = nodes::findNode(session.document.root(), displayNode(session, shown));
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const nodes::ParamSpec* spec = type ? type->param("exposure") : nullptr;
  const nodes::ParamValue value =
      spec ? nodes::paramValue(*node, *spec, clock.frame) : nodes::ParamValue(0.0);
  return std::get_if<double>(&value) ? std::get<double>(value) : 0.0;
}

}  // namespace

std::string shownView(const Session& session, const Shown& shown) {
  const nodes::Graph& graph = session.document.root();
  return viewable(graph, shown.activeView) ? shown.activeView : firstView(graph);
}

std::string displayNode(const Session& session, const Shown& shown) {
  const nodes::Graph& graph = session.document.root();
  const std::string seenNode = shownView(session, shown);
  std::deque<std::string> open{seenNode};
  std::set<std::string> seen{seenNode};
  for (; !open.empty(); open.pop_front()) {
    const nodes::Node* node = nodes::findNode(graph, open.front());
    if (node && node->type == kViewType) return open.front();
    for (const nodes::Link& link : graph.links)
      if (!link.muted && link.fromNode == open.front() && seen.insert(link.toNode).second)
        open.push_back(link.toNode);
  }
  const nodes::NodeType* type = nodes::findNode(graph, seenNode)
                                    ? nodes::findNodeType(nodes::findNode(graph, seenNode)->type)
                                    : nullptr;
  return type && type->isOutput ? seenNode : firstView(graph);
}

std::string cameraUser(const Session& session, const std::string& view) {
  std::deque<std::string> queue{view};
  std::set<std::string> seen;
  while (!queue.empty()) {
    const std::string path = queue.front();
    queue.pop_front();
    if (path.empty() || !seen.insert(path).second) continue;
    const nodes::NodeType* type = typeAt(session, path);
    if (type && socketOfType(*type, nodes::SocketType::Camera)) return path;
    for (nodes::SocketAt& from : nodes::sourcesOf(session.document.root(), path, {}))
      queue.push_back(std::move(from.node));
  }
  return {};
}

std::string cameraInput(const Session& session, const std::string& user) {
  const nodes::NodeType* type = typeAt(session, user);
  const nodes::SocketSpec* input = type ? socketOfType(*type, nodes::SocketType::Camera) : nullptr;
  return input ? input->id : std::string();
}

std::string linkedCamera(const Session& session, const std::string& view) {
  const std::string user = cameraUser(session, view), input = cameraInput(session, user);
  if (input.empty()) return {};
  for (const nodes::SocketAt& from : nodes::sourcesOf(session.document.root(), user, input)) {
    const nodes::NodeType* type = typeAt(session, from.node);
    const int output = type ? type->outputIndex(from.socket) : -1;
    if (output >= 0 && type->outputs[static_cast<std::size_t>(output)].type == nodes::SocketType::Camera &&
        type->param("eye") && type->param("target"))
      return from.node;
  }
  return {};
}

scene::Camera currentCamera(const Session& session, const Clock& clock, const Shown& shown) {
  if (const auto light = lightViewCamera(session, clock, shown)) return *light;
  if (const auto around = aroundCamera(session, shown)) return *around;
  const std::string view = shownView(session, shown), name = linkedCamera(session, view);
  if (name.empty()) {
    if (shown.freeCamera) return *shown.freeCamera;
    return scene::frameBounds(volumeBounds(session, shown, cameraUser(session, view)), aspect(session));
  }
  const nodes::Node& node = *nodes::findNodeAt(session.document.root(), name);
  const nodes::NodeType& type = *nodes::findNodeType(node.type);
  scene::Camera camera;
  const auto vector = [&](const char* id, dvec3& out) {
    if (const nodes::ParamSpec* spec = type.param(id)) {
      const nodes::ParamValue value = nodes::paramValue(node, *spec, clock.frame);
      if (const dvec3* v = std::get_if<dvec3>(&value)) out = *v;
    }
  };
  vector("eye", camera.eye);
  vector("target", camera.target);
  vector("up", camera.up);
  if (const nodes::ParamSpec* spec = type.param("fov")) {
    const nodes::ParamValue value = nodes::paramValue(node, *spec, clock.frame);
    if (const double* v = std::get_if<double>(&value)) camera.fov = *v;
  }
  return camera;
}

void setCamera(Messages& messages, Session& session, Clock& clock, Shown& shown, const scene::Camera& camera,
               const std::string& label, const std::string& mergeKey) {
  const std::string name = linkedCamera(session, shownView(session, shown));
  shown.preview.touch();
  if (lightViewCamera(session, clock, shown))
    return moveLightView(messages, session, clock, shown, camera, mergeKey);
  if (name.empty())
    shown.freeCamera = camera;
  else if (cameraLocked(session, clock, shown) || aroundCamera(session, shown))
    shown.around = {name, camera};
  else
    moveCamera(messages, session, clock, shown, name, camera, label, mergeKey);
}

void moveCamera(Messages& messages, Session& session, Clock& clock, Shown& shown, const std::string& name,
                const scene::Camera& camera, const std::string& label, const std::string& mergeKey) {
  shown.preview.touch();
  const double scale = glm::length(camera.eye - camera.target);
  const scene::Camera now = currentCamera(session, clock, shown);
  holdFrame(clock, *nodes::findNodeAt(session.document.root(), name));
  Result<nodes::Graph> graph = session.document.root();
  // What stays as it is, but for rounding, gets no key.
  const auto moved = [&](const dvec3& a, const dvec3& b) { return glm::length(a - b) > 1e-9 * scale; };
  const auto set = [&](const char* id, const nodes::ParamValue& value, bool changed) {
    if (graph && changed) graph = nodes::setParamAt(*graph, name, id, value, clock.frame);
  };
  set("eye", tidy(camera.eye, scale), moved(camera.eye, now.eye));
  set("target", tidy(camera.target, scale), moved(camera.target, now.target));
  // A place that was saved has an angle of its own.
  set("fov", camera.fov, camera.fov != now.fov);
  set("up", camera.up, camera.up != now.up);
  tryEditRoot(session, messages, std::move(graph), label, mergeKey);
}

void frameVolumes(Messages& messages, Session& session, Clock& clock, Shown& shown) {
  const std::string user = cameraUser(session, shownView(session, shown));
  const Box3 box = volumeBounds(session, shown, user);
  if (box.empty()) return messages.hint("There is no volume to frame yet.");
  setCamera(messages, session, clock, shown,
            scene::frameBounds(box, aspect(session), currentCamera(session, clock, shown)), "Frame volumes",
            {});
}

void changeExposure(Messages& messages, Session& session, const Clock& clock, const Shown& shown,
                    double stops) {
  setExposure(messages, session, clock, shown, exposure(session, clock, shown) + stops);
}
void resetExposure(Messages& messages, Session& session, const Clock& clock, const Shown& shown) {
  setExposure(messages, session, clock, shown, 0);
}

}  // namespace pileus::editor
