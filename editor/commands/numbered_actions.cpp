// Commands of the graph canvas that stand on the digits: view slots and bookmarks.
#include "editor/commands/table.h"
#include "editor/graph_view/bookmarks.h"
#include "editor/picture/viewed_node.h"

namespace pileus::editor {
namespace {

template <int N>
void slot(Editor& e) {
  viewSlot(e.messages, e.session, e.shown, N);
}
template <int N>
void go(Editor& e) {
  goToBookmark(e.ui, e.session, e.settings, e.canvas, N);
}
template <int N>
void keep(Editor& e) {
  saveBookmark(e.ui, e.session, e.settings, e.canvas, N);
}

#define PILEUS_NUMBERED(n)                                                       \
  {.id = "graph.slot_" #n,                                                       \
   .label = "View Slot " #n,                                                     \
   .panel = Panel::Graph,                                                        \
   .keys = {plain(GLFW_KEY_0 + n)},                                              \
   .run = slot<n>},                                                              \
      {.id = "graph.go_" #n,                                                     \
       .label = "Go to Bookmark " #n,                                            \
       .panel = Panel::Graph,                                                    \
       .keys = {ctrl(GLFW_KEY_0 + n)},                                           \
       .run = go<n>},                                                            \
  {                                                                              \
    .id = "graph.save_" #n, .label = "Save Bookmark " #n, .panel = Panel::Graph, \
    .keys = {ctrlShift(GLFW_KEY_0 + n)}, .run = keep<n>                          \
  }

const Action kActions[] = {
    PILEUS_NUMBERED(1), PILEUS_NUMBERED(2), PILEUS_NUMBERED(3), PILEUS_NUMBERED(4), PILEUS_NUMBERED(5),
    PILEUS_NUMBERED(6), PILEUS_NUMBERED(7), PILEUS_NUMBERED(8), PILEUS_NUMBERED(9),
};
#undef PILEUS_NUMBERED

}  // namespace

std::span<const Action> numberedActions() { return kActions; }

}  // namespace pileus::editor
