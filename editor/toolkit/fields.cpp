#include "editor/toolkit/fields.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>  // which item takes text, and which the pointer is over

#include <algorithm>
#include <utility>

#include "editor/toolkit/window.h"

namespace pileus::editor {
namespace {

bool takesText() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.ActiveId != 0 && g.ActiveId == g.InputTextState.ID;
}

bool pointerOverIt() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.HoveredId == g.ActiveId;
}

/// A field may end with these: what follows is for whatever comes then.
bool mayEnd(const InputEvent& event) {
  return event.kind == InputEvent::Kind::Key && event.down &&
         (event.code == GLFW_KEY_TAB || event.code == GLFW_KEY_ENTER || event.code == GLFW_KEY_KP_ENTER ||
          event.code == GLFW_KEY_ESCAPE);
}

}  // namespace

void Fields::focusHere() {
  ImGui::SetKeyboardFocusHere();
  await(kFocusFrames);
}

void Fields::await(int frames) { awaitUntil_ = std::max(awaitUntil_, ImGui::GetFrameCount() + frames); }

bool Fields::holds(const InputEvent& event, bool pointerMoved, bool command) {
  using Kind = InputEvent::Kind;
  const bool text = event.kind == Kind::Key || event.kind == Kind::Char;
  if (takesText()) {
    awaitUntil_ = -1;
    if (ended_) return true;
    const bool pressed = event.kind == Kind::Button && event.down;
    if (pressed && pointerMoved) return true;  // what is below it is known a frame later
    if (command || (pressed && !pointerOverIt())) {
      if (!fed_) leave();  // what was typed is read first
      return true;
    }
    fed_ = fed_ || text;
    ended_ = mayEnd(event);
    return false;
  }
  if (!text) return false;
  const int frame = ImGui::GetFrameCount();
  return frame < awaitUntil_ || (typing() && !number.focused && frame < number.asked + kFocusFrames);
}

bool Fields::leave() {
  if (!takesText()) return false;
  leaving_ = true;
  return true;
}

void Fields::beginFrame() {
  fed_ = ended_ = false;
  if (std::exchange(leaving_, false)) ImGui::ClearActiveID();
}

std::string Fields::endFrame() {
  // Asked for after the panel was drawn, it is for the next frame; after that nobody shows the name.
  if (std::exchange(nameWaits_, focusName) && focusName) focusName = nameWaits_ = false;
  number.last = number.onwards = 0;  // Tab in the last field of a window ends typing
  std::string lost = std::exchange(number.dropped, {});
  if (number.typing != 0 && !number.shown()) {
    if (number.text != number.initial)
      lost = fmt::format("\"{}\" was not taken: its field is gone.", number.text);
    number.typing = 0;
    number.wasRefused = number.focus = false;
  }
  return lost;
}

}  // namespace pileus::editor
