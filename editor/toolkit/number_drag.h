#pragma once
// How a number is shown, and how dragging, the wheel and buttons change it. Pure.
#include <string>

namespace pileus::editor {

/// The range and manner of a number.
struct NumberRange {
  double softMin = 0, softMax = 0;  ///< dragging stops here; equal: none
  double hardMin = -1e9, hardMax = 1e9;
  bool integer = false, logarithmic = false;

  bool hasSoft() const { return softMax > softMin; }
};

/// Up to six significant digits, no trailing zeros.
std::string numberText(double value, bool integer);
/// The dragged value after `pixels` of a field `width` wide. `fine` is a tenth of the way.
double draggedValue(double raw, double pixels, double width, const NumberRange& range, bool fine);
/// Rounds a dragged value to what a person would type, inside the soft range (or the hard one).
double tidiedValue(double raw, const NumberRange& range, bool fine, bool snap);
/// One notch of the wheel or press of a button up or down, inside the hard range. A value beyond the soft
/// range is not pulled back.
double steppedValue(double value, int steps, const NumberRange& range, bool fine);
/// Where a value stands in the soft range, 0..1.
double softShare(double value, const NumberRange& range);

/// Rows of a number's field, in pixels from its upper edge: the text, and below it a bar as long as the value
/// is large. Nothing is ever behind the text but the field.
struct FieldRows {
  float text = 0;  ///< top of a line of that size
  float barTop = 0, barEnd = 0;
};
FieldRows fieldRows(float height, float fontSize, float scale);

}  // namespace pileus::editor
