#pragma once
// Colours that nodes and frames can be given. Files hold them as "#rrggbb".
#include <imgui.h>

#include <span>
#include <string_view>

namespace pileus::editor {

struct NodeColor {
  const char* id;  ///< "" = none of its own
  const char* label;
};

std::span<const NodeColor> nodeColors();
/// Of any "#rrggbb"; 0 where it is none.
ImU32 nodeColor(std::string_view id);

}  // namespace pileus::editor
