#pragma once
// Nodes that follow the pointer. They enter the document when they are dropped, as one step; until then the
// canvas shows them where they are dragged, and nothing is evaluated anew.
#include <optional>
#include <set>
#include <string>

#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct Session;
struct Ui;

struct MoveGesture {
  bool active = false;
  nodes::Graph graph;               ///< the document's, with what is dragged where it is dragged
  dvec2 by{0};                      ///< canvas units since the press
  std::optional<nodes::Link> onto;  ///< the link that a drop would put the node into
  std::optional<command::FrameDrag> frame;
};

/// What the canvas shows: the document's graph, or the one of a drag.
const nodes::Graph& shownGraph(const Session& session, const Canvas& canvas);

void moveBy(const Session& session, Canvas& canvas, dvec2 by);
/// Finds the link under the dragged node; `layout` is of shownGraph().
void findDropLink(const Session& session, Canvas& canvas, const Layout& layout);
void dropNodes(Ui& ui, Session& session, Canvas& canvas);
void dragFrameBy(const Session& session, Canvas& canvas, const command::FrameDrag& drag, dvec2 by);
void dropFrame(Ui& ui, Session& session, Canvas& canvas);
void cancelMove(Canvas& canvas);

/// The link under a node that a drop would put the node into; nothing where it does not fit or has such links
/// already.
std::optional<nodes::Link> linkUnder(const Layout& layout, const nodes::Graph& graph,
                                     const std::string& node);

}  // namespace pileus::editor
