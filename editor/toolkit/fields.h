#pragma once
// The one field that is typed into or dragged, and how it is left. Owned by the frame: input that leads
// elsewhere (a click, a command, another document) waits for one frame in which the field ends and gives what
// was typed to where it belongs; keys for a field that was only asked for wait until it takes them; and a
// field that is not drawn any more holds the keyboard no longer.
#include <string>

#include "editor/toolkit/number_field.h"

namespace pileus::editor {

struct InputEvent;

struct Fields {
  NumberFieldState number;
  bool focusName = false;  ///< put the keyboard into the node's name at its next drawing

  /// Is a number being typed or dragged that was drawn in this frame or the last one?
  bool busy() const { return number.shown() && (number.typing != 0 || (number.active != 0 && number.moved)); }
  bool typing() const { return number.shown() && number.typing != 0; }

  /// SetKeyboardFocusHere() for the field that is drawn next; keys wait for it.
  void focusHere();
  /// Keys wait for a field that takes them, `frames` at most.
  void await(int frames);
  /// Shall this event wait for another frame? `command`: it would run one. Between two frames.
  bool holds(const InputEvent& event, bool pointerMoved, bool command);
  /// Something else is about to happen, between two frames. True: wait, a field is to end in the next one.
  bool leave();
  void beginFrame();  ///< behind ImGui::NewFrame()
  /// After everything was drawn. Why something that was typed is lost; "" = nothing is.
  std::string endFrame();

 private:
  bool leaving_ = false, fed_ = false, ended_ = false, nameWaits_ = false;
  int awaitUntil_ = -1;  ///< ImGui's frame
};

}  // namespace pileus::editor
