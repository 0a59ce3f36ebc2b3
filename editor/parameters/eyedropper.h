#pragma once
// Taking a colour from the viewport's picture: while it is on, a click there gives the scene-linear value
// under the pointer to the parameter that asked.
#include <functional>
#include <optional>

#include "editor/parameters/param_edit.h"

namespace pileus::editor {

struct ParameterRoom;

struct Eyedropper {
  std::optional<ParamTarget> target;  ///< on: what gets the colour
  /// The new value from the old one and the colour; empty: the colour itself.
  std::function<nodes::ParamValue(const nodes::ParamValue&, const dvec3&)> into;
  dvec2 at{-1};  ///< screen position that was read last
  dvec3 color{0};
};

void drawEyedropper(const ParameterRoom& room);

}  // namespace pileus::editor
