#pragma once
// Which graph the canvas shows: the document's, or that of a group inside it. View and selection are
// remembered for each.
#include <string>
#include <vector>

namespace pileus::editor {

struct Editor;

/// Groups from the outermost in; empty: the document itself.
std::vector<std::string> currentScope(const Editor& editor);
/// False where there is no such group.
bool goToScope(Editor& editor, const std::vector<std::string>& scope);
bool isGroup(const Editor& editor, const std::string& node);

/// What a double click does: enters a group, shows an output, renames anything else.
void openNode(Editor& editor, const std::string& node);

}  // namespace pileus::editor
