#pragma once
// Appearance and scale of the interface: what the user chose takes effect between two frames.
#include <span>

#include "editor/preferences/appearance.h"

namespace pileus::editor {

struct Editor;

/// The scales of the menu, ascending.
std::span<const float> uiScaleSteps();
/// 0.75 to 2.5 in the menu's steps; 0: the screen's own. Kept in the settings.
void chooseUiScale(Editor& editor, float scale);
/// One of the menu's steps up or down.
void stepUiScale(Editor& editor, int steps);
/// Between frames: new fonts or colours where something else was chosen than what is shown.
void followLook(Editor& editor);

}  // namespace pileus::editor
