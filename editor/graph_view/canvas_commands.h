#pragma once
// Carries out what the canvas's state machine decides, and the graph actions of menus and keys.
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/interaction.h"
#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct GraphRoom;
struct Session;
struct Ui;

void carryOut(const GraphRoom& room, const CanvasView& view, const Layout& layout, const Command& command);

// Removing (selection_commands.cpp).
void deleteSelection(Ui& ui, Session& session, Canvas& canvas);     ///< or the selected link or frame
void deleteReconnecting(Ui& ui, Session& session, Canvas& canvas);  ///< what the nodes passed on stays linked
void extractSelection(Ui& ui, Session& session);  ///< out of their links, which close behind them
// Switching.
void bypassSelection(Ui& ui, Session& session);
void disableSelection(Ui& ui, Session& session);
void muteSelectedLink(Ui& ui, Session& session);
void colorSelection(Ui& ui, Session& session, const std::string& color);  ///< "" = the category's
// Selecting.
void selectAllNodes(Session& session, Canvas& canvas);
void selectUpstream(Session& session, Canvas& canvas);
void selectDownstream(Session& session, Canvas& canvas);

// Clipboard and copies (clipboard_commands.cpp).
void copySelection(Ui& ui, const Session& session, Canvas& canvas);
void cutSelection(Ui& ui, Session& session, Canvas& canvas);
void pasteNodes(Ui& ui, Session& session, Canvas& canvas);
void duplicateSelection(Ui& ui, Session& session);
void duplicateWithInputs(Ui& ui, Session& session);

void searchNode(const Session& session, Canvas& canvas);  ///< at the pointer, or the middle of the canvas

}  // namespace pileus::editor
