// Commands of the viewport.
#include "editor/commands/table.h"
#include "editor/picture/shown_camera.h"

namespace pileus::editor {
namespace {

bool hasView(const Editor& e) { return !shownView(e).empty(); }

using P = Panel;

const Action kActions[] = {
    {"viewport.frame",
     "Frame Selection",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_F)},
     frameSelected,
     hasView,
     nullptr,
     true},
    {"viewport.frame_all",
     "Frame Volumes",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_A), plain(GLFW_KEY_HOME)},
     frameVolumes,
     hasView},
    {"viewport.reset_camera",
     "Reset Free Camera",
     "View",
     P::Viewport,
     {},
     [](Editor& e) { e.viewport.freeCamera.reset(); },
     hasView},
    {"viewport.exposure_up",
     "Exposure +0.5",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_RIGHT_BRACKET)},
     [](Editor& e) { changeExposure(e, 0.5); },
     hasView},
    {"viewport.exposure_down",
     "Exposure -0.5",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_LEFT_BRACKET)},
     [](Editor& e) { changeExposure(e, -0.5); },
     hasView},
    {"viewport.exposure_reset",
     "Reset Exposure",
     "View",
     P::Viewport,
     {ctrl(GLFW_KEY_R)},
     resetExposure,
     hasView},
    {"viewport.compare",
     "Compare with Truth",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_TAB)},
     toggleCompare,
     hasView,
     [](const Editor& e) { return e.compare.on; },
     true},
    {"viewport.wipe",
     "Wipe",
     "View",
     P::Viewport,
     {shift(GLFW_KEY_W)},
     toggleWipe,
     hasView,
     [](const Editor& e) { return e.compare.on && e.compare.layout == CompareLayout::Wipe; }},
    {"viewport.error",
     "Error in False Colours",
     "View",
     P::Viewport,
     {shift(GLFW_KEY_E)},
     toggleError,
     hasView,
     [](const Editor& e) { return e.compare.on && e.compare.layout == CompareLayout::Error; }},
    {"viewport.pick_ray",
     "Pick Light Ray",
     "View",
     P::Viewport,
     {plain(GLFW_KEY_S)},
     togglePicking,
     hasView,
     [](const Editor& e) { return e.scope.picking; }},
};

}  // namespace

std::span<const Action> viewportActions() { return kActions; }

}  // namespace pileus::editor
