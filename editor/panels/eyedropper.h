#pragma once
// Taking a colour from the viewport's picture: while it is on, a click there gives the scene-linear value
// under the pointer to the parameter that asked.
#include <optional>

#include "editor/panels/param_edit.h"

namespace pileus::editor {

struct Editor;

struct Eyedropper {
  std::optional<ParamTarget> target;  ///< on: what gets the colour
  dvec2 at{-1};                       ///< screen position that was read last
  dvec3 color{0};
};

void drawEyedropper(Editor& editor);

}  // namespace pileus::editor
