#include "editor/editor.h"

#include <algorithm>

namespace pileus::editor {

bool tryEdit(Editor& editor, Result<nodes::Graph> graph, const std::string& label,
             std::string_view mergeKey) {
  if (!graph) {
    editor.messages.hint(graph.error().message);
    return false;
  }
  editor.document.edit(std::move(*graph), label, mergeKey);
  // A selected link that is gone is not selected.
  if (editor.canvas.selectedLink) {
    const std::vector<nodes::Link>& links = editor.document.graph().links;
    if (std::find(links.begin(), links.end(), *editor.canvas.selectedLink) == links.end())
      editor.canvas.selectedLink.reset();
  }
  return true;
}

void documentReplaced(Editor& editor) {
  editor.canvas = Canvas{};
  editor.parameters = Parameters{};
  editor.viewport.activeView.clear();
  editor.viewport.freeCamera.reset();
  editor.viewport.colorsOf = "\n";
  editor.preview.forgetPicture();
  editor.scope = RayScope{};
  editor.lab = Lab{};
}

}  // namespace pileus::editor
