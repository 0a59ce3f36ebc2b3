#pragma once
// A number to drag or type. Dragging stops at the soft range (Shift: fine, Ctrl: round steps), typing at the
// hard one; Ctrl+click or a double click types, Tab goes on to the next one, Esc puts back what was there,
// Ctrl+wheel steps.
#include <imgui.h>

#include <optional>
#include <string>

#include "editor/toolkit/number_drag.h"
#include "editor/toolkit/theme.h"

namespace pileus::editor {

struct Theme;

struct NumberField : NumberRange {
  const char* unit = "";  ///< typed quantities are converted to it
  bool showUnit = true;
  bool takesKelvin = false;  ///< a channel of a colour: "5500K" is one
  bool mixed = false;        ///< several values: a dash instead of a number
  bool locked = false;       ///< to be seen only
  ImU32 mark = 0;            ///< a thin coloured edge (axes of a vector); 0 = none
};

struct NumberEdit {
  bool began = false;            ///< typing or a drag has begun
  bool changed = false;          ///< the value is a new one
  bool dragging = false;         ///< by something that goes on: a drag, the wheel, arrows while typing
  bool finished = false;         ///< it has ended: close the undo step
  bool cancelled = false;        ///< by Esc: what was there before is wanted back
  bool refused = false;          ///< what was typed was not taken: NumberFieldState::refusal says why
  bool gang = false;             ///< Alt is held: the neighbours move along
  std::optional<double> kelvin;  ///< a temperature was typed into a colour
};

/// ImGui gives the keyboard one or two frames after it was asked to.
inline constexpr int kFocusFrames = 4;

/// Of the one field that is being dragged or typed into.
struct NumberFieldState {
  ImGuiID active = 0, typing = 0, wheel = 0;
  double raw = 0;     ///< dragged value before rounding
  double before = 0;  ///< the value when typing began
  double wheelAt = 0;
  bool moved = false, focus = false, live = false, wasRefused = false;
  bool focused = false;       ///< the field that is typed into has the keyboard by now
  int button = 0;             ///< -1, 1: pressed on the buttons of an integer
  int asked = 0;              ///< ImGui's frame in which the keyboard was asked for
  std::string initial;        ///< the text when typing began
  std::string text, refusal;  ///< refusal: why the text last typed was not taken
  std::string dropped;        ///< left with a text that cannot be: that and why, to be told once
  int drawn = -1;             ///< ImGui's frame in which that field was last drawn

  // Tab: the field that is typed into next, of the fields of one window in the order they are drawn.
  ImGuiID onwards = 0;     ///< the window in which the next field drawn is it
  ImGuiID next = 0;        ///< the field that is it, known by its id
  int nextAt = 0;          ///< ImGui's frame in which that was found
  ImGuiID last = 0;        ///< the field drawn last in this frame that can be typed into
  ImGuiID lastWindow = 0;  ///< and its window

  /// In this frame or the one before it.
  bool shown() const { return drawn >= ImGui::GetFrameCount() - 1; }
};

NumberEdit numberField(NumberFieldState& state, const Theme& theme, const char* id, double& value,
                       const NumberField& field, float width);

}  // namespace pileus::editor
