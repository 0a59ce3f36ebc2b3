// Commands of help.
#include "editor/actions/table.h"

namespace pileus::editor {
namespace {

using P = Panel;

const Action kActions[] = {
    {"help.shortcuts",
     "Keyboard and Mouse",
     "Help",
     P::Global,
     {plain(GLFW_KEY_F1)},
     [](Editor& e) { e.dialogs.shortcuts = true; }},
    {"help.about", "About Pileus", "Help", P::Global, {}, [](Editor& e) { e.dialogs.about = true; }},
};

}  // namespace

std::span<const Action> helpActions() { return kActions; }

}  // namespace pileus::editor
