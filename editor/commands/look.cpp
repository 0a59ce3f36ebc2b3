#include "editor/commands/look.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/editor.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/window.h"

namespace pileus::editor {

std::span<const float> uiScaleSteps() {
  static constexpr float kSteps[] = {0.75f, 0.9f, 1, 1.1f, 1.25f, 1.5f, 1.75f, 2, 2.25f, 2.5f};
  return kSteps;
}

void chooseUiScale(Editor& editor, float scale) {
  editor.now.uiScale = scale > 0 ? std::clamp(scale, uiScaleSteps().front(), uiScaleSteps().back()) : 0;
  editor.settings.uiScale = std::round(static_cast<double>(editor.now.uiScale) * 100) / 100;
}

void stepUiScale(Editor& editor, int steps) {
  const std::span<const float> all = uiScaleSteps();
  // From a scale between two steps, such as a screen's, to the next one in that direction.
  const float now = editor.theme.scale;
  const auto above = std::upper_bound(all.begin(), all.end(), now + 0.01f);
  const auto atOrAbove = std::lower_bound(all.begin(), all.end(), now - 0.01f);
  const auto at =
      static_cast<int>((steps > 0 ? above : atOrAbove) - all.begin()) + (steps > 0 ? steps - 1 : steps);
  chooseUiScale(editor, all[static_cast<std::size_t>(std::clamp(at, 0, static_cast<int>(all.size()) - 1))]);
}

void followLook(Editor& editor) {
  const float scale = editor.now.uiScale > 0 ? editor.now.uiScale : editor.window.screenScale();
  if (scale != editor.theme.scale) {
    editor.theme = makeTheme(scale, editor.settings.theme);
    editor.window.fontsChanged(scale);
  } else if (editor.settings.theme != editor.theme.appearance) {
    setAppearance(editor.theme, editor.settings.theme);
  }
}

}  // namespace pileus::editor
