#include "editor/viewport/wipe_line.h"

#include <algorithm>
#include <cmath>

#include "editor/picture/snapshots.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/viewport.h"

namespace pileus::editor {

void moveWipeLine(const Theme& theme, const Viewport& viewport, WipeLine& line, vec2 lo, vec2 hi,
                  bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const float x = glm::mix(lo.x, hi.x, static_cast<float>(line.at));
  const bool near =
      hovered && std::abs(io.MousePos.x - x) < theme.px(7) && io.MousePos.y >= lo.y && io.MousePos.y < hi.y;
  if (near && ImGui::IsMouseClicked(0) && viewport.drag == Viewport::Drag::None) line.held = true;
  if (!ImGui::IsMouseDown(0)) line.held = false;
  if (near || line.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (line.held)
    line.at = std::clamp(static_cast<double>((io.MousePos.x - lo.x) / std::max(hi.x - lo.x, 1.0f)), 0.0, 1.0);
}

void drawWipeLine(Ui& ui, const WipeLine& line, vec2 lo, vec2 hi, const char* trace) {
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float x = std::round(glm::mix(lo.x, hi.x, static_cast<float>(line.at))),
              y = std::round(0.5f * (lo.y + hi.y));
  const float r = theme.px(9), a = theme.px(3);
  const ImU32 ink = line.held ? palette::kAccent : palette::kHandle;
  draw->AddRectFilled({x - theme.px(1), lo.y}, {x + theme.px(1), hi.y}, ink);
  draw->AddCircleFilled({x, y}, r + 1, palette::kHandleEdge);
  draw->AddCircleFilled({x, y}, r, ink);
  for (const float side : {-1.0f, 1.0f})
    draw->AddTriangleFilled({x + side * (a + theme.px(3)), y}, {x + side * a * 0.6f, y - a},
                            {x + side * a * 0.6f, y + a}, palette::kPanel);
  ui.trace.rect(trace, {x - theme.px(2), lo.y}, {x + theme.px(2), hi.y});
}

}  // namespace pileus::editor
