// Commands of the viewport's camera, gizmos and overlays.
#include "editor/commands/table.h"
#include "editor/picture/camera_places.h"
#include "editor/picture/shadow_place.h"
#include "editor/picture/shown_camera.h"

namespace pileus::editor {
namespace {

bool hasView(const Editor& e) { return !shownView(e).empty(); }
bool freeView(const Editor& e) { return hasView(e) && !hasLinkedCamera(e); }

template <GizmoMode M>
void tool(Editor& e) {
  setGizmoMode(e, M);
}
template <GizmoMode M>
bool toolIs(const Editor& e) {
  return e.viewport.tools.mode == M;
}
template <NavigationPreset N>
void navigate(Editor& e) {
  e.settings.view.navigation = N;
}
template <NavigationPreset N>
bool navigates(const Editor& e) {
  return e.settings.view.navigation == N;
}
template <bool Overlays::*O>
void toggle(Editor& e) {
  e.settings.view.overlays.*O = !(e.settings.view.overlays.*O);
}
template <bool Overlays::*O>
bool shows(const Editor& e) {
  return e.settings.view.overlays.*O;
}
template <int N>
void go(Editor& e) {
  goToCameraPlace(e, N);
}
template <int N>
void keep(Editor& e) {
  saveCameraPlace(e, N);
}
template <int N>
bool kept(const Editor& e) {
  return hasCameraPlace(e, N);
}

using P = Panel;
using N = NavigationPreset;
using G = GizmoMode;
constexpr const char* kCameras = "View/Cameras";
constexpr const char* kNavigation = "View/Navigation";
constexpr const char* kTools = "View/Tools";
constexpr const char* kOverlays = "View/Overlays";

#define PILEUS_GO(n)                                                                                      \
  {                                                                                                       \
    "viewport.go_" #n, "Go to Camera " #n, kCameras, P::Viewport, {ctrl(GLFW_KEY_0 + n)}, go<n>, nullptr, \
        kept<n>, n == 1                                                                                   \
  }
#define PILEUS_KEEP(n) \
  { "viewport.save_" #n, "Save Camera " #n, "", P::Viewport, {ctrlShift(GLFW_KEY_0 + n)}, keep<n>, hasView }

const Action kActions[] = {
    {"viewport.camera_from_view", "Camera from View", kCameras, P::Viewport, {}, cameraFromView, freeView},
    {"viewport.unlink_camera", "Unlink Camera", kCameras, P::Viewport, {}, unlinkCamera, hasLinkedCamera},
    PILEUS_GO(1),
    PILEUS_GO(2),
    PILEUS_GO(3),
    PILEUS_GO(4),
    PILEUS_GO(5),
    PILEUS_GO(6),
    PILEUS_GO(7),
    PILEUS_GO(8),
    PILEUS_GO(9),
    PILEUS_KEEP(1),
    PILEUS_KEEP(2),
    PILEUS_KEEP(3),
    PILEUS_KEEP(4),
    PILEUS_KEEP(5),
    PILEUS_KEEP(6),
    PILEUS_KEEP(7),
    PILEUS_KEEP(8),
    PILEUS_KEEP(9),
    {"viewport.navigation_maya",
     "Navigate like Maya",
     kNavigation,
     P::Global,
     {},
     navigate<N::Maya>,
     nullptr,
     navigates<N::Maya>},
    {"viewport.navigation_blender",
     "Navigate like Blender",
     kNavigation,
     P::Global,
     {},
     navigate<N::Blender>,
     nullptr,
     navigates<N::Blender>},
    {"viewport.navigation_houdini",
     "Navigate like Houdini",
     kNavigation,
     P::Global,
     {},
     navigate<N::Houdini>,
     nullptr,
     navigates<N::Houdini>},
    {"viewport.select",
     "Select",
     kTools,
     P::Viewport,
     {plain(GLFW_KEY_Q)},
     tool<G::Select>,
     nullptr,
     toolIs<G::Select>},
    {"viewport.move",
     "Move",
     kTools,
     P::Viewport,
     {plain(GLFW_KEY_W)},
     tool<G::Move>,
     nullptr,
     toolIs<G::Move>},
    {"viewport.rotate",
     "Rotate",
     kTools,
     P::Viewport,
     {plain(GLFW_KEY_E)},
     tool<G::Rotate>,
     nullptr,
     toolIs<G::Rotate>},
    {"viewport.scale",
     "Scale",
     kTools,
     P::Viewport,
     {plain(GLFW_KEY_R)},
     tool<G::Scale>,
     nullptr,
     toolIs<G::Scale>},
    {"viewport.local_axes",
     "Local Axes",
     kTools,
     P::Viewport,
     {plain(GLFW_KEY_X)},
     [](Editor& e) { e.settings.view.localAxes = !e.settings.view.localAxes; },
     nullptr,
     [](const Editor& e) { return e.settings.view.localAxes; }},
    {"viewport.insert_transform",
     "Insert Transform",
     kTools,
     P::Viewport,
     {},
     insertTransform,
     canInsertTransform,
     nullptr,
     true},
    {"viewport.place_shadow",
     "Place Light by Its Shadow",
     kTools,
     P::Viewport,
     {plain(GLFW_KEY_V)},
     placeByShadow,
     hasView},
    {"viewport.through_light",
     "Look through Light",
     kTools,
     P::Viewport,
     {plain(GLFW_KEY_L)},
     lookThroughLight,
     hasView,
     [](const Editor& e) { return !e.viewport.tools.look.light.empty(); }},
    {"viewport.overlays",
     "Show Overlays",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::on>,
     nullptr,
     shows<&Overlays::on>},
    {"viewport.show_bounds",
     "Bounds of Volumes",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::bounds>,
     nullptr,
     shows<&Overlays::bounds>,
     true},
    {"viewport.show_bricks",
     "Bricks",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::bricks>,
     nullptr,
     shows<&Overlays::bricks>},
    {"viewport.show_lights",
     "Lights",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::lights>,
     nullptr,
     shows<&Overlays::lights>},
    {"viewport.show_solids",
     "Outlines of Solids",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::solids>,
     nullptr,
     shows<&Overlays::solids>},
    {"viewport.show_grid",
     "Ground Grid",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::grid>,
     nullptr,
     shows<&Overlays::grid>},
    {"viewport.show_safe_frame",
     "Safe Frame",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::safeFrame>,
     nullptr,
     shows<&Overlays::safeFrame>},
    {"viewport.show_axes",
     "Axis Cross",
     kOverlays,
     P::Viewport,
     {},
     toggle<&Overlays::axes>,
     nullptr,
     shows<&Overlays::axes>},
};
#undef PILEUS_GO
#undef PILEUS_KEEP

}  // namespace

std::span<const Action> cameraActions() { return kActions; }

}  // namespace pileus::editor
