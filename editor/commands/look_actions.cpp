// Commands that tidy the graph canvas and choose what it shows.
#include "editor/commands/table.h"
#include "editor/graph_view/arrange_commands.h"

namespace pileus::editor {
namespace {

bool hasNodes(const Editor& e) { return !e.document.graph().nodes.empty(); }
bool several(const Editor& e) { return e.document.selection().size() > 1; }
bool many(const Editor& e) { return e.document.selection().size() > 2; }

template <Align How>
void align(Editor& e) {
  alignNodes(e, How);
}

using P = Panel;

const Action kActions[] = {
    {"graph.find",
     "Find Node\xe2\x80\xa6",
     "Edit",
     P::Graph,
     {ctrl(GLFW_KEY_F)},
     openFind,
     hasNodes,
     nullptr,
     true},
    {"graph.arrange", "Arrange Nodes", "Edit", P::Graph, {plain(GLFW_KEY_L)}, arrangeNodes, hasNodes},
    {"graph.align_left",
     "Left Sides",
     "Edit/Align",
     P::Graph,
     {shift(GLFW_KEY_LEFT)},
     align<Align::Left>,
     several},
    {"graph.align_right",
     "Right Sides",
     "Edit/Align",
     P::Graph,
     {shift(GLFW_KEY_RIGHT)},
     align<Align::Right>,
     several},
    {"graph.align_top", "Tops", "Edit/Align", P::Graph, {shift(GLFW_KEY_UP)}, align<Align::Top>, several},
    {"graph.align_bottom",
     "Bottoms",
     "Edit/Align",
     P::Graph,
     {shift(GLFW_KEY_DOWN)},
     align<Align::Bottom>,
     several},
    {"graph.align_column",
     "Middles in a Column",
     "Edit/Align",
     P::Graph,
     {},
     align<Align::CenterX>,
     several,
     nullptr,
     true},
    {"graph.align_row", "Middles in a Row", "Edit/Align", P::Graph, {}, align<Align::CenterY>, several},
    {"graph.distribute_across",
     "Distribute Across",
     "Edit/Align",
     P::Graph,
     {},
     [](Editor& e) { distributeNodes(e, true); },
     many,
     nullptr,
     true},
    {"graph.distribute_down",
     "Distribute Down",
     "Edit/Align",
     P::Graph,
     {},
     [](Editor& e) { distributeNodes(e, false); },
     many},
    {"graph.thumbnails",
     "Picture on Selected Nodes",
     "View",
     P::Graph,
     {shift(GLFW_KEY_H)},
     toggleThumbnails,
     [](const Editor& e) { return !e.document.selection().empty(); },
     nullptr,
     true},
    {"view.thumbnails",
     "Pictures on Nodes",
     "View",
     P::Global,
     {},
     [](Editor& e) {
       e.settings.showThumbnails = !e.settings.showThumbnails;
       e.canvas.thumbnails.exceptions.clear();
     },
     nullptr,
     [](const Editor& e) { return e.settings.showThumbnails; }},
    {"view.minimap",
     "Map of the Graph",
     "View",
     P::Global,
     {},
     [](Editor& e) { e.settings.showMinimap = !e.settings.showMinimap; },
     nullptr,
     [](const Editor& e) { return e.settings.showMinimap; }},
};

}  // namespace

std::span<const Action> lookActions() { return kActions; }

}  // namespace pileus::editor
