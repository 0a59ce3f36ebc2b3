#pragma once
// Frames of nodes on the canvas: a title and a colour behind what belongs together. What of them can be
// grabbed, and their commands.
#include <optional>
#include <string>

#include "editor/graph_view/interaction.h"

namespace pileus::editor {

struct Editor;

/// Height of the title bar in canvas units: never too small to be grabbed. `zoom` in design pixels per unit.
float frameHeader(float zoom);
/// The frontmost frame whose header or side is at a point of the canvas. The room inside belongs to the
/// canvas.
std::optional<Hit> frameAt(const nodes::Graph& graph, vec2 at, float zoom);
/// The frame with these sides moved; it keeps a smallest size.
nodes::Frame resized(const nodes::Frame& frame, const FrameSides& sides, dvec2 by);

void addFrame(Editor& editor);  ///< around the selection, or an empty one at the pointer
void setFrameColor(Editor& editor, std::size_t frame, const std::string& color);
void removeFrame(Editor& editor, std::size_t frame);  ///< what lies in it stays
void renameFrame(Editor& editor, std::size_t frame);  ///< opens a field for its title
void selectContent(Editor& editor, std::size_t frame);
/// The field, where one is open; once a frame, after the canvas.
void drawFrameTitleField(Editor& editor);

}  // namespace pileus::editor
