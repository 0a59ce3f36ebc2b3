// Commands of the window and its panels.
#include "editor/commands/table.h"

namespace pileus::editor {
namespace {

using P = Panel;

const Action kActions[] = {
    {"view.pause",
     "Pause Refinement",
     "View",
     P::Global,
     {plain(GLFW_KEY_ESCAPE)},
     [](Editor& e) { e.preview.pause(!e.preview.paused()); },
     nullptr,
     [](const Editor& e) { return e.preview.paused(); },
     true},
    {"view.times",
     "Show Node Times",
     "View",
     P::Global,
     {},
     [](Editor& e) { e.settings.showTimes = !e.settings.showTimes; },
     nullptr,
     [](const Editor& e) { return e.settings.showTimes; }},
    {"view.shootout",
     "Shoot-out",
     "View",
     P::Global,
     {plain(GLFW_KEY_F6)},
     toggleShootout,
     nullptr,
     [](const Editor& e) { return e.settings.showLab && e.lab.tab == LabTab::Shootout; }},
    {"view.tune",
     "Tune Shadows",
     "View",
     P::Global,
     {plain(GLFW_KEY_F7)},
     toggleTune,
     nullptr,
     [](const Editor& e) { return e.settings.showLab && e.lab.tab == LabTab::Tune; }},
    {"view.theme",
     "Light Theme",
     "View",
     P::Global,
     {},
     [](Editor& e) {
       e.settings.theme = e.settings.theme == Appearance::Light ? Appearance::Dark : Appearance::Light;
     },
     nullptr,
     [](const Editor& e) { return e.settings.theme == Appearance::Light; },
     true},
};

}  // namespace

std::span<const Action> viewActions() { return kActions; }

}  // namespace pileus::editor
