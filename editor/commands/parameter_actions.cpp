// Commands of the parameter panel: they act on the row under the pointer, or on the nodes shown.
#include "editor/commands/table.h"

namespace pileus::editor {
namespace {

bool overRow(const Editor& e) { return e.parameters.hovered.has_value(); }
bool showsNodes(const Editor& e) { return !shownNodes(e).empty(); }

using P = Panel;

const Action kActions[] = {
    {"param.reset",
     "Reset to Default",
     "",
     P::Parameters,
     {plain(GLFW_KEY_BACKSPACE)},
     [](Editor& e) { onHoveredParam(e, resetParam); },
     overRow},
    {"param.key",
     "Set or Remove Key",
     "",
     P::Parameters,
     {plain(GLFW_KEY_I)},
     [](Editor& e) { onHoveredParam(e, toggleKey); },
     overRow},
    {"param.expose",
     "Expose as Input",
     "",
     P::Parameters,
     {},
     [](Editor& e) { onHoveredParam(e, toggleExposed); },
     overRow},
    {"params.paste_values",
     "Paste Values of Copied Node",
     "Edit",
     P::Parameters,
     {ctrlShift(GLFW_KEY_V)},
     [](Editor& e) { pasteValues(e, shownNodes(e)); },
     showsNodes},
    {"params.reset_all",
     "Reset All Parameters",
     "Edit",
     P::Parameters,
     {},
     [](Editor& e) { resetNodes(e, shownNodes(e)); },
     showsNodes},
    {"params.only_modified",
     "Show Only Modified Parameters",
     "View",
     P::Parameters,
     {},
     [](Editor& e) { e.parameters.onlyModified ^= true; },
     nullptr,
     [](const Editor& e) { return e.parameters.onlyModified; }},
    {"params.pin",
     "Pin Parameters",
     "View",
     P::Parameters,
     {},
     [](Editor& e) {
       const std::vector<std::string> names = shownNodes(e);
       e.parameters.pinned = e.parameters.pinned.empty() && names.size() == 1 ? names.front() : "";
     },
     showsNodes,
     [](const Editor& e) { return !e.parameters.pinned.empty(); }},
};

}  // namespace

std::span<const Action> parameterActions() { return kActions; }

}  // namespace pileus::editor
