// Commands of help.
#include "editor/commands/command_palette.h"
#include "editor/commands/table.h"
#include "editor/parameters/param_help.h"
#include "editor/start/start_view.h"
#include "editor/start/tour.h"
#include "editor/toolkit/modals.h"

namespace pileus::editor {
namespace {

using P = Panel;

const Action kActions[] = {
    {.id = "help.start",
     .label = "Start View",
     .menu = "Help",
     .panel = P::Global,
     .run = [](Editor& e) { openStart(e.start); }},
    {.id = "help.tour",
     .label = "Tour",
     .menu = "Help",
     .panel = P::Global,
     .run = [](Editor& e) { startTour(e.tour); }},
    {.id = "help.page",
     .label = "Help on What Is Under the Pointer",
     .menu = "Help",
     .panel = P::Global,
     .keys = {plain(GLFW_KEY_F1)},
     .run = [](Editor& e) { openHelp(e.ui, e.session, e.parameters); }},
    {.id = "help.commands",
     .label = "Search Commands\xe2\x80\xa6",
     .menu = "Help",
     .panel = P::Global,
     .keys = {plain(GLFW_KEY_F3), ctrl(GLFW_KEY_P)},
     .run = [](Editor& e) { e.commands.opening = true; },
     .separator = true,
     .whileTyping = true},
    {.id = "help.shortcuts",
     .label = "Keyboard and Mouse",
     .menu = "Help",
     .panel = P::Global,
     .keys = {shift(GLFW_KEY_F1)},
     .run = [](Editor& e) { e.modals.shortcuts = true; }},
    {.id = "help.about",
     .label = "About Pileus",
     .menu = "Help",
     .panel = P::Global,
     .run = [](Editor& e) { e.modals.about = true; }},
};

}  // namespace

std::span<const Action> helpActions() { return kActions; }

}  // namespace pileus::editor
