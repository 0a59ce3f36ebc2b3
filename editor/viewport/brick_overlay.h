#pragma once
// The bricks of grids as boxes over the picture.
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

struct Shown;
struct Ui;

/// Coloured by level, dim where they are not on the GPU. Finer levels than can be told apart are left out.
void drawBricks(Ui& ui, const Shown& shown, const Projection& view);

}  // namespace pileus::editor
