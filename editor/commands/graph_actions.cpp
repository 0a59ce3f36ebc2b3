// Commands of the graph canvas.
#include "editor/commands/table.h"
#include "editor/graph_view/bookmarks.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/link_gestures.h"
#include "editor/graph_view/scopes.h"

namespace pileus::editor {
namespace {

bool hasSelection(const Editor& e) { return !e.document.selection().empty(); }
bool hasLink(const Editor& e) { return e.canvas.selectedLink.has_value(); }
bool hasFrame(const Editor& e) { return e.canvas.selectedFrame.has_value(); }
bool canDelete(const Editor& e) { return hasSelection(e) || hasLink(e) || hasFrame(e); }
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
    {"graph.duplicate_inputs",
     "Duplicate with Inputs",
     "Edit",
     P::Graph,
     {ctrlShift(GLFW_KEY_D)},
     duplicateWithInputs,
     hasSelection},
    {"graph.delete", "Delete", "Edit", P::Graph, {plain(GLFW_KEY_DELETE)}, deleteSelection, canDelete},
    {"graph.delete_reconnect",
     "Delete and Reconnect",
     "Edit",
     P::Graph,
     {shift(GLFW_KEY_DELETE)},
     deleteReconnecting,
     canDelete},
    {"graph.extract", "Extract", "Edit", P::Graph, {ctrlShift(GLFW_KEY_X)}, extractSelection, hasSelection},
    {"graph.upstream",
     "Select Upstream",
     "Edit",
     P::Graph,
     {ctrl(GLFW_KEY_L)},
     selectUpstream,
     hasSelection,
     nullptr,
     true},
    {"graph.downstream",
     "Select Downstream",
     "Edit",
     P::Graph,
     {ctrlShift(GLFW_KEY_L)},
     selectDownstream,
     hasSelection},
    {"graph.add",
     "Add Node\xe2\x80\xa6",
     "Edit",
     P::Graph,
     {plain(GLFW_KEY_TAB), shift(GLFW_KEY_A)},
     searchNode,
     nullptr,
     nullptr,
     true},
    {"graph.insert", "Insert Node\xe2\x80\xa6", "", P::Graph, {}, searchNode, hasLink},
    {"graph.dot", "Add Dot", "Edit", P::Graph, {plain(GLFW_KEY_PERIOD)}, dotOnSelectedLink, hasLink},
    {"graph.mute",
     "Mute Link",
     "Edit",
     P::Graph,
     {},
     muteSelectedLink,
     hasLink,
     [](const Editor& e) { return e.canvas.selectedLink && e.canvas.selectedLink->muted; }},
    {"graph.add_frame", "Frame Around Selection", "Edit", P::Graph, {ctrl(GLFW_KEY_J)}, addFrame},
    {"graph.rename_frame",
     "Rename Frame",
     "",
     P::Graph,
     {},
     [](Editor& e) { renameFrame(e, *e.canvas.selectedFrame); },
     hasFrame},
    {"graph.select_content",
     "Select Content",
     "",
     P::Graph,
     {},
     [](Editor& e) { selectContent(e, *e.canvas.selectedFrame); },
     hasFrame},
    {"graph.group", "Group", "Edit", P::Graph, {ctrl(GLFW_KEY_G)}, groupSelection, hasSelection},
    {"graph.ungroup", "Ungroup", "Edit", P::Graph, {ctrlShift(GLFW_KEY_G)}, ungroupSelection, groupSelected},
    {"graph.enter", "Enter Group", "Edit", P::Graph, {}, enterSelected, oneGroupSelected},
    {"graph.leave", "Leave Group", "Edit", P::Graph, {plain(GLFW_KEY_U)}, leaveGroup, insideGroup},
    {"graph.bypass",
     "Bypass",
     "Edit",
     P::Graph,
     {plain(GLFW_KEY_D), plain(GLFW_KEY_M)},
     bypassSelection,
     hasSelection,
     nullptr,
     true},
    {"graph.disable", "Disable", "Edit", P::Graph, {ctrl(GLFW_KEY_M)}, disableSelection, hasSelection},
    {"graph.rename",
     "Rename",
     "Edit",
     P::Graph,
     {plain(GLFW_KEY_F2)},
     [](Editor& e) { e.parameters.focusName = true; },
     oneSelected},
    {"graph.view", "View This Node", "View", P::Graph, {}, viewSelected, oneSelected},
    {"graph.clear_slots", "Clear View Slots", "", P::Graph, {}, clearViewSlots},
    {"graph.frame",
     "Zoom to Selected Nodes",
     "View",
     P::Graph,
     {plain(GLFW_KEY_F)},
     [](Editor& e) { (e.document.selection().empty() ? e.canvas.frameAll : e.canvas.frameSelection) = true; },
     hasNodes},
    {"graph.frame_all",
     "Zoom to All Nodes",
     "View",
     P::Graph,
     {plain(GLFW_KEY_A), plain(GLFW_KEY_HOME)},
     [](Editor& e) { e.canvas.frameAll = true; }},
};

}  // namespace

std::span<const Action> graphActions() { return kActions; }

}  // namespace pileus::editor
