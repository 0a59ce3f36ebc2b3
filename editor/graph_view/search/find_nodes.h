#pragma once
// Ctrl+F over the canvas: a search through all nodes. Matches stand out on the canvas while it is open.
#include <set>
#include <string>
#include <vector>

#include "editor/graph_view/search/find_matches.h"

namespace pileus::editor {

struct Canvas;
struct Clock;
struct Session;
struct Ui;

struct FindNodes {
  bool opening = false, open = false;
  std::string query;
  std::uint64_t revision = 0;  ///< of the document that was searched
  int frame = 1;               ///< whose values were searched
  std::vector<FindMatch> all;
  std::set<std::string> matches;  ///< names of those in the graph on the canvas
  int chosen = 0;
  bool scroll = false;
};

void openFind(Canvas& canvas);
/// Once a frame, after the canvas.
void drawFind(Ui& ui, Session& session, const Clock& clock, Canvas& canvas);

}  // namespace pileus::editor
