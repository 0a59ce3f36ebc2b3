#pragma once
// Groups on the canvas: making and undoing them, and which graph the canvas shows, the document's or that of
// a group inside it. View and selection are remembered for each.
#include <string>
#include <vector>

namespace pileus::editor {

struct Editor;

/// Groups from the outermost in; empty: the document itself.
std::vector<std::string> currentScope(const Editor& editor);
/// False where there is no such group.
bool goToScope(Editor& editor, const std::vector<std::string>& scope);
bool isGroup(const Editor& editor, const std::string& node);

/// Once a frame, before the canvas is drawn: keeps the view of a scope that was left, takes up that of the
/// one that was come to, however that happened.
void followScope(Editor& editor);

/// What a double click does: enters a group, shows an output, renames anything else.
void openNode(Editor& editor, const std::string& node);
void groupSelection(Editor& editor);
void ungroupSelection(Editor& editor);
bool groupSelected(const Editor& editor);
void enterGroup(Editor& editor, const std::string& group);
void enterSelected(Editor& editor);
bool oneGroupSelected(const Editor& editor);
void leaveGroup(Editor& editor);
bool insideGroup(const Editor& editor);

}  // namespace pileus::editor
