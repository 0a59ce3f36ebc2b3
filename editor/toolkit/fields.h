#pragma once
// The one field that is typed into or dragged. Owned by the frame, so that a field which is not drawn any
// more holds the keyboard no longer.
#include "editor/toolkit/number_field.h"

namespace pileus::editor {

struct Fields {
  NumberFieldState number;
  bool focusName = false;  ///< put the keyboard into the node's name at its next drawing

  /// Is a number being typed or dragged that was drawn in this frame or the last one?
  bool busy() const { return number.shown() && (number.typing != 0 || (number.active != 0 && number.moved)); }
  bool typing() const { return number.shown() && number.typing != 0; }
};

}  // namespace pileus::editor
