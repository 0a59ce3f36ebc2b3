// Commands of the light mixer.
#include "editor/commands/table.h"
#include "editor/document/session.h"
#include "editor/picture/light_mixer.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

using P = Panel;

const Action kActions[] = {
    {.id = "lights.mixer",
     .label = "Mix Lights",
     .menu = "Viewport",
     .panel = P::Global,
     .run = [](Editor& e) { e.shown.mixer.on ^= true; },
     .checked = [](const Editor& e) { return e.shown.mixer.on; },
     .separator = true},
    {.id = "lights.apply",
     .label = "Apply Light Mix",
     .menu = "Viewport",
     .panel = P::Global,
     .run = [](Editor& e) { applyMix(e.session, e.shown, e.messages); },
     .enabled = [](const Editor& e) { return e.shown.mixer.writes(); }},
    {.id = "lights.reset",
     .label = "Reset Light Mix",
     .menu = "Viewport",
     .panel = P::Global,
     .run =
         [](Editor& e) {
           e.shown.mixer.channels.clear();
           e.shown.lights = {};
         },
     .enabled = [](const Editor& e) { return !e.shown.mixer.neutral() || e.shown.lights.any(); }},
};

}  // namespace

std::span<const Action> lightActions() { return kActions; }

}  // namespace pileus::editor
