// Commands of the graph canvas.
#include "editor/actions/table.h"
#include "editor/graph_view/canvas_commands.h"

namespace pileus::editor {
namespace {

bool hasSelection(const Editor& e) { return !e.document.selection().empty(); }
bool canDelete(const Editor& e) { return hasSelection(e) || e.canvas.selectedLink; }
bool oneSelected(const Editor& e) { return e.document.selection().size() == 1; }
bool hasNodes(const Editor& e) { return !e.document.graph().nodes.empty(); }

using P = Panel;

const Action kActions[] = {
    {"graph.duplicate",
     "Duplicate",
     "Edit",
     P::Graph,
     {ctrl(GLFW_KEY_D), shift(GLFW_KEY_D)},
     duplicateSelection,
     hasSelection},
    {"graph.delete", "Delete", "Edit", P::Graph, {plain(GLFW_KEY_DELETE)}, deleteSelection, canDelete},
    {"graph.add",
     "Add Node\xe2\x80\xa6",
     "Edit",
     P::Graph,
     {plain(GLFW_KEY_TAB), shift(GLFW_KEY_A)},
     searchNode,
     nullptr,
     nullptr,
     true},
    {"graph.bypass", "Bypass", "Edit", P::Graph, {plain(GLFW_KEY_D)}, bypassSelection, hasSelection},
    {"graph.rename",
     "Rename",
     "Edit",
     P::Graph,
     {plain(GLFW_KEY_F2)},
     [](Editor& e) { e.parameters.focusName = true; },
     oneSelected},
    {"graph.frame",
     "Frame Selected Nodes",
     "View",
     P::Graph,
     {plain(GLFW_KEY_F)},
     [](Editor& e) { (e.document.selection().empty() ? e.canvas.frameAll : e.canvas.frameSelection) = true; },
     hasNodes},
    {"graph.frame_all",
     "Frame All Nodes",
     "View",
     P::Graph,
     {plain(GLFW_KEY_A), plain(GLFW_KEY_HOME)},
     [](Editor& e) { e.canvas.frameAll = true; }},
};

}  // namespace

std::span<const Action> graphActions() { return kActions; }

}  // namespace pileus::editor
