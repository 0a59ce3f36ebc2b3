// Commands of the graph canvas that stand on the digits: view slots and bookmarks.
#include "editor/commands/table.h"
#include "editor/graph_view/bookmarks.h"

namespace pileus::editor {
namespace {

template <int N>
void slot(Editor& e) {
  viewSlot(e, N);
}
template <int N>
void go(Editor& e) {
  goToBookmark(e, N);
}
template <int N>
void keep(Editor& e) {
  saveBookmark(e, N);
}

#define PILEUS_NUMBERED(n)                                                                        \
  {"graph.slot_" #n, "View Slot " #n, "", Panel::Graph, {plain(GLFW_KEY_0 + n)}, slot<n>},        \
      {"graph.go_" #n, "Go to Bookmark " #n, "", Panel::Graph, {ctrl(GLFW_KEY_0 + n)}, go<n>}, {  \
    "graph.save_" #n, "Save Bookmark " #n, "", Panel::Graph, {ctrlShift(GLFW_KEY_0 + n)}, keep<n> \
  }

const Action kActions[] = {PILEUS_NUMBERED(1), PILEUS_NUMBERED(2), PILEUS_NUMBERED(3),
                           PILEUS_NUMBERED(4), PILEUS_NUMBERED(5), PILEUS_NUMBERED(6),
                           PILEUS_NUMBERED(7), PILEUS_NUMBERED(8), PILEUS_NUMBERED(9)};
#undef PILEUS_NUMBERED

}  // namespace

std::span<const Action> numberedActions() { return kActions; }

}  // namespace pileus::editor
