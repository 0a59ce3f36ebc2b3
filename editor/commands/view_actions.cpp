// Commands of the window and its panels.
#include "editor/commands/table.h"
#include "editor/lab/lab.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"

namespace pileus::editor {
namespace {

using P = Panel;

const Action kActions[] = {
    {.id = "view.pause",
     .label = "Pause Refinement",
     .menu = "View",
     .panel = P::Global,
     .keys = {plain(GLFW_KEY_ESCAPE)},
     .run = [](Editor& e) { e.shown.preview.pause(!e.shown.preview.paused()); },
     .checked = [](const Editor& e) { return e.shown.preview.paused(); },
     .separator = true},
    {.id = "view.times",
     .label = "Show Node Times",
     .menu = "View",
     .panel = P::Global,
     .run = [](Editor& e) { e.settings.showTimes = !e.settings.showTimes; },
     .checked = [](const Editor& e) { return e.settings.showTimes; }},
    {.id = "view.shootout",
     .label = "Shoot-out",
     .menu = "View",
     .panel = P::Global,
     .keys = {plain(GLFW_KEY_F6)},
     .run = [](Editor& e) { toggleShootout(e.settings, e.lab); },
     .checked = [](const Editor& e) { return e.settings.showLab && e.lab.tab == LabTab::Shootout; }},
    {.id = "view.tune",
     .label = "Tune Shadows",
     .menu = "View",
     .panel = P::Global,
     .keys = {plain(GLFW_KEY_F7)},
     .run = [](Editor& e) { toggleTune(e.settings, e.lab); },
     .checked = [](const Editor& e) { return e.settings.showLab && e.lab.tab == LabTab::Tune; }},
    {.id = "view.theme",
     .label = "Light Theme",
     .menu = "View",
     .panel = P::Global,
     .run =
         [](Editor& e) {
           e.settings.theme = e.settings.theme == Appearance::Light ? Appearance::Dark : Appearance::Light;
         },
     .checked = [](const Editor& e) { return e.settings.theme == Appearance::Light; },
     .separator = true},
};

}  // namespace

std::span<const Action> viewActions() { return kActions; }

}  // namespace pileus::editor
