#include "editor/toolkit/pointer_rest.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {
namespace {

constexpr double kShort = 0.45, kLong = 1.1;  // seconds

}  // namespace

void updateRest(PointerRest& rest, ImVec2 min, ImVec2 max) {
  const ImGuiIO& io = ImGui::GetIO();
  const double now = ImGui::GetTime();
  rest.inside = ImGui::IsMouseHoveringRect(min, max, false);
  const bool moved = std::abs(io.MousePos.x - rest.at.x) + std::abs(io.MousePos.y - rest.at.y) > 1.5f;
  if (moved || io.MouseWheel != 0.0f || ImGui::IsAnyMouseDown()) rest.at = io.MousePos, rest.since = now;
  rest.short_ = now - rest.since > kShort;
  rest.long_ = now - rest.since > kLong;
}

double helpDueIn(const PointerRest& rest) {
  if (!rest.inside || rest.long_) return 0;
  const double age = ImGui::GetTime() - rest.since;
  return std::max(0.02, (age < kShort ? kShort : kLong) - age + 0.01);
}

}  // namespace pileus::editor
