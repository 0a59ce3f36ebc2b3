#pragma once
// The document's settings as rows of the parameter panel.

namespace pileus::editor {

struct Editor;

void drawDocumentRows(Editor& editor);

}  // namespace pileus::editor
