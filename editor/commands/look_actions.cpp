// Commands that tidy the graph canvas and choose what it shows.
#include "editor/commands/panel_commands.h"
#include "editor/commands/table.h"
#include "editor/document/session.h"
#include "editor/graph_view/arrange_commands.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/search/find_nodes.h"
#include "editor/graph_view/thumbnails.h"
#include "editor/preferences/settings.h"

namespace pileus::editor {
namespace {

bool hasNodes(const Editor& e) { return !e.session.document.graph().nodes.empty(); }
bool several(const Editor& e) { return e.session.document.selection().size() > 1; }
bool many(const Editor& e) { return e.session.document.selection().size() > 2; }

template <Align How>
void align(Editor& e) {
  alignNodes(e.graphRoom, How);
}

using P = Panel;

const Action kActions[] = {
    {.id = "graph.find",
     .label = "Find Node\xe2\x80\xa6",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {ctrl(GLFW_KEY_F)},
     .run =
         [](Editor& e) {
           revealPanel(e, Panel::Graph);
           openFind(e.canvas);
         },
     .enabled = hasNodes,
     .separator = true},
    {.id = "graph.arrange",
     .label = "Arrange Nodes",
     .menu = "Edit",
     .panel = P::Graph,
     .keys = {plain(GLFW_KEY_L)},
     .run = [](Editor& e) { arrangeNodes(e.graphRoom); },
     .enabled = hasNodes},
    {.id = "graph.align_left",
     .label = "Left Sides",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .keys = {shift(GLFW_KEY_LEFT)},
     .run = align<Align::Left>,
     .enabled = several},
    {.id = "graph.align_right",
     .label = "Right Sides",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .keys = {shift(GLFW_KEY_RIGHT)},
     .run = align<Align::Right>,
     .enabled = several},
    {.id = "graph.align_top",
     .label = "Tops",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .keys = {shift(GLFW_KEY_UP)},
     .run = align<Align::Top>,
     .enabled = several},
    {.id = "graph.align_bottom",
     .label = "Bottoms",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .keys = {shift(GLFW_KEY_DOWN)},
     .run = align<Align::Bottom>,
     .enabled = several},
    {.id = "graph.align_column",
     .label = "Middles in a Column",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .run = align<Align::CenterX>,
     .enabled = several,
     .separator = true},
    {.id = "graph.align_row",
     .label = "Middles in a Row",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .run = align<Align::CenterY>,
     .enabled = several},
    {.id = "graph.distribute_across",
     .label = "Distribute Across",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .run = [](Editor& e) { distributeNodes(e.graphRoom, true); },
     .enabled = many,
     .separator = true},
    {.id = "graph.distribute_down",
     .label = "Distribute Down",
     .menu = "Edit/Align",
     .panel = P::Graph,
     .run = [](Editor& e) { distributeNodes(e.graphRoom, false); },
     .enabled = many},
    {.id = "graph.thumbnails",
     .label = "Picture on Selected Nodes",
     .menu = "View",
     .panel = P::Graph,
     .keys = {shift(GLFW_KEY_H)},
     .run = [](Editor& e) { toggleThumbnails(e.ui, e.session, e.settings, e.canvas); },
     .enabled = [](const Editor& e) { return !e.session.document.selection().empty(); },
     .separator = true},
    {.id = "view.thumbnails",
     .label = "Pictures on Nodes",
     .menu = "View",
     .panel = P::Global,
     .run =
         [](Editor& e) {
           e.settings.showThumbnails = !e.settings.showThumbnails;
           e.canvas.thumbnails.exceptions.clear();
         },
     .checked = [](const Editor& e) { return e.settings.showThumbnails; }},
    {.id = "view.minimap",
     .label = "Map of the Graph",
     .menu = "View",
     .panel = P::Global,
     .run = [](Editor& e) { e.settings.showMinimap = !e.settings.showMinimap; },
     .checked = [](const Editor& e) { return e.settings.showMinimap; }},
};

}  // namespace

std::span<const Action> lookActions() { return kActions; }

}  // namespace pileus::editor
