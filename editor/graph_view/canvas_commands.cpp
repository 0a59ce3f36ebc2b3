#include "editor/graph_view/canvas_commands.h"

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_menus.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/layout/hit_test.h"
#include "editor/graph_view/layout/path_geometry.h"
#include "editor/graph_view/link_gestures.h"
#include "editor/graph_view/move_gesture.h"
#include "editor/graph_view/scopes.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

void zoomBy(const Theme& theme, Canvas& canvas, const CanvasView& view, const command::Zoom& zoom) {
  canvas.zoomRest += zoom.steps;
  const auto steps = static_cast<int>(std::trunc(canvas.zoomRest));
  canvas.zoomRest -= static_cast<float>(steps);
  const int level = std::clamp(canvas.level + steps, 0, static_cast<int>(theme.zoomLevels.size()) - 1);
  if (level == canvas.level) return;
  // The point under the pointer stays where it is.
  const dvec2 fixed = dvec2(view.canvas(zoom.at));
  canvas.level = level;
  const double after = static_cast<double>(theme.zoomLevels[static_cast<std::size_t>(level)].zoom);
  canvas.center = fixed - dvec2(zoom.at - 0.5f * (view.min + view.max)) / after;
}

void applySelection(Session& session, Canvas& canvas, const std::set<std::string>& names, SelectOp op) {
  std::set<std::string> selection = session.document.selection();
  if (op == SelectOp::Replace)
    selection = names;
  else if (op == SelectOp::Add)
    selection.insert(names.begin(), names.end());
  else
    for (const std::string& name : names) selection.erase(name);
  session.selectedLink.reset();
  canvas.selectedFrame.reset();
  session.document.select(std::move(selection));
}

struct Carry {
  const GraphRoom& room;
  const CanvasView& view;
  const Layout& layout;

  void operator()(const command::Pan& c) {
    room.canvas.center -= dvec2(c.by) / static_cast<double>(view.level.zoom);
  }
  void operator()(const command::Zoom& c) { zoomBy(room.ui.theme, room.canvas, view, c); }
  void operator()(const command::SelectNode& c) { applySelection(room.session, room.canvas, {c.node}, c.op); }
  void operator()(const command::SelectLink& c) {
    applySelection(room.session, room.canvas, {}, SelectOp::Replace);
    room.session.selectedLink = c.link;
  }
  void operator()(const command::SelectFrame& c) {
    applySelection(room.session, room.canvas, {}, SelectOp::Replace);
    room.canvas.selectedFrame = c.frame;
  }
  void operator()(const command::SelectNone&) {
    applySelection(room.session, room.canvas, {}, SelectOp::Replace);
  }
  void operator()(const command::SelectBox& c) {
    applySelection(room.session, room.canvas, nodesInside(layout, view.canvas(c.a), view.canvas(c.b)), c.op);
  }
  void operator()(const command::SelectLasso& c) {
    std::vector<vec2> around = c.around;
    for (vec2& p : around) p = view.canvas(p);
    applySelection(room.session, room.canvas, nodesAround(layout, around), c.op);
  }
  void operator()(const command::Move& c) { moveBy(room.session, room.canvas, canvasUnits(c.by)); }
  void operator()(const command::MoveDone&) { dropNodes(room.ui, room.session, room.canvas); }
  void operator()(const command::FrameDrag& c) {
    dragFrameBy(room.session, room.canvas, c, canvasUnits(c.by));
  }
  void operator()(const command::FrameDone&) { dropFrame(room.ui, room.session, room.canvas); }
  void operator()(const command::Cancel&) { cancelMove(room.canvas); }
  void operator()(const command::LinkStart& c) { startLink(room.session, room.canvas, layout, c.drag); }
  void operator()(const command::LinkDrop& c) { dropLink(room.ui, room.session, room.canvas, view, c); }
  void operator()(const command::PutDot& c) {
    putDot(room.ui, room.session, c.link, dvec2(view.canvas(c.at)));
  }
  void operator()(const command::StrokeDone& c) { finishStroke(room.ui, room.session, view, layout, c); }
  void operator()(const command::View& c) {
    applySelection(room.session, room.canvas, {c.node}, SelectOp::Replace);
    viewNode(room.ui.messages, room.session, room.shown, c.node);
  }
  void operator()(const command::Menu& c) {
    if (c.hit.kind == Hit::Kind::Link)
      (*this)(command::SelectLink{c.hit.link});
    else if (c.hit.kind == Hit::Kind::Frame)
      (*this)(command::SelectFrame{c.hit.frame});
    else if (c.hit.kind != Hit::Kind::Canvas && !room.session.document.selection().contains(c.hit.node))
      applySelection(room.session, room.canvas, {c.hit.node}, SelectOp::Replace);
    openCanvasMenu(room.canvas, c.hit, c.at);
  }
  void operator()(const command::Search& c) {
    openSearch(room.session, room.canvas, c.at, view.canvas(c.at));
  }
  void operator()(const command::Open& c) {
    openNode(room.ui, room.session, room.shown, room.canvas, c.node);
  }
  void operator()(const command::RenameFrame& c) { renameFrame(room.session, room.canvas, c.frame); }

 private:
  dvec2 canvasUnits(vec2 pixels) const { return dvec2(pixels) / static_cast<double>(view.level.zoom); }
};

}  // namespace

void carryOut(const GraphRoom& room, const CanvasView& view, const Layout& layout, const Command& command) {
  std::visit(Carry{room, view, layout}, command);
}

void searchNode(const Session& session, Canvas& canvas) {
  if (canvas.pointerInside)
    openSearch(session, canvas, vec(ImGui::GetIO().MousePos), canvas.pointer);
  else
    openSearch(session, canvas, 0.5f * (canvas.min + canvas.max), vec2(canvas.center));
}

}  // namespace pileus::editor
