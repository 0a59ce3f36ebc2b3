#include "editor/dialogs/modal.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "editor/editor.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui_trace.h"

namespace pileus::editor {

bool beginModal(const Editor& editor, const char* title, bool wanted, float width) {
  if (wanted && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.46f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(editor.theme.px(width), display.x - editor.theme.space(4)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {editor.theme.space(5), editor.theme.space(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, editor.theme.px(8));
  const bool open = ImGui::BeginPopupModal(
      title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar(2);
  return open;
}

void heading(const Editor& editor, const char* text) {
  ImGui::PushFont(editor.theme.title);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  ImGui::Dummy({0, editor.theme.px(2)});
}

bool button(Editor& editor, const char* label, const char* trace, bool primary) {
  if (primary) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kAccentHover);
  }
  const bool pressed = ImGui::Button(label, {editor.theme.px(124), 0});
  if (primary) ImGui::PopStyleColor(2);
  editor.trace.item(std::string("dialog/") + trace);
  return pressed;
}

bool pressedEnter() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) && !ImGui::IsWindowAppearing();
}
bool pressedEscape() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) && !ImGui::IsWindowAppearing();
}

}  // namespace pileus::editor
