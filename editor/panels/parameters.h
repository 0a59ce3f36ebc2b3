#pragma once
// The parameter panel: the selected node's name, parameters (from its declaration alone), faults and
// statistics; with nothing selected, the document's settings.
#include <imgui.h>

#include <string>

#include "editor/panels/number_field.h"

namespace pileus::editor {

struct Editor;

struct Parameters {
  NumberFieldState numbers;
  std::string refusedKey;        ///< "Node.param" whose last typed value was refused (numbers.refusal)
  double refusedAt = -1e9;       ///< ImGui time of that
  bool focusName = false;        ///< put the keyboard into the name field at the next drawing
  std::string nameOf, nameText;  ///< the name being edited
  std::string textKey, text;     ///< the text parameter being edited ("Node.param") and its state
};

void drawParameters(Editor& editor, ImVec2 min, ImVec2 max);

}  // namespace pileus::editor
