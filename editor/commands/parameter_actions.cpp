// Commands of the parameter panel: they act on the row under the pointer, or on the nodes shown.
#include "editor/commands/table.h"
#include "editor/parameters/parameters.h"

namespace pileus::editor {
namespace {

/// On a copy of the target: the edit may draw the rows anew.
void onRow(Editor& e, void (*run)(Editor& e, const ParamTarget& target)) {
  if (const ParamTarget* target = hoveredParam(e.now, e.parameters)) run(e, ParamTarget(*target));
}
bool overRow(const Editor& e) { return e.parameters.hovered.has_value(); }
bool showsNodes(const Editor& e) { return !shownNodes(e.session, e.parameters).empty(); }

using P = Panel;

const Action kActions[] = {
    {.id = "param.reset",
     .label = "Reset to Default",
     .panel = P::Parameters,
     .keys = {plain(GLFW_KEY_BACKSPACE)},
     .run =
         [](Editor& e) {
           onRow(e, [](Editor& o, const ParamTarget& target) { resetParam(o.ui, o.session, target); });
         },
     .enabled = overRow},
    {.id = "param.key",
     .label = "Set or Remove Key",
     .panel = P::Parameters,
     .keys = {plain(GLFW_KEY_I)},
     .run =
         [](Editor& e) {
           onRow(e,
                 [](Editor& o, const ParamTarget& target) { toggleKey(o.ui, o.session, o.clock, target); });
         },
     .enabled = overRow},
    {.id = "param.expose",
     .label = "Expose as Input",
     .panel = P::Parameters,
     .run =
         [](Editor& e) {
           onRow(e, [](Editor& o, const ParamTarget& target) {
             toggleExposed(o.ui, o.session, o.clock, target);
           });
         },
     .enabled = overRow},
    {.id = "params.paste_values",
     .label = "Paste Values of Copied Node",
     .menu = "Edit",
     .panel = P::Parameters,
     .keys = {ctrlShift(GLFW_KEY_V)},
     .run = [](Editor& e) { pasteValues(e.ui, e.session, e.clock, shownNodes(e.session, e.parameters)); },
     .enabled = showsNodes},
    {.id = "params.reset_all",
     .label = "Reset All Parameters",
     .menu = "Edit",
     .panel = P::Parameters,
     .run = [](Editor& e) { resetNodes(e.ui, e.session, shownNodes(e.session, e.parameters)); },
     .enabled = showsNodes},
    {.id = "params.only_modified",
     .label = "Show Only Modified Parameters",
     .menu = "View",
     .panel = P::Parameters,
     .run = [](Editor& e) { e.parameters.onlyModified ^= true; },
     .checked = [](const Editor& e) { return e.parameters.onlyModified; }},
    {.id = "params.pin",
     .label = "Pin Parameters",
     .menu = "View",
     .panel = P::Parameters,
     .run =
         [](Editor& e) {
           const std::vector<std::string> names = shownNodes(e.session, e.parameters);
           e.parameters.pinned = e.parameters.pinned.empty() && names.size() == 1 ? names.front() : "";
         },
     .enabled = showsNodes,
     .checked = [](const Editor& e) { return !e.parameters.pinned.empty(); }},
};

}  // namespace

std::span<const Action> parameterActions() { return kActions; }

}  // namespace pileus::editor
