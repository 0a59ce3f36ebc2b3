#include "editor/time/timeline_edits.h"

#include <fmt/core.h>

#include "editor/app/editor.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {
namespace {

constexpr char kMove[] = "timeline move";

}  // namespace

std::string keysText(std::size_t count) { return count == 1 ? "key" : fmt::format("{} keys", count); }

void deleteSelectedKeys(Editor& editor) {
  deleteSelectedKeys(editor, "Delete " + keysText(editor.timeline.selected.size()));
}

void deleteSelectedKeys(Editor& editor, const std::string& label) {
  KeySelection& selected = editor.timeline.selected;
  nodes::Graph graph = editor.document.graph();
  for (const KeyRef& k : selected) graph = nodes::removeKey(graph, k.node, k.param, k.frame);
  if (tryEdit(editor, std::move(graph), label)) selected.clear();
}

void interpolateSelectedKeys(Editor& editor, nodes::Interpolation interpolation) {
  nodes::Graph graph = editor.document.graph();
  for (const KeyRef& k : editor.timeline.selected)
    graph = nodes::setInterpolation(graph, k.node, k.param, k.frame, interpolation);
  tryEdit(editor, std::move(graph), "Interpolate " + keysText(editor.timeline.selected.size()));
}

void keyShownRows(Editor& editor) {
  nodes::Graph graph = editor.document.graph();
  const std::vector<AnimatedRow>& rows = shownRows(editor.timeline.rows, editor.document);
  if (rows.empty()) return editor.messages.hint("Nothing is animated yet: press I over a parameter.");
  for (const AnimatedRow& row : rows) {
    nodes::Animation animation{row.keys};
    Result<nodes::Graph> keyed =
        nodes::setParamAt(graph, row.node, row.param, nodes::valueAt(animation, editor.frame), editor.frame);
    if (!keyed) return editor.messages.hint(keyed.error().message);
    graph = std::move(*keyed);
  }
  tryEdit(editor, std::move(graph), fmt::format("Set {} at frame {}", keysText(rows.size()), editor.frame));
}

void selectAllKeys(Editor& editor) {
  editor.timeline.selected.clear();
  for (const AnimatedRow& row : shownRows(editor.timeline.rows, editor.document))
    for (const nodes::AnimationKey& k : row.keys)
      editor.timeline.selected.insert({row.node, row.param, k.frame});
}

void beginKeyMove(Editor& editor) {
  Timeline& t = editor.timeline;
  t.before = editor.document.graph();
  t.beforeSelected = t.selected;
  editor.document.endMerge();
}

void moveSelectedKeys(Editor& editor, double frames) {
  Timeline& t = editor.timeline;
  if (t.beforeSelected.empty()) return;
  if (t.selected.begin()->frame == t.beforeSelected.begin()->frame + frames) return;  // there already
  // From where all began, so that keys that were passed on the way stay what they were.
  if (!tryEdit(editor, nodes::moveKeys(t.before, movesBy(t.beforeSelected, frames)),
               "Move " + keysText(t.beforeSelected.size()), kMove))
    return;
  t.selected.clear();
  for (KeyRef k : t.beforeSelected) {
    k.frame += frames;
    t.selected.insert(std::move(k));
  }
  editor.preview.touch();
}

void endKeyMove(Editor& editor) {
  editor.document.endMerge();
  editor.timeline.before = {};
}

}  // namespace pileus::editor
