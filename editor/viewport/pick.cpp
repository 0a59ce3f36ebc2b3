// What a click in the picture chooses, and inserting a transform where a volume has none.
#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/app/editor.h"
#include "editor/viewport/viewport_tools.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {
namespace {

/// The node to take hold of: the nearest transform on the way up, else where it comes from.
std::string handleOf(const nodes::Graph& graph, const std::vector<std::string>& chain) {
  for (const std::string& name : chain)
    if (const nodes::Node* node = nodes::findNode(graph, name);
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

std::optional<vec2> lightMark(const Editor& editor, const PlacedLight& light, const Projection& view) {
  if (!light.target.sun) return view.screen(light.target.position);
  const dvec3 center = sunCenter(editor.viewport.tools.scene, view);
  const double metres = view.metresPerPixel(center);
  if (!(metres > 0)) return std::nullopt;
  return view.screen(center + metres * static_cast<double>(editor.theme.px(96)) *
                                  scene::sunDirection(light.target.azimuth, light.target.elevation));
}

std::string nodeAt(const Editor& editor, const Projection& view, vec2 at) {
  const ViewScene& scene = editor.viewport.tools.scene;
  if (editor.settings.view.overlays.on && editor.settings.view.overlays.lights) {
    std::string nearest;
    float best = editor.theme.px(12);
    for (const PlacedLight& light : scene.lights)
      if (const auto mark = lightMark(editor, light, view); mark && glm::length(*mark - at) < best)
        best = glm::length(*mark - at), nearest = light.node;
    if (!nearest.empty()) return nearest;
  }
  const Ray ray = view.ray(at);
  const nodes::Graph& graph = editor.document.root();
  // What is seen there, so that a cloud within a haze can be chosen; else the nearest bounds.
  const auto& picture = editor.preview.picture();
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

bool canInsertTransform(const Editor& editor) {
  const std::string name = onlySelected(editor);
  const nodes::Node* node = nodes::findNode(editor.document.graph(), name);
  return node && node->type != "volume.transform" && volumeOutput(editor.document.graph(), name);
}

void insertTransform(Editor& editor) {
  const std::string name = onlySelected(editor);
  const nodes::Graph& before = editor.document.graph();
  const nodes::SocketSpec* output = volumeOutput(before, name);
  if (!output) return editor.messages.hint("Select a volume first.");
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
  if (tryEdit(editor, std::move(graph), "Insert Transform")) editor.document.select({added});
}

}  // namespace pileus::editor
