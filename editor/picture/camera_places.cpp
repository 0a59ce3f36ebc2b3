#include "editor/picture/camera_places.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/gizmo_math.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/picture/view_scene.h"
#include "editor/preferences/settings.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kFiles = 50;

const CameraPlaces* placesOf(const Session& session, const Settings& settings) {
  for (const CameraPlaces& p : settings.view.cameras)
    if (p.path == session.document.path().string()) return &p;
  return nullptr;
}

}  // namespace

void saveCameraPlace(Messages& messages, const Session& session, const Clock& clock, const Shown& shown,
                     Settings& settings, int number) {
  std::vector<CameraPlaces>& all = settings.view.cameras;
  CameraPlaces ours{session.document.path().string(), {}};
  if (const CameraPlaces* known = placesOf(session, settings)) ours = *known;
  std::erase_if(all, [&](const CameraPlaces& p) { return p.path == ours.path; });
  ours.places.at(static_cast<std::size_t>(number - 1)) = currentCamera(session, clock, shown);
  all.insert(all.begin(), std::move(ours));
  if (all.size() > kFiles) all.resize(kFiles);
  messages.note(fmt::format("Camera {} saved: Ctrl+{} over the viewport comes back here", number, number));
}

bool hasCameraPlace(const Session& session, const Settings& settings, int number) {
  const CameraPlaces* ours = placesOf(session, settings);
  return ours && ours->places.at(static_cast<std::size_t>(number - 1));
}

void goToCameraPlace(Messages& messages, Session& session, Clock& clock, Shown& shown,
                     const Settings& settings, int number) {
  if (!hasCameraPlace(session, settings, number))
    return messages.hint(
        fmt::format("Camera {} is free: Ctrl+Shift+{} over the viewport saves this view.", number, number));
  scene::Camera camera = *placesOf(session, settings)->places.at(static_cast<std::size_t>(number - 1));
  setCamera(messages, session, clock, shown, camera, fmt::format("Go to camera {}", number), {});
}

void cameraPlacesFollow(Settings& settings, const std::string& from, const std::string& to) {
  if (from == to) return;
  std::vector<CameraPlaces>& all = settings.view.cameras;
  std::optional<CameraPlaces> ours;
  for (const CameraPlaces& p : all)
    if (p.path == from) ours = p;
  std::erase_if(all, [&](const CameraPlaces& p) { return p.path.empty() || (ours && p.path == to); });
  if (!ours) return;
  ours->path = to;
  all.insert(all.begin(), std::move(*ours));
}

bool hasLinkedCamera(const Session& session, const Shown& shown) {
  return !linkedCamera(session, shownView(session, shown)).empty();
}

void cameraFromView(Messages& messages, Session& session, const Clock& clock, const Shown& shown) {
  const std::string user = cameraUser(session, shownView(session, shown)), input = cameraInput(session, user);
  if (input.empty()) return messages.hint("Nothing that is shown takes a camera.");
  const scene::Camera camera = currentCamera(session, clock, shown);
  const nodes::Graph& root = session.document.root();
  // It stands beside what is seen through it, in the same group.
  const nodes::NodeAt at = nodes::nodeAt(user);
  const nodes::Graph& before = *nodes::graphAt(root, at.scope);
  const double scale = glm::length(camera.eye - camera.target);
  const std::string name = nodes::freeName(before, "Camera");
  Result<nodes::Graph> graph = nodes::addNode(before, "camera.perspective",
                                              nodes::findNode(before, at.name)->at + dvec2(-280, 120), name);
  if (graph) graph = nodes::setParam(*graph, name, "eye", tidy(camera.eye, scale));
  if (graph) graph = nodes::setParam(*graph, name, "target", tidy(camera.target, scale));
  if (graph) graph = nodes::setParam(*graph, name, "up", camera.up);
  if (graph) graph = nodes::setParam(*graph, name, "fov", tidy(camera.fov, 100));
  if (graph) graph = nodes::connect(*graph, {name, "camera", at.name, input});
  if (graph) graph = nodes::withGraphAt(root, at.scope, std::move(*graph));
  const std::string shownAs = shownInScope(session, at.path(name));
  if (tryEditRoot(session, messages, std::move(graph), "Camera from view") && shownAs == name)
    session.document.select({name});
}

void unlinkCamera(Messages& messages, Session& session, const Clock& clock, Shown& shown) {
  const std::string user = cameraUser(session, shownView(session, shown)), input = cameraInput(session, user);
  if (input.empty()) return;
  // The view stays where it is.
  shown.freeCamera = currentCamera(session, clock, shown);
  shown.around = {};
  tryEditRoot(session, messages, nodes::unlinked(session.document.root(), user, input), "Unlink camera");
}

}  // namespace pileus::editor
