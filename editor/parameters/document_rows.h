#pragma once
// The document's settings as rows of the parameter panel.

namespace pileus::editor {

struct ParameterRoom;

void drawDocumentRows(const ParameterRoom& room);

}  // namespace pileus::editor
