#pragma once
// Groups on the canvas: making and undoing them, and which graph the canvas shows, the document's or that of
// a group inside it. View and selection are remembered for each.
#include <string>
#include <vector>

namespace pileus::editor {

struct Canvas;
struct Session;
struct Shown;
struct Ui;

/// Groups from the outermost in; empty: the document itself.
std::vector<std::string> currentScope(const Session& session);
/// False where there is no such group.
bool goToScope(Session& session, Canvas& canvas, const std::vector<std::string>& scope);
bool isGroup(const Session& session, const std::string& node);

/// Once a frame, before the canvas is drawn: keeps the view of a scope that was left, takes up that of the
/// one that was come to, however that happened.
void followScope(Session& session, Canvas& canvas);

/// What a double click does: enters a group, shows an output, renames anything else.
void openNode(Ui& ui, Session& session, Shown& shown, Canvas& canvas, const std::string& node);
void groupSelection(Ui& ui, Session& session);
void ungroupSelection(Ui& ui, Session& session);
bool groupSelected(const Session& session);
void enterGroup(Ui& ui, Session& session, Canvas& canvas, const std::string& group);
void enterSelected(Ui& ui, Session& session, Canvas& canvas);
bool oneGroupSelected(const Session& session);
void leaveGroup(Ui& ui, Session& session, Canvas& canvas);
bool insideGroup(const Session& session);

}  // namespace pileus::editor
