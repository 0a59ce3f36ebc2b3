#include "editor/picture/camera_places.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/app/editor.h"
#include "editor/picture/shown_camera.h"
#include "editor/viewport/handles/gizmo_math.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kFiles = 50;

const CameraPlaces* placesOf(const Editor& editor) {
  for (const CameraPlaces& p : editor.settings.view.cameras)
    if (p.path == editor.document.path().string()) return &p;
  return nullptr;
}

const nodes::SocketSpec* cameraInput(const Editor& editor, const std::string& user) {
  const nodes::Node* node = nodes::findNode(editor.document.root(), user);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (type)
    for (const nodes::SocketSpec& s : type->inputs)
      if (s.type == nodes::SocketType::Camera) return &s;
  return nullptr;
}

}  // namespace

void saveCameraPlace(Editor& editor, int number) {
  std::vector<CameraPlaces>& all = editor.settings.view.cameras;
  CameraPlaces ours{editor.document.path().string(), {}};
  if (const CameraPlaces* known = placesOf(editor)) ours = *known;
  std::erase_if(all, [&](const CameraPlaces& p) { return p.path == ours.path; });
  ours.places.at(static_cast<std::size_t>(number - 1)) = currentCamera(editor);
  all.insert(all.begin(), std::move(ours));
  if (all.size() > kFiles) all.resize(kFiles);
  editor.messages.note(
      fmt::format("Camera {} saved: Ctrl+{} over the viewport comes back here", number, number));
}

bool hasCameraPlace(const Editor& editor, int number) {
  const CameraPlaces* ours = placesOf(editor);
  return ours && ours->places.at(static_cast<std::size_t>(number - 1));
}

void goToCameraPlace(Editor& editor, int number) {
  if (!hasCameraPlace(editor, number))
    return editor.messages.hint(
        fmt::format("Camera {} is free: Ctrl+Shift+{} over the viewport saves this view.", number, number));
  scene::Camera camera = *placesOf(editor)->places.at(static_cast<std::size_t>(number - 1));
  setCamera(editor, camera, fmt::format("Go to camera {}", number), {});
}

void cameraPlacesFollow(Editor& editor, const std::string& from, const std::string& to) {
  if (from == to) return;
  std::vector<CameraPlaces>& all = editor.settings.view.cameras;
  std::optional<CameraPlaces> ours;
  for (const CameraPlaces& p : all)
    if (p.path == from) ours = p;
  std::erase_if(all, [&](const CameraPlaces& p) { return p.path.empty() || (ours && p.path == to); });
  if (!ours) return;
  ours->path = to;
  all.insert(all.begin(), std::move(*ours));
}

bool hasLinkedCamera(const Editor& editor) { return !linkedCamera(editor, shownView(editor)).empty(); }

void cameraFromView(Editor& editor) {
  const std::string user = cameraUser(editor, shownView(editor));
  const nodes::SocketSpec* input = cameraInput(editor, user);
  if (!input) return editor.messages.hint("Nothing that is shown takes a camera.");
  const scene::Camera camera = currentCamera(editor);
  const nodes::Graph& before = editor.document.root();
  const double scale = glm::length(camera.eye - camera.target);
  const std::string name = nodes::freeName(before, "Camera");
  Result<nodes::Graph> graph = nodes::addNode(before, "camera.perspective",
                                              nodes::findNode(before, user)->at + dvec2(-280, 120), name);
  if (graph) graph = nodes::setParam(*graph, name, "eye", tidy(camera.eye, scale));
  if (graph) graph = nodes::setParam(*graph, name, "target", tidy(camera.target, scale));
  if (graph) graph = nodes::setParam(*graph, name, "up", camera.up);
  if (graph) graph = nodes::setParam(*graph, name, "fov", tidy(camera.fov, 100));
  if (graph) graph = nodes::connect(*graph, {name, "camera", user, input->id});
  if (tryEditRoot(editor, std::move(graph), "Camera from view") && editor.document.scope().empty())
    editor.document.select({name});
}

void unlinkCamera(Editor& editor) {
  const std::string user = cameraUser(editor, shownView(editor));
  const nodes::SocketSpec* input = cameraInput(editor, user);
  if (!input) return;
  // The view stays where it is.
  editor.viewport.freeCamera = currentCamera(editor);
  nodes::Graph graph = editor.document.root();
  std::erase_if(graph.links,
                [&](const nodes::Link& l) { return l.toNode == user && l.toSocket == input->id; });
  tryEditRoot(editor, std::move(graph), "Unlink camera");
}

}  // namespace pileus::editor
