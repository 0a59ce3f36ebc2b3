// Commands that change how the viewport shows its picture.
#include "editor/commands/table.h"
#include "editor/picture/display_mode.h"
#include "editor/picture/shown.h"
#include "editor/picture/snapshots.h"
#include "editor/preferences/settings.h"
#include "editor/viewport/inspector.h"

namespace pileus::editor {
namespace {

using P = Panel;
using C = view::Channel;

bool hasPicture(const Editor& e) { return e.shown.preview.picture() != nullptr; }
template <C channel>
void toggle(Editor& e) {
  toggleChannel(e.shown, channel);
}
template <C channel>
bool shows(const Editor& e) {
  return e.shown.mode.channel == channel;
}

const Action kActions[] = {
    {.id = "viewport.red",
     .label = "Red Channel",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_R)},
     .run = toggle<C::Red>,
     .checked = shows<C::Red>,
     .separator = true},
    {.id = "viewport.green",
     .label = "Green Channel",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_G)},
     .run = toggle<C::Green>,
     .checked = shows<C::Green>},
    {.id = "viewport.blue",
     .label = "Blue Channel",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_B)},
     .run = toggle<C::Blue>,
     .checked = shows<C::Blue>},
    {.id = "viewport.alpha",
     .label = "Alpha Channel",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_A)},
     .run = toggle<C::Alpha>,
     .checked = shows<C::Alpha>},
    {.id = "viewport.luminance",
     .label = "Luminance",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_L)},
     .run = toggle<C::Luminance>,
     .checked = shows<C::Luminance>},
    {.id = "viewport.layer_previous",
     .label = "Previous Layer",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_PAGE_UP)},
     .run = [](Editor& e) { stepLayer(e.messages, e.shown, -1); }},
    {.id = "viewport.layer_next",
     .label = "Next Layer",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_PAGE_DOWN)},
     .run = [](Editor& e) { stepLayer(e.messages, e.shown, 1); }},
    {.id = "viewport.raw",
     .label = "Raw, without View Transform",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_O)},
     .run = [](Editor& e) { toggleRaw(e.messages, e.shown); },
     .checked = [](const Editor& e) { return e.shown.mode.raw; },
     .separator = true},
    {.id = "viewport.false_color",
     .label = "False Colours of Exposure",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_F)},
     .run = [](Editor& e) { toggleFalseColor(e.shown); },
     .checked = [](const Editor& e) { return e.shown.mode.falseColor; }},
    {.id = "viewport.zebra",
     .label = "Mark Clipped Pixels",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_Z)},
     .run = [](Editor& e) { toggleZebra(e.shown); },
     .checked = [](const Editor& e) { return e.shown.mode.zebra; }},
    {.id = "viewport.inspector",
     .label = "Pixel Inspector",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {plain(GLFW_KEY_P)},
     .run = [](Editor& e) { toggleInspector(e.settings, e.viewport); },
     .checked = [](const Editor& e) { return e.settings.showInspector; },
     .separator = true},
    {.id = "viewport.histogram",
     .label = "Histogram",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_P)},
     .run = [](Editor& e) { e.settings.showHistogram = !e.settings.showHistogram; },
     .checked = [](const Editor& e) { return e.settings.showHistogram; }},
    {.id = "viewport.hud",
     .label = "Render Figures",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_I)},
     .run = [](Editor& e) { e.settings.showHud = !e.settings.showHud; },
     .checked = [](const Editor& e) { return e.settings.showHud; }},
    {.id = "viewport.region",
     .label = "Draw Render Region",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_C)},
     .run = [](Editor& e) { drawRegion(e.messages, e.shown); },
     .enabled = hasPicture,
     .checked = [](const Editor& e) { return e.shown.mode.region.drawing; },
     .separator = true},
    {.id = "viewport.region_toggle",
     .label = "Render Region Only",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {alt(GLFW_KEY_C)},
     .run = [](Editor& e) { toggleRegion(e.messages, e.shown); },
     .enabled = hasPicture,
     .checked = [](const Editor& e) { return e.shown.mode.region.on; }},
    {.id = "viewport.snapshot",
     .label = "Keep Still",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_ENTER)},
     .run = [](Editor& e) { takeSnapshot(e.messages, e.session, e.shown); },
     .enabled = hasPicture,
     .separator = true},
    {.id = "viewport.snapshot_wipe",
     .label = "Wipe Against Still",
     .menu = "View",
     .panel = P::Viewport,
     .keys = {shift(GLFW_KEY_Q)},
     .run = [](Editor& e) { toggleSnapshotWipe(e.messages, e.shown); },
     .enabled = [](const Editor& e) { return !e.shown.snapshots.all.empty(); },
     .checked = [](const Editor& e) { return e.shown.snapshots.wiping; }},
};

}  // namespace

std::span<const Action> displayActions() { return kActions; }

}  // namespace pileus::editor
