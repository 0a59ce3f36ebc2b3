#pragma once
// What every dialog is made of.
namespace pileus::editor {

struct Editor;

/// Opens when `wanted` and draws a centred modal; call ImGui::EndPopup() when it returns true. `width`:
/// design pixels.
bool beginModal(const Editor& editor, const char* title, bool wanted, float width);
void heading(const Editor& editor, const char* text);
/// Traced as "dialog/TRACE".
bool button(Editor& editor, const char* label, const char* trace, bool primary = false);
bool pressedEnter();
bool pressedEscape();

}  // namespace pileus::editor
