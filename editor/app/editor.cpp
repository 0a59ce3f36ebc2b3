#include "editor/app/editor.h"

#include <algorithm>

#include "nodes/graph/graph_groups.h"

namespace pileus::editor {

namespace {

/// A selected link that is gone is not selected.
void checkSelectedLink(Editor& editor) {
  if (!editor.canvas.selectedLink) return;
  const std::vector<nodes::Link>& links = editor.document.graph().links;
  if (std::find(links.begin(), links.end(), *editor.canvas.selectedLink) == links.end())
    editor.canvas.selectedLink.reset();
}

bool tooDeep(Editor& editor) {
  editor.messages.hint(fmt::format("Groups may be nested {} deep.", nodes::kDeepestGroup));
  return false;
}

}  // namespace

bool tryEdit(Editor& editor, Result<nodes::Graph> graph, const std::string& label,
             std::string_view mergeKey) {
  if (!graph) {
    editor.messages.hint(graph.error().message);
    return false;
  }
  if (!editor.document.edit(std::move(*graph), label, mergeKey)) return tooDeep(editor);
  checkSelectedLink(editor);
  return true;
}

bool tryEditRoot(Editor& editor, Result<nodes::Graph> root, const std::string& label,
                 std::string_view mergeKey) {
  if (!root) {
    editor.messages.hint(root.error().message);
    return false;
  }
  if (!editor.document.editRoot(std::move(*root), label, mergeKey)) return tooDeep(editor);
  checkSelectedLink(editor);
  return true;
}

void documentReplaced(Editor& editor) {
  editor.canvas = Canvas{};
  editor.timeline = Timeline{};
  editor.frame = editor.document.root().settings.frames.x;
  editor.parameters = Parameters{};
  editor.viewport.activeView.clear();
  editor.viewport.freeCamera.reset();
  editor.viewport.tools = {};
  editor.viewport.colorsOf = "\n";
  editor.viewport.mode.layer = {};
  editor.viewport.mode.scan.forget();
  editor.viewport.mode.region = {};
  editor.viewport.snapshots = {};
  editor.preview.forgetPicture();
  editor.scope = RayScope{};
  editor.lab = Lab{};
}

}  // namespace pileus::editor
