#include "editor/graph_view/canvas_commands.h"

#include <algorithm>
#include <cmath>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_menus.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/layout/hit_test.h"
#include "editor/graph_view/layout/path_geometry.h"
#include "editor/graph_view/link_gestures.h"
#include "editor/graph_view/move_gesture.h"
#include "editor/graph_view/scopes.h"

namespace pileus::editor {
namespace {

void zoomBy(Editor& editor, const CanvasView& view, const command::Zoom& zoom) {
  Canvas& canvas = editor.canvas;
  canvas.zoomRest += zoom.steps;
  const auto steps = static_cast<int>(std::trunc(canvas.zoomRest));
  canvas.zoomRest -= static_cast<float>(steps);
  const int level = std::clamp(canvas.level + steps, 0, static_cast<int>(editor.theme.zoomLevels.size()) - 1);
  if (level == canvas.level) return;
  // The point under the pointer stays where it is.
  const dvec2 fixed = dvec2(view.canvas(zoom.at));
  canvas.level = level;
  const double after = static_cast<double>(editor.theme.zoomLevels[static_cast<std::size_t>(level)].zoom);
  canvas.center = fixed - dvec2(zoom.at - 0.5f * (view.min + view.max)) / after;
}

void applySelection(Editor& editor, const std::set<std::string>& names, SelectOp op) {
  std::set<std::string> selection = editor.document.selection();
  if (op == SelectOp::Replace)
    selection = names;
  else if (op == SelectOp::Add)
    selection.insert(names.begin(), names.end());
  else
    for (const std::string& name : names) selection.erase(name);
  editor.canvas.selectedLink.reset();
  editor.canvas.selectedFrame.reset();
  editor.document.select(std::move(selection));
}

struct Carry {
  Editor& editor;
  const CanvasView& view;
  const Layout& layout;

  void operator()(const command::Pan& c) {
    editor.canvas.center -= dvec2(c.by) / static_cast<double>(view.level.zoom);
  }
  void operator()(const command::Zoom& c) { zoomBy(editor, view, c); }
  void operator()(const command::SelectNode& c) { applySelection(editor, {c.node}, c.op); }
  void operator()(const command::SelectLink& c) {
    applySelection(editor, {}, SelectOp::Replace);
    editor.canvas.selectedLink = c.link;
  }
  void operator()(const command::SelectFrame& c) {
    applySelection(editor, {}, SelectOp::Replace);
    editor.canvas.selectedFrame = c.frame;
  }
  void operator()(const command::SelectNone&) { applySelection(editor, {}, SelectOp::Replace); }
  void operator()(const command::SelectBox& c) {
    applySelection(editor, nodesInside(layout, view.canvas(c.a), view.canvas(c.b)), c.op);
  }
  void operator()(const command::SelectLasso& c) {
    std::vector<vec2> around = c.around;
    for (vec2& p : around) p = view.canvas(p);
    applySelection(editor, nodesAround(layout, around), c.op);
  }
  void operator()(const command::Move& c) { moveBy(editor, canvasUnits(c.by)); }
  void operator()(const command::MoveDone&) { dropNodes(editor); }
  void operator()(const command::FrameDrag& c) { dragFrameBy(editor, c, canvasUnits(c.by)); }
  void operator()(const command::FrameDone&) { dropFrame(editor); }
  void operator()(const command::Cancel&) { cancelMove(editor); }
  void operator()(const command::LinkStart& c) { startLink(editor, layout, c.drag); }
  void operator()(const command::LinkDrop& c) { dropLink(editor, view, c); }
  void operator()(const command::PutDot& c) { putDot(editor, c.link, dvec2(view.canvas(c.at))); }
  void operator()(const command::StrokeDone& c) { finishStroke(editor, view, layout, c); }
  void operator()(const command::View& c) {
    applySelection(editor, {c.node}, SelectOp::Replace);
    viewNode(editor, c.node);
  }
  void operator()(const command::Menu& c) {
    if (c.hit.kind == Hit::Kind::Link)
      (*this)(command::SelectLink{c.hit.link});
    else if (c.hit.kind == Hit::Kind::Frame)
      (*this)(command::SelectFrame{c.hit.frame});
    else if (c.hit.kind != Hit::Kind::Canvas && !editor.document.selection().contains(c.hit.node))
      applySelection(editor, {c.hit.node}, SelectOp::Replace);
    openCanvasMenu(editor, c.hit, c.at);
  }
  void operator()(const command::Search& c) { openSearch(editor, c.at, view.canvas(c.at)); }
  void operator()(const command::Open& c) { openNode(editor, c.node); }
  void operator()(const command::RenameFrame& c) { renameFrame(editor, c.frame); }

 private:
  dvec2 canvasUnits(vec2 pixels) const { return dvec2(pixels) / static_cast<double>(view.level.zoom); }
};

}  // namespace

void carryOut(Editor& editor, const CanvasView& view, const Layout& layout, const Command& command) {
  std::visit(Carry{editor, view, layout}, command);
}

void searchNode(Editor& editor) {
  const Canvas& canvas = editor.canvas;
  if (canvas.pointerInside)
    openSearch(editor, vec(ImGui::GetIO().MousePos), canvas.pointer);
  else
    openSearch(editor, 0.5f * (canvas.min + canvas.max), vec2(canvas.center));
}

}  // namespace pileus::editor
