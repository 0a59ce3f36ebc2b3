#include "editor/document/vdb_scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "editor/document/daylight.h"
#include "editor/document/scene_builder.h"

namespace pileus::editor {
namespace {

using nodes::Graph;

const nodes::NodeType* typeOf(const Graph& graph, const std::string& name) {
  const nodes::Node* node = nodes::findNode(graph, name);
  return node ? nodes::findNodeType(node->type) : nullptr;
}

std::string firstRender(const Graph& graph) {
  for (const auto& [name, node] : graph.nodes)
    if (node->type == "render.volume") return name;
  return {};
}

/// Nodes that feed `name` through this input, and theirs.
std::set<std::string> upstream(const Graph& graph, const std::string& name, const std::string& socket) {
  std::set<std::string> seen;
  std::deque<std::string> queue;
  for (const nodes::Link& l : graph.links)
    if (l.toNode == name && l.toSocket == socket && !l.muted) queue.push_back(l.fromNode);
  while (!queue.empty()) {
    const std::string at = queue.front();
    queue.pop_front();
    if (!seen.insert(at).second) continue;
    for (const nodes::Link& l : graph.links)
      if (l.toNode == at && !l.muted) queue.push_back(l.fromNode);
  }
  return seen;
}

bool hasLink(const Graph& graph, const std::string& node, nodes::SocketType type) {
  const nodes::NodeType* t = typeOf(graph, node);
  for (const nodes::Link& l : graph.links) {
    if (l.toNode != node || l.muted) continue;
    const int in = t ? t->inputIndex(l.toSocket) : -1;
    if (in >= 0 && t->inputs[static_cast<std::size_t>(in)].type == type) return true;
  }
  return false;
}

/// The maps that shadow the render's lights: those whose volumes count (a map with a metric takes the
/// metric's).
void linkToShadows(SceneBuilder& build, const std::string& medium, const std::string& render) {
  for (const std::string& name : upstream(build.graph(), render, "lights")) {
    const nodes::NodeType* type = typeOf(build.graph(), name);
    if (!type || type->category != "Shadow" || hasLink(build.graph(), name, nodes::SocketType::Metric))
      continue;
    for (const nodes::SocketSpec& socket : type->inputs)
      if (socket.type == nodes::SocketType::Volume && socket.many)
        build.link(medium, "volume", name, socket.id);
  }
}

/// Large grids are marched in longer steps at first: some 512 along the longest axis.
double stepScale(std::span<const volume::VdbFit> fits) {
  double longest = 1;
  for (const volume::VdbFit& fit : fits) longest = std::max(longest, fit.longest);
  return std::clamp(std::round(longest / 256) / 2, 1.0, 4.0);
}

dvec3 tidy(const dvec3& v, double size) {
  const double step = std::pow(10.0, std::floor(std::log10(std::max(size, 1e-6))) - 4);
  return glm::round(v / step) * step;
}

scene::Camera framed(const Box3& bounds, const Graph& graph) {
  const ivec2 size = graph.settings.size;
  scene::Camera camera = scene::frameBounds(bounds, size.y > 0 ? double(size.x) / size.y : 1.0);
  const double distance = glm::length(camera.eye - camera.target);
  camera.eye = tidy(camera.eye, distance);
  camera.target = tidy(camera.target, distance);
  return camera;
}

/// Is the middle within the view, and the whole neither a dot nor around the camera?
bool inView(const scene::Camera& camera, const Box3& bounds) {
  const dvec3 view = camera.target - camera.eye, to = bounds.center() - camera.eye;
  const double distance = glm::length(to), radius = 0.5 * glm::length(bounds.size());
  if (distance <= 0 || glm::length(view) <= 0) return false;
  const double half = glm::radians(camera.fov) / 2;
  const double angle = std::acos(std::clamp(glm::dot(to, view) / (distance * glm::length(view)), -1.0, 1.0));
  const double size = std::atan(radius / distance);
  return angle < 1.3 * half && size > 0.06 * half && size < 4 * half;
}

/// What files were made into: names of nodes, and how many rows they take.
struct Added {
  std::vector<std::string> media, fires;
  double rows = 0;
};

std::string addFile(SceneBuilder& build, const volume::VdbFit& fit, double row, const std::string& name,
                    const std::string& grid) {
  const std::string file = build.add("volume.vdb_file", 0, row, name);
  build.set(file, "file", fit.file.string());
  if (!grid.empty()) build.set(file, "grid", grid);
  return file;
}

void addSmoke(SceneBuilder& build, const volume::VdbFit& fit, const std::string& name, Added& added) {
  const std::string file = addFile(build, fit, added.rows, name, fit.byDefault ? "" : fit.guess.grid);
  const std::string medium = build.add("volume.medium", 1, added.rows++, file + " Medium");
  build.set(medium, "extinction", std::min(volume::threeDigits(fit.fit.extinction), 1e6));
  build.set(medium, "albedo", dvec3(0.95));
  build.set(medium, "anisotropy", 0.2);
  build.link(file, "volume", medium, "volume");
  added.media.push_back(medium);
}

void addFire(SceneBuilder& build, const volume::VdbFit& fit, const std::string& name, Added& added) {
  const std::string file = addFile(build, fit, added.rows, name, fit.fire->grid);
  const std::string body = build.add("volume.blackbody", 1, added.rows++, file + " Black Body");
  const volume::FireRange& range = fit.fire->range;
  if (range.lowest > 0) build.set(body, "input_min", range.lowest);
  build.set(body, "input_max", range.highest);
  build.set(body, "coolest", range.body.coolest);
  build.set(body, "hottest", range.body.hottest);
  build.set(body, "strength", range.body.strength);
  build.link(file, "volume", body, "volume");
  added.fires.push_back(body);
}

Added addFiles(SceneBuilder& build, std::span<const volume::VdbFit> fits) {
  Added added;
  for (const volume::VdbFit& fit : fits) {
    const std::string name = nodeNameOf(fit.file);
    if (fit.smoke) addSmoke(build, fit, name, added);
    if (fit.fire) addFire(build, fit, fit.smoke ? name + " Fire" : name, added);
  }
  return added;
}

/// Lights for the smoke, a camera, a render and a view. Fire needs no light.
std::string addLook(SceneBuilder& build, const Added& added, std::span<const volume::VdbFit> fits,
                    const scene::Camera& camera) {
  const dvec3 back = camera.eye - camera.target;
  const double azimuth = std::round(glm::degrees(std::atan2(back.x, back.z)));
  const std::string eye = build.add("camera.perspective", 3, added.rows + 1.7, "Camera");
  build.set(eye, "eye", camera.eye);
  build.set(eye, "target", camera.target);
  build.set(eye, "fov", camera.fov);
  const std::string render = build.add("render.volume", 4, 0, "Render");
  build.set(render, "step_scale", stepScale(fits));
  for (const std::string& medium : added.media) build.link(medium, "volume", render, "volumes");
  for (const std::string& fire : added.fires) build.link(fire, "volume", render, "volumes");
  if (!added.media.empty()) addDaylight(build, added.media, azimuth - 75, {1, added.rows}, render);
  build.link(eye, "camera", render, "camera");
  const std::string view = build.add("output.view", 5, 0, "View");
  build.link(render, "image", view, "image");
  return eye;
}

std::string cameraOf(const Graph& graph, const std::string& render) {
  for (const nodes::Link& l : graph.links) {
    const nodes::Node* from = nodes::findNode(graph, l.fromNode);
    if (l.toNode == render && l.toSocket == "camera" && !l.muted && from &&
        from->type == "camera.perspective")
      return l.fromNode;
  }
  return {};
}

void explainFire(const volume::FireFit& fire, const std::string& name, std::vector<std::string>& out) {
  const volume::FireRange& range = fire.range;
  if (fire.brightness < 1)
    out.push_back(name + ": smoke hides most of the fire; lower its extinction to see more");
  out.push_back(fmt::format("{}: grid '{}' glows {} ({})", name, fire.grid, fire.why,
                            volume::confidenceText(fire.confidence)));
  out.push_back(fmt::format(
      "{}: values {:.3g} to {:.3g} are {:.4g} to {:.4g} K ({}), strength {:.3g} W/(m^3 sr), so that its "
      "brighter parts reach a radiance of {:.2g}",
      name, range.lowest, range.highest, range.body.coolest, range.body.hottest,
      fire.kelvins ? "they are kelvins, by their size" : "a guess: they have no unit", range.body.strength,
      fire.brightness));
}

}  // namespace

std::string nodeNameOf(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  if (!nodes::checkName(name)) std::replace(name.begin(), name.end(), '.', ' ');
  return name;
}

Result<VdbScene> addVdbFiles(const Graph& graph, std::span<const volume::VdbFit> fits,
                             const std::string& wanted, const std::optional<scene::Camera>& present) {
  SceneBuilder build(graph);
  const Added added = addFiles(build, fits);
  Box3 bounds;
  for (const volume::VdbFit& fit : fits)
    if (!fit.bounds.empty()) bounds.extend(fit.bounds);
  VdbScene out;
  const std::string render = nodes::findNode(graph, wanted) ? wanted : firstRender(graph);
  const scene::Camera camera = framed(bounds, graph);
  const std::string what =
      fits.size() == 1 ? fits.front().file.filename().string() : fmt::format("{} volume files", fits.size());
  if (render.empty()) {
    out.cameraNode = addLook(build, added, fits, camera);
    out.camera = camera;
    out.summary = what + (added.media.empty() ? " shown as fire alone, with a camera"
                                              : " shown under a sky, with shadows and a camera");
  } else {
    for (const std::string& medium : added.media) {
      build.link(medium, "volume", render, "volumes");
      linkToShadows(build, medium, render);
    }
    for (const std::string& fire : added.fires) build.link(fire, "volume", render, "volumes");
    out.summary = fmt::format("{} added to {}", what, render);
    if (!bounds.empty() && (!present || !inView(*present, bounds))) {
      out.cameraNode = cameraOf(graph, render);
      out.camera = camera;
      if (!out.cameraNode.empty()) {
        build.set(out.cameraNode, "eye", camera.eye);
        build.set(out.cameraNode, "target", camera.target);
      }
      out.summary += "; the camera was moved to see it";
    }
  }
  out.added = build.added();
  PILEUS_TRY(out.graph, build.finish());
  return out;
}

std::vector<std::string> explainFit(const volume::VdbFit& fit) {
  const std::string name = fit.file.filename().string();
  std::vector<std::string> out;
  out.push_back(fmt::format("{}: grid '{}' {} ({})", name, fit.guess.grid, fit.guess.why,
                            volume::confidenceText(fit.guess.confidence)));
  if (fit.smoke && fit.fit.opticalDepth > 0)
    out.push_back(
        fmt::format("{}: extinction {:.3g} 1/m, so that half of the rays through the middle meet an optical "
                    "depth above {:.0f} "
                    "(likely: densities of files have no unit)",
                    name, fit.fit.extinction, fit.fit.opticalDepth));
  else if (fit.smoke)
    out.push_back(name + ": the grid is empty in this file, so its density could not be fitted");
  if (fit.fire) explainFire(*fit.fire, name, out);
  for (const std::string& note : fit.guess.notes) out.push_back(name + ": " + note);
  if (fit.frames.count > 1)
    out.push_back(fmt::format("{}: {} frames lie beside it ({} to {}); this one is shown", name,
                              fit.frames.count, fit.frames.first, fit.frames.last));
  for (const std::string& warning : fit.warnings) out.push_back(name + ": " + warning);
  return out;
}

}  // namespace pileus::editor
