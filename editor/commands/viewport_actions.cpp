// Commands of the viewport.
#include "editor/commands/table.h"
#include "editor/picture/compare_mode.h"
#include "editor/picture/ray_pick.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {
namespace {

bool hasView(const Editor& e) { return !shownView(e.session, e.shown).empty(); }

using P = Panel;

const Action kActions[] = {
    {.id = "viewport.frame",
     .label = "Frame Selection",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_F)},
     .run = [](Editor& e) { frameSelected(e.ui, e.session, e.clock, e.shown); },
     .enabled = hasView,
     .separator = true},
    {.id = "viewport.frame_all",
     .label = "Frame Volumes",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_A), plain(GLFW_KEY_HOME)},
     .run = [](Editor& e) { frameVolumes(e.messages, e.session, e.clock, e.shown); },
     .enabled = hasView},
    {.id = "viewport.reset_camera",
     .label = "Reset Free Camera",
     .menu = "View",
     .panel = P::Viewport,
     .run = [](Editor& e) { e.shown.freeCamera.reset(); },
     .enabled = hasView},
    {.id = "viewport.exposure_up",
     .label = "Exposure +0.5",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_RIGHT_BRACKET)},
     .run = [](Editor& e) { changeExposure(e.messages, e.session, e.clock, e.shown, 0.5); },
     .enabled = hasView},
    {.id = "viewport.exposure_down",
     .label = "Exposure -0.5",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_LEFT_BRACKET)},
     .run = [](Editor& e) { changeExposure(e.messages, e.session, e.clock, e.shown, -0.5); },
     .enabled = hasView},
    {.id = "viewport.exposure_reset",
     .label = "Reset Exposure",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {ctrl(GLFW_KEY_R)},
     .run = [](Editor& e) { resetExposure(e.messages, e.session, e.clock, e.shown); },
     .enabled = hasView},
    {.id = "viewport.compare",
     .label = "Compare with Truth",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_TAB)},
     .run = [](Editor& e) { toggleCompare(e.messages, e.shown); },
     .enabled = hasView,
     .checked = [](const Editor& e) { return e.shown.compare.on; },
     .separator = true},
    {.id = "viewport.wipe",
     .label = "Wipe",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_W)},
     .run = [](Editor& e) { toggleWipe(e.messages, e.shown); },
     .enabled = hasView,
     .checked =
         [](const Editor& e) { return e.shown.compare.on && e.shown.compare.layout == CompareLayout::Wipe; }},
    {.id = "viewport.error",
     .label = "Error in False Colours",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_E)},
     .run = [](Editor& e) { toggleError(e.messages, e.shown); },
     .enabled = hasView,
     .checked =
         [](const Editor& e) {
           return e.shown.compare.on && e.shown.compare.layout == CompareLayout::Error;
         }},
    {.id = "viewport.pick_ray",
     .label = "Pick Light Ray",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_S)},
     .run = [](Editor& e) { togglePicking(e.messages, e.shown, e.settings); },
     .enabled = hasView,
     .checked = [](const Editor& e) { return e.shown.ray.picking; }},
};

}  // namespace

std::span<const Action> viewportActions() { return kActions; }

}  // namespace pileus::editor
