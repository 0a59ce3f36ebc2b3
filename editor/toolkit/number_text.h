#pragma once
// What is typed into a number field: arithmetic, units, and changes of the current value. Pure, and the same
// in every locale.
//
//   3*2   2^0.5   sqrt(2)   pi/4   min(1, 2)   sin(30deg)        arithmetic; plain angles are radians
//   1m 3mm   50cm   2ft   90deg   0.25turn   5500K   24 fps       quantities, in the parameter's own unit
//   +1   -=1   *2   /3   +10%                                     of the current value
//   +1 stop   -0.5 EV                                             times 2^x; added where the value is in
//   stops
#include <optional>
#include <string>
#include <string_view>

#include "renderer/base/result.h"

namespace pileus::editor {

struct NumberContext {
  double current = 0;          ///< what "+1" is added to
  std::string_view unit = {};  ///< the value's own: "m", "deg", "1/m", "stops", "" ...
};

/// The value meant, finite; the error (Arguments) says in one sentence what is wrong.
Result<double> numberFromText(std::string_view text, const NumberContext& context = {});

/// "5500K", "2.7e3 K": the kelvins, if the text is a temperature; nothing if it is something else.
std::optional<double> kelvinFromText(std::string_view text);

struct TextAndCaret {
  std::string text;
  int caret = 0;
};
/// The number at the caret with the digit before the caret one up or down, carrying over; the caret stays at
/// its place of value. Nothing if there is no digit.
std::optional<TextAndCaret> steppedDigit(std::string_view text, int caret, int by);

}  // namespace pileus::editor
