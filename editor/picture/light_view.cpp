#include "editor/picture/light_view.h"

#include <algorithm>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/node_placement.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {

std::string lightToUse(const Session& session, const Shown& shown) {
  const nodes::Graph& graph = session.document.graph();
  for (const std::string& name : session.document.selection())
    if (const nodes::Node* node = nodes::findNode(graph, name); node && node->type.starts_with("light."))
      return session.document.scopedName(name);
  const auto& lights = shown.scene.lights;
  const auto inSelected = std::find_if(lights.begin(), lights.end(),
                                       [&](const PlacedLight& l) { return selects(session, l.node); });
  if (inSelected != lights.end()) return inSelected->node;
  return lights.size() == 1 ? lights.front().node : "";
}

void lookThroughLight(Messages& messages, Session& session, const Clock& clock, Shown& shown) {
  LightView& look = shown.look;
  if (!look.light.empty()) return leaveLightView(session, shown);
  const std::string light = lightToUse(session, shown);
  const auto target = gizmoTarget(session.document.root(), light, {}, clock.frame);
  if (!target) return messages.hint("Select a light first to look through it.");
  const Box3& bounds = shown.scene.bounds;
  const dvec3 center = bounds.empty() ? dvec3(0) : bounds.center();
  look = {light, center, 1, target->sun ? 8.0 : 60.0};
  if (target->sun) {
    const ivec2 size = session.document.root().settings.size;
    scene::Camera camera;
    camera.target = center, camera.eye = center + scene::sunDirection(target->azimuth, target->elevation),
    camera.fov = look.fov;
    camera = scene::frameBounds(bounds, double(size.x) / std::max(size.y, 1), camera);
    look.distance = glm::length(camera.eye - camera.target);
  } else if (target->aims) {
    look.target = target->aim;
  }
  shown.preview.touch();
}

void leaveLightView(Session& session, Shown& shown) {
  shown.look = {};
  session.document.endMerge();
}

std::optional<scene::Camera> lightViewCamera(const Session& session, const Clock& clock, const Shown& shown) {
  const LightView& look = shown.look;
  if (look.light.empty()) return std::nullopt;
  const auto target = gizmoTarget(session.document.root(), look.light, {}, clock.frame);
  if (!target) return std::nullopt;
  scene::Camera camera;
  camera.fov = target->hasCone ? std::clamp(target->cone, 1.0, 120.0) : look.fov;
  camera.target = target->aims ? target->aim : look.target;
  camera.eye = target->sun
                   ? look.target + look.distance * scene::sunDirection(target->azimuth, target->elevation)
                   : target->position;
  if (!(glm::length(camera.eye - camera.target) > 1e-9)) camera.eye += dvec3(0, 1e-3, 0);
  return camera;
}

void moveLightView(Messages& messages, Session& session, Clock& clock, Shown& shown,
                   const scene::Camera& camera, const std::string& mergeKey) {
  LightView& look = shown.look;
  const auto start = gizmoTarget(session.document.root(), look.light, {}, clock.frame);
  if (!start) return;
  holdFrame(clock, *nodes::findNodeAt(session.document.root(), look.light));
  const dvec3 towards = camera.eye - camera.target;
  GizmoTarget to = *start;
  look.target = camera.target;
  look.distance = glm::length(towards);
  if (start->sun) {
    // A pan or dolly only looks elsewhere.
    const dvec3 before = scene::sunDirection(start->azimuth, start->elevation);
    if (glm::length(glm::normalize(towards) - before) < 1e-7) return;
    const dvec2 angles = azimuthElevation(towards, start->azimuth);
    to.azimuth = angles.x, to.elevation = angles.y;
  } else {
    to.position = camera.eye;
    if (to.aims) to.aim = camera.target;
  }
  tryEditRoot(session, messages, withTarget(session.document.root(), *start, to, look.distance, clock.frame),
              "Move " + look.light, mergeKey);
}

void applyLightView(const Session& session, const Clock& clock, const Shown& shown, PreviewRequest& request) {
  const auto camera = lightViewCamera(session, clock, shown);
  if (!camera) return;
  request.freeCamera = camera;
  std::erase_if(request.graph.links, [&](const nodes::Link& link) {
    const nodes::Node* node = nodes::findNode(request.graph, link.fromNode);
    return node && node->type.starts_with("camera.");
  });
  request.revision ^= std::uint64_t(1) << 63;  // another graph than the document's
}

}  // namespace pileus::editor
