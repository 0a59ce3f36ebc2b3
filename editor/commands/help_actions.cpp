// Commands of help.
#include "editor/commands/table.h"

namespace pileus::editor {
namespace {

using P = Panel;

const Action kActions[] = {
    {"help.start", "Start View", "Help", P::Global, {}, openStart},
    {"help.tour", "Tour", "Help", P::Global, {}, startTour},
    {"help.page", "Help on What Is Under the Pointer", "Help", P::Global, {plain(GLFW_KEY_F1)}, openHelp},
    {"help.commands",
     "Search Commands\xe2\x80\xa6",
     "Help",
     P::Global,
     {plain(GLFW_KEY_F3), ctrl(GLFW_KEY_P)},
     [](Editor& e) { e.commands.opening = true; },
     nullptr,
     nullptr,
     true,
     true},
    {"help.shortcuts",
     "Keyboard and Mouse",
     "Help",
     P::Global,
     {shift(GLFW_KEY_F1)},
     [](Editor& e) { e.dialogs.shortcuts = true; }},
    {"help.about", "About Pileus", "Help", P::Global, {}, [](Editor& e) { e.dialogs.about = true; }},
};

}  // namespace

std::span<const Action> helpActions() { return kActions; }

}  // namespace pileus::editor
