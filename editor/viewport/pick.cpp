// What a click in the picture chooses, and inserting a transform where a volume has none.
#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/viewport_tools.h"
#include "nodes/graph/graph_groups.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {
namespace {

/// The node to take hold of: the nearest transform on the way up, else where it comes from.
std::string handleOf(const nodes::Graph& graph, const std::vector<std::string>& chain) {
  for (const std::string& name : chain)
    if (const nodes::Node* node = nodes::findNodeAt(graph, name);
        node && node->type == "volume.transform" && !node->bypass)
      return name;
  return chain.empty() ? "" : chain.back();
}

std::optional<double> rayMeets(const volume::Instance& i, const Ray& ray) {
  if (std::abs(glm::determinant(glm::dmat3(i.worldFromLocal))) < 1e-30) return std::nullopt;
  const dmat4 local = glm::inverse(i.worldFromLocal);
  const dvec3 o(local * dvec4(ray.origin, 1)), d(local * dvec4(ray.direction, 0));
  const Box3 box = volume::localBounds(i);
  const auto hit =
      i.shape == volume::Shape::Ball ? intersectBall(o, d) : intersectBox(o, d, box.min, box.max);
  if (!hit || hit->y <= 0) return std::nullopt;
  // From inside a haze what lies before its far side comes first.
  return hit->x > 0 ? hit->x : hit->y;
}

const nodes::SocketSpec* volumeOutput(const nodes::Graph& graph, const std::string& name) {
  const nodes::Node* node = nodes::findNode(graph, name);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (!type) return nullptr;
  for (const nodes::SocketSpec& s : type->outputs)
    if (s.type == nodes::SocketType::Volume) return &s;
  return nullptr;
}

}  // namespace

std::optional<vec2> lightMark(const Theme& theme, const Shown& shown, const PlacedLight& light,
                              const Projection& view) {
  if (!light.target.sun) return view.screen(light.target.position);
  const dvec3 center = sunCenter(shown.scene, view);
  const double metres = view.metresPerPixel(center);
  if (!(metres > 0)) return std::nullopt;
  return view.screen(center + metres * static_cast<double>(theme.px(96)) *
                                  scene::sunDirection(light.target.azimuth, light.target.elevation));
}

std::string nodeAt(const Theme& theme, const Session& session, const Shown& shown, const Settings& settings,
                   const Projection& view, vec2 at) {
  const ViewScene& scene = shown.scene;
  if (settings.view.overlays.on && settings.view.overlays.lights) {
    std::string nearest;
    float best = theme.px(12);
    for (const PlacedLight& light : scene.lights)
      if (const auto mark = lightMark(theme, shown, light, view); mark && glm::length(*mark - at) < best)
        best = glm::length(*mark - at), nearest = light.node;
    if (!nearest.empty()) return nearest;
  }
  const Ray ray = view.ray(at);
  const nodes::Graph& graph = session.document.root();
  // What is seen there, so that a cloud within a haze can be chosen; else the nearest bounds.
  const auto& picture = shown.preview.picture();
  const auto seen =
      picture && picture->scene
          ? view::visiblePoint(*picture->scene, dvec2((at - view.min()) / (view.max() - view.min())))
          : std::nullopt;
  if (seen) {
    const double distance = glm::length(*seen - ray.origin);
    for (const PlacedSolid& s : scene.solids)
      if (const auto hit = scene::intersect(s.solid, ray.origin, ray.direction);
          hit && std::abs(hit->t - distance) < 1e-3 * distance)
        return handleOf(graph, s.chain);
    const PlacedVolume* densest = nullptr;
    double most = 0;
    for (const PlacedVolume& v : scene.volumes)
      if (const double sigma = volume::sigmaAt(v.instance, *seen); sigma > most) most = sigma, densest = &v;
    if (densest) return handleOf(graph, densest->chain);
  }
  std::string name;
  double nearest = std::numeric_limits<double>::infinity();
  for (const PlacedVolume& v : scene.volumes)
    if (const auto t = rayMeets(v.instance, ray); t && *t < nearest)
      nearest = *t, name = handleOf(graph, v.chain);
  for (const PlacedSolid& s : scene.solids)
    if (const auto hit = scene::intersect(s.solid, ray.origin, ray.direction); hit && hit->t < nearest)
      nearest = hit->t, name = handleOf(graph, s.chain);
  return name;
}

bool canInsertTransform(const Session& session) {
  const std::string name = onlySelected(session);
  const nodes::Node* node = nodes::findNode(session.document.graph(), name);
  return node && node->type != "volume.transform" && volumeOutput(session.document.graph(), name);
}

void insertTransform(Ui& ui, Session& session) {
  const std::string name = onlySelected(session);
  const nodes::Graph& before = session.document.graph();
  const nodes::SocketSpec* output = volumeOutput(before, name);
  if (!output) return ui.messages.hint("Select a volume first.");
  const dvec2 at = nodes::findNode(before, name)->at + dvec2(0, 110);
  const std::string added = nodes::freeName(before, "Transform");
  Result<nodes::Graph> graph = nodes::addNode(before, "volume.transform", at, added);
  // In the place of each link, so that the order within inputs that take many stays.
  if (graph) {
    for (nodes::Link& link : graph->links)
      if (link.fromNode == name && link.fromSocket == output->id)
        link.fromNode = added, link.fromSocket = "volume";
    graph = nodes::connect(*graph, {name, output->id, added, "volume"});
  }
  if (tryEdit(session, ui.messages, std::move(graph), "Insert Transform")) session.document.select({added});
}

}  // namespace pileus::editor
