#pragma once
// Frames of nodes on the canvas: a title and a colour behind what belongs together. Drawing is in
// draw_frame.h.
#include <string>

#include "editor/graph_view/interaction.h"

namespace pileus::editor {

struct Editor;

std::string frameTitle(const Editor& editor, const std::string& frame);
std::string frameColor(const Editor& editor, const std::string& frame);
void setFrameColor(Editor& editor, const std::string& frame, const std::string& color);
void removeFrame(Editor& editor, const std::string& frame);  ///< what lies in it stays
void renameFrame(Editor& editor, const std::string& frame);  ///< opens a field for its title

}  // namespace pileus::editor
