#pragma once
// Small widgets the panels share, over ImGui's.
#include <imgui.h>

#include <string>
#include <string_view>

#include "editor/toolkit/theme.h"

namespace pileus::editor {

struct Theme;

/// ImGui::BeginCombo in the editor's look: a field with a quiet chevron. EndCombo as usual.
bool beginCombo(const Theme& theme, const char* id, std::string_view shown, float width);
/// A wrapped tooltip.
void tooltip(const Theme& theme, std::string_view text, ImU32 ink = palette::kText);
/// After everything was drawn: the whole of a text below the pointer that was cut, unless a tooltip says it.
/// Returns what it says; "" = nothing.
std::string tellCutText(const Theme& theme);

}  // namespace pileus::editor
