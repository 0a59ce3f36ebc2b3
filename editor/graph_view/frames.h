#pragma once
// Frames of nodes on the canvas: a title and a colour behind what belongs together. What of them can be
// grabbed, and their commands.
#include <optional>
#include <string>

#include "editor/graph_view/interaction.h"

namespace pileus::editor {

struct Canvas;
struct Session;
struct Ui;

/// Height of the title bar in canvas units: never too small to be grabbed. `zoom` in design pixels per unit.
float frameHeader(float zoom);
/// The frontmost frame whose header or side is at a point of the canvas. The room inside belongs to the
/// canvas.
std::optional<Hit> frameAt(const nodes::Graph& graph, vec2 at, float zoom);
/// The frame with these sides moved; it keeps a smallest size.
nodes::Frame resized(const nodes::Frame& frame, const FrameSides& sides, dvec2 by);

void addFrame(Ui& ui, Session& session,
              Canvas& canvas);  ///< around the selection, or an empty one at the pointer
void setFrameColor(Ui& ui, Session& session, std::size_t frame, const std::string& color);
void removeFrame(Ui& ui, Session& session, Canvas& canvas,
                 std::size_t frame);                                          ///< what lies in it stays
void renameFrame(const Session& session, Canvas& canvas, std::size_t frame);  ///< opens a field for its title
void selectContent(Session& session, Canvas& canvas, std::size_t frame);
/// The field, where one is open; once a frame, after the canvas.
void drawFrameTitleField(Ui& ui, Session& session, Canvas& canvas);

}  // namespace pileus::editor
