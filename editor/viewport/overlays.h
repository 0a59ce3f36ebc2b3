#pragma once
// Lines over the picture: bounds, bricks, lights, solids, the ground and the safe frame.
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

struct ViewportRoom;

void drawSceneOverlays(const ViewportRoom& room, const Projection& view);

}  // namespace pileus::editor
