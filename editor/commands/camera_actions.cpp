// Commands of the viewport's camera, gizmos and overlays.
#include "editor/commands/table.h"
#include "editor/picture/camera_places.h"
#include "editor/picture/light_view.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/viewport/handles/shadow_place.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {
namespace {

bool hasView(const Editor& e) { return !shownView(e.session, e.shown).empty(); }
bool freeView(const Editor& e) { return hasView(e) && !hasLinkedCamera(e.session, e.shown); }

bool looksAround(const Editor& e) { return aroundCamera(e.session, e.shown).has_value(); }

template <GizmoMode M>
void tool(Editor& e) {
  setGizmoMode(e.viewport, M);
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
  goToCameraPlace(e.messages, e.session, e.clock, e.shown, e.settings, N);
}
template <int N>
void keep(Editor& e) {
  saveCameraPlace(e.messages, e.session, e.clock, e.shown, e.settings, N);
}
template <int N>
bool kept(const Editor& e) {
  return hasCameraPlace(e.session, e.settings, N);
}

using P = Panel;
using N = NavigationPreset;
using G = GizmoMode;
constexpr const char* kCameras = "View/Cameras";
constexpr const char* kNavigation = "View/Navigation";
constexpr const char* kTools = "View/Tools";
constexpr const char* kOverlays = "View/Overlays";

#define PILEUS_GO(n)                                                                              \
  {                                                                                               \
    .id = "viewport.go_" #n, .label = "Go to Camera " #n, .menu = kCameras, .panel = P::Viewport, \
    .keys = {ctrl(GLFW_KEY_0 + n)}, .run = go<n>, .checked = kept<n>, .separator = n == 1         \
  }
#define PILEUS_KEEP(n)                                                           \
  {                                                                              \
    .id = "viewport.save_" #n, .label = "Save Camera " #n, .panel = P::Viewport, \
    .keys = {ctrlShift(GLFW_KEY_0 + n)}, .run = keep<n>, .enabled = hasView      \
  }

const Action kActions[] = {
    {.id = "viewport.camera_from_view",
     .label = "Camera from View",
     .menu = kCameras,
     .panel = P::Viewport,
     .run = [](Editor& e) { cameraFromView(e.messages, e.session, e.clock, e.shown); },
     .enabled = freeView},
    {.id = "viewport.unlink_camera",
     .label = "Unlink Camera",
     .menu = kCameras,
     .panel = P::Viewport,
     .run = [](Editor& e) { unlinkCamera(e.messages, e.session, e.clock, e.shown); },
     .enabled = [](const Editor& e) { return hasLinkedCamera(e.session, e.shown); }},
    {.id = "viewport.lock_camera",
     .label = "Lock Camera",
     .menu = kCameras,
     .panel = P::Viewport,
     .run = [](Editor& e) { toggleCameraLock(e.messages, e.session, e.clock, e.shown); },
     .enabled = [](const Editor& e) { return hasLinkedCamera(e.session, e.shown); },
     .checked = [](const Editor& e) { return cameraLocked(e.session, e.clock, e.shown); }},
    {.id = "viewport.back_to_camera",
     .label = "Back to Camera",
     .menu = kCameras,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_BACKSPACE)},
     .run = [](Editor& e) { backToCamera(e.shown); },
     .enabled = looksAround},
    {.id = "viewport.camera_to_view",
     .label = "Move Camera Here",
     .menu = kCameras,
     .panel = P::Viewport,
     .run = [](Editor& e) { cameraToView(e.messages, e.session, e.clock, e.shown); },
     .enabled = looksAround},
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
    {.id = "viewport.navigation_maya",
     .label = "Navigate like Maya",
     .menu = kNavigation,
     .panel = P::Global,
     .run = navigate<N::Maya>,
     .checked = navigates<N::Maya>},
    {.id = "viewport.navigation_blender",
     .label = "Navigate like Blender",
     .menu = kNavigation,
     .panel = P::Global,
     .run = navigate<N::Blender>,
     .checked = navigates<N::Blender>},
    {.id = "viewport.navigation_houdini",
     .label = "Navigate like Houdini",
     .menu = kNavigation,
     .panel = P::Global,
     .run = navigate<N::Houdini>,
     .checked = navigates<N::Houdini>},
    {.id = "viewport.select",
     .label = "Select",
     .menu = kTools,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_Q)},
     .run = tool<G::Select>,
     .checked = toolIs<G::Select>},
    {.id = "viewport.move",
     .label = "Move",
     .menu = kTools,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_W)},
     .run = tool<G::Move>,
     .checked = toolIs<G::Move>},
    {.id = "viewport.rotate",
     .label = "Rotate",
     .menu = kTools,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_E)},
     .run = tool<G::Rotate>,
     .checked = toolIs<G::Rotate>},
    {.id = "viewport.scale",
     .label = "Scale",
     .menu = kTools,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_R)},
     .run = tool<G::Scale>,
     .checked = toolIs<G::Scale>},
    {.id = "viewport.local_axes",
     .label = "Local Axes",
     .menu = kTools,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_X)},
     .run = [](Editor& e) { e.settings.view.localAxes = !e.settings.view.localAxes; },
     .checked = [](const Editor& e) { return e.settings.view.localAxes; }},
    {.id = "viewport.insert_transform",
     .label = "Insert Transform",
     .menu = kTools,
     .panel = P::Viewport,
     .run = [](Editor& e) { insertTransform(e.ui, e.session); },
     .enabled = [](const Editor& e) { return canInsertTransform(e.session); },
     .separator = true},
    {.id = "viewport.place_shadow",
     .label = "Place Light by Its Shadow",
     .menu = kTools,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_V)},
     .run = [](Editor& e) { placeByShadow(e.viewportRoom); },
     .enabled = hasView},
    {.id = "viewport.through_light",
     .label = "Look through Light",
     .menu = kTools,
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_L)},
     .run = [](Editor& e) { lookThroughLight(e.messages, e.session, e.clock, e.shown); },
     .enabled = hasView,
     .checked = [](const Editor& e) { return !e.shown.look.light.empty(); }},
    {.id = "viewport.overlays",
     .label = "Show Overlays",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::on>,
     .checked = shows<&Overlays::on>},
    {.id = "viewport.show_bounds",
     .label = "Bounds of Volumes",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::bounds>,
     .checked = shows<&Overlays::bounds>,
     .separator = true},
    {.id = "viewport.show_bricks",
     .label = "Bricks",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::bricks>,
     .checked = shows<&Overlays::bricks>},
    {.id = "viewport.show_lights",
     .label = "Lights",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::lights>,
     .checked = shows<&Overlays::lights>},
    {.id = "viewport.show_solids",
     .label = "Outlines of Solids",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::solids>,
     .checked = shows<&Overlays::solids>},
    {.id = "viewport.show_grid",
     .label = "Ground Grid",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::grid>,
     .checked = shows<&Overlays::grid>},
    {.id = "viewport.show_safe_frame",
     .label = "Safe Frame",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::safeFrame>,
     .checked = shows<&Overlays::safeFrame>},
    {.id = "viewport.show_axes",
     .label = "Axis Cross",
     .menu = kOverlays,
     .panel = P::Viewport,
     .run = toggle<&Overlays::axes>,
     .checked = shows<&Overlays::axes>},
};
#undef PILEUS_GO
#undef PILEUS_KEEP

}  // namespace

std::span<const Action> cameraActions() { return kActions; }

}  // namespace pileus::editor
