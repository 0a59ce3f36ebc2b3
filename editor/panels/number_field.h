#pragma once
// A number to drag or type. Dragging stops at the soft range (Shift: fine, Ctrl: round steps), typing at the
// hard one; Ctrl+click or a double click types.
#include <imgui.h>

#include <string>

#include "editor/theme.h"

namespace pileus::editor {

struct NumberField {
  double softMin = 0, softMax = 0;  ///< equal: none
  double hardMin = -1e9, hardMax = 1e9;
  bool integer = false, logarithmic = false;
  const char* unit = "";
  ImU32 mark = 0;  ///< a thin coloured edge (axes of a vector); 0 = none
};

struct NumberEdit {
  bool changed = false;   ///< the value is a new one
  bool dragging = false;  ///< by a drag that goes on
  bool finished = false;  ///< a drag or typing has ended: close the undo step
  bool refused = false;   ///< what was typed was not taken: NumberFieldState::refusal says why
};

/// Of the one field that is being dragged or typed into.
struct NumberFieldState {
  ImGuiID active = 0, typing = 0;
  double raw = 0;  ///< dragged value before rounding
  bool moved = false, focus = false;
  std::string text, refusal;  ///< refusal: why the text last typed was not taken
};

/// Up to six significant digits, no trailing zeros.
std::string numberText(double value, bool integer);
/// The dragged value after `pixels` of a field `width` wide; pure. `fine` and `snap` are the modifiers.
double draggedValue(double raw, double pixels, double width, const NumberField& field, bool fine);
/// Rounds a dragged value to what a person would type, inside the soft range (or the hard one).
double tidiedValue(double raw, const NumberField& field, bool fine, bool snap);

NumberEdit numberField(NumberFieldState& state, const Theme& theme, const char* id, double& value,
                       const NumberField& field, float width);

}  // namespace pileus::editor
