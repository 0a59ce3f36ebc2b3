// Commands of the graph canvas.
#include "editor/commands/panel_commands.h"
#include "editor/commands/table.h"
#include "editor/document/session.h"
#include "editor/graph_view/bookmarks.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/link_gestures.h"
#include "editor/graph_view/scopes.h"
#include "editor/picture/viewed_node.h"
#include "editor/toolkit/fields.h"

namespace pileus::editor {
namespace {

bool hasSelection(const Editor& e) { return !e.session.document.selection().empty(); }
bool hasLink(const Editor& e) { return e.session.selectedLink.has_value(); }
bool hasFrame(const Editor& e) { return e.canvas.selectedFrame.has_value(); }
bool canDelete(const Editor& e) { return hasSelection(e) || hasLink(e) || hasFrame(e); }
bool oneSelected(const Editor& e) { return e.session.document.selection().size() == 1; }
bool hasNodes(const Editor& e) { return !e.session.document.graph().nodes.empty(); }

using P = Panel;

const Action kActions[] = {
    {.id = "graph.duplicate",
     .label = "Duplicate",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrl(GLFW_KEY_D), shift(GLFW_KEY_D)},
     .run = [](Editor& e) { duplicateSelection(e.ui, e.session); },
     .enabled = hasSelection},
    {.id = "graph.duplicate_inputs",
     .label = "Duplicate with Inputs",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrlShift(GLFW_KEY_D)},
     .run = [](Editor& e) { duplicateWithInputs(e.ui, e.session); },
     .enabled = hasSelection},
    {.id = "graph.delete",
     .label = "Delete",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_DELETE)},
     .run = [](Editor& e) { deleteSelection(e.ui, e.session, e.canvas); },
     .enabled = canDelete},
    {.id = "graph.delete_reconnect",
     .label = "Delete and Reconnect",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {shift(GLFW_KEY_DELETE)},
     .run = [](Editor& e) { deleteReconnecting(e.ui, e.session, e.canvas); },
     .enabled = canDelete},
    {.id = "graph.extract",
     .label = "Extract",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrlShift(GLFW_KEY_X)},
     .run = [](Editor& e) { extractSelection(e.ui, e.session); },
     .enabled = hasSelection},
    {.id = "graph.upstream",
     .label = "Select Upstream",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrl(GLFW_KEY_L)},
     .run = [](Editor& e) { selectUpstream(e.session, e.canvas); },
     .enabled = hasSelection,
     .separator = true},
    {.id = "graph.downstream",
     .label = "Select Downstream",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrlShift(GLFW_KEY_L)},
     .run = [](Editor& e) { selectDownstream(e.session, e.canvas); },
     .enabled = hasSelection},
    {.id = "graph.add",
     .label = "Add Node\xe2\x80\xa6",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_TAB), shift(GLFW_KEY_A)},
     .run =
         [](Editor& e) {
           revealPanel(e, Panel::Graph);
           searchNode(e.session, e.canvas);
         },
     .separator = true},
    {.id = "graph.insert",
     .label = "Insert Node\xe2\x80\xa6",
     .panel = P::Graph,
     .run =
         [](Editor& e) {
           revealPanel(e, Panel::Graph);
           searchNode(e.session, e.canvas);
         },
     .enabled = hasLink},
    {.id = "graph.dot",
     .label = "Add Dot",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_PERIOD)},
     .run = [](Editor& e) { dotOnSelectedLink(e.ui, e.session); },
     .enabled = hasLink},
    {.id = "graph.mute",
     .label = "Mute Link",
     .menu = "Edit",
     .panel = P::Graph,
     .run = [](Editor& e) { muteSelectedLink(e.ui, e.session); },
     .enabled = hasLink,
     .checked = [](const Editor& e) { return e.session.selectedLink && e.session.selectedLink->muted; }},
    {.id = "graph.add_frame",
     .label = "Frame Around Selection",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrl(GLFW_KEY_J)},
     .run = [](Editor& e) { addFrame(e.ui, e.session, e.canvas); }},
    {.id = "graph.rename_frame",
     .label = "Rename Frame",
     .panel = P::Graph,
     .run = [](Editor& e) { renameFrame(e.session, e.canvas, *e.canvas.selectedFrame); },
     .enabled = hasFrame},
    {.id = "graph.select_content",
     .label = "Select Content",
     .panel = P::Graph,
     .run = [](Editor& e) { selectContent(e.session, e.canvas, *e.canvas.selectedFrame); },
     .enabled = hasFrame},
    {.id = "graph.group",
     .label = "Group",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrl(GLFW_KEY_G)},
     .run = [](Editor& e) { groupSelection(e.ui, e.session); },
     .enabled = hasSelection},
    {.id = "graph.ungroup",
     .label = "Ungroup",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrlShift(GLFW_KEY_G)},
     .run = [](Editor& e) { ungroupSelection(e.ui, e.session); },
     .enabled = [](const Editor& e) { return groupSelected(e.session); }},
    {.id = "graph.enter",
     .label = "Enter Group",
     .menu = "Edit",
     .panel = P::Graph,
     .run = [](Editor& e) { enterSelected(e.ui, e.session, e.canvas); },
     .enabled = [](const Editor& e) { return oneGroupSelected(e.session); }},
    {.id = "graph.leave",
     .label = "Leave Group",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_U)},
     .run = [](Editor& e) { leaveGroup(e.ui, e.session, e.canvas); },
     .enabled = [](const Editor& e) { return insideGroup(e.session); }},
    {.id = "graph.bypass",
     .label = "Bypass",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_D), plain(GLFW_KEY_M)},
     .run = [](Editor& e) { bypassSelection(e.ui, e.session); },
     .enabled = hasSelection,
     .separator = true},
    {.id = "graph.disable",
     .label = "Disable",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrl(GLFW_KEY_M)},
     .run = [](Editor& e) { disableSelection(e.ui, e.session); },
     .enabled = hasSelection},
    {.id = "graph.rename",
     .label = "Rename",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_F2)},
     .run =
         [](Editor& e) {
           revealPanel(e, Panel::Parameters);
           e.fields.focusName = true;
         },
     .enabled = oneSelected},
    {.id = "graph.view",
     .label = "View This Node",
     .menu = "View",
     .panel = P::Graph,
     .run = [](Editor& e) { viewSelected(e.messages, e.session, e.shown); },
     .enabled = oneSelected},
    {.id = "graph.clear_slots",
     .label = "Clear View Slots",
     .panel = P::Graph,
     .run = [](Editor& e) { clearViewSlots(e.shown); }},
    {.id = "graph.frame",
     .label = "Zoom to Selected Nodes",
     .menu = "View",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_F)},
     .run =
         [](Editor& e) {
           (e.session.document.selection().empty() ? e.canvas.frameAll : e.canvas.frameSelection) = true;
         },
     .enabled = hasNodes},
    {.id = "graph.frame_all",
     .label = "Zoom to All Nodes",
     .menu = "View",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_A), plain(GLFW_KEY_HOME)},
     .run = [](Editor& e) { e.canvas.frameAll = true; }},
};

}  // namespace

std::span<const Action> graphActions() { return kActions; }

}  // namespace pileus::editor
