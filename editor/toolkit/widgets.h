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

}  // namespace pileus::editor
