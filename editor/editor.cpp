#include "editor/editor.h"

#include <algorithm>

namespace pileus::editor {

namespace {

/// A selected link that is gone is not selected.
void checkSelectedLink(Editor& editor) {
  if (!editor.canvas.selectedLink) return;
  const std::vector<nodes::Link>& links = editor.document.graph().links;
  if (std::find(links.begin(), links.end(), *editor.canvas.selectedLink) == links.end())
    editor.canvas.selectedLink.reset();
}

}  // namespace

bool tryEdit(Editor& editor, Result<nodes::Graph> graph, const std::string& label,
             std::string_view mergeKey) {
  if (!graph) {
    editor.messages.hint(graph.error().message);
    return false;
  }
  editor.document.edit(std::move(*graph), label, mergeKey);
  checkSelectedLink(editor);
  return true;
}

bool tryEditRoot(Editor& editor, Result<nodes::Graph> root, const std::string& label,
                 std::string_view mergeKey) {
  if (!root) {
    editor.messages.hint(root.error().message);
    return false;
  }
  editor.document.editRoot(std::move(*root), label, mergeKey);
  checkSelectedLink(editor);
  return true;
}

void documentReplaced(Editor& editor) {
  editor.canvas = Canvas{};
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
