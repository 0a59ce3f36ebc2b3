#pragma once
// Lines over the picture: bounds, bricks, lights, solids, the ground and the safe frame.
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

void drawSceneOverlays(Editor& editor, const Projection& view);

}  // namespace pileus::editor
