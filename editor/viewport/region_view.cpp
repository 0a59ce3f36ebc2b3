#include "editor/viewport/region_view.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/picture/shown.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

void dimAround(vec2 lo, vec2 hi, vec2 a, vec2 b) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 ink = IM_COL32(0, 0, 0, 130);
  draw->AddRectFilled(im(lo), {hi.x, a.y}, ink);
  draw->AddRectFilled({lo.x, b.y}, im(hi), ink);
  draw->AddRectFilled({lo.x, a.y}, {a.x, b.y}, ink);
  draw->AddRectFilled({b.x, a.y}, {hi.x, b.y}, ink);
}

/// The drag that draws a region, from its press to its release.
void dragRegion(const Theme& theme, Shown& shown, vec2 lo, vec2 hi, bool hovered) {
  RegionMode& mode = shown.mode.region;
  const ImGuiIO& io = ImGui::GetIO();
  const dvec2 at =
      glm::clamp(dvec2((vec(io.MousePos) - lo) / glm::max(hi - lo, vec2(1))), dvec2(0), dvec2(1));
  if (hovered || mode.from) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!mode.from) {
    if (hovered && ImGui::IsMouseClicked(0)) mode.from = at;
    return;
  }
  const view::PictureRegion drawn{glm::min(*mode.from, at), glm::max(*mode.from, at)};
  const vec2 a = lo + vec2(drawn.min) * (hi - lo), b = lo + vec2(drawn.max) * (hi - lo);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(a), im(b), faded(palette::kAccent, 0.15f));
  draw->AddRect(im(a), im(b), palette::kAccent);
  if (ImGui::IsMouseDown(0)) return;
  mode.from.reset();
  mode.drawing = false;
  // A click is no region: it leaves things as they were.
  if (b.x - a.x < theme.px(8) || b.y - a.y < theme.px(8)) return;
  mode.region = drawn;
  mode.on = true;
}

void drawClose(Ui& ui, Shown& shown, vec2 corner) {
  const Theme& theme = ui.theme;
  const float side = theme.px(18);
  const ImVec2 at{corner.x - side - theme.px(3), corner.y + theme.px(3)};
  ImGui::SetCursorScreenPos(at);
  const bool clicked = ImGui::InvisibleButton("##region close", {side, side});
  const bool hovered = ImGui::IsItemHovered();
  ui.trace.item("region/close");
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, {at.x + side, at.y + side}, palette::kChip, theme.px(4));
  drawText(draw, theme.small,
           {at.x + 0.5f * (side - textWidth(theme.small, icon::kTimes)),
            at.y + 0.5f * (side - theme.small->FontSize)},
           hovered ? palette::kText : palette::kTextDim, icon::kTimes, side);
  if (hovered) tooltip(theme, "Render the whole picture again (Alt+C)");
  if (clicked) shown.mode.region.on = false;
}

}  // namespace

void drawRegionView(Ui& ui, Shown& shown, vec2 lo, vec2 hi, bool hovered) {
  RegionMode& mode = shown.mode.region;
  if (mode.on) {
    const vec2 a = glm::round(lo + vec2(mode.region.min) * (hi - lo)),
               b = glm::round(lo + vec2(mode.region.max) * (hi - lo));
    dimAround(lo, hi, a, b);
    ImGui::GetWindowDrawList()->AddRect({a.x - 1, a.y - 1}, {b.x + 1, b.y + 1}, palette::kAccent);
    ui.trace.rect("region", im(a), im(b));
    if (!mode.drawing) drawClose(ui, shown, {b.x, a.y});
  }
  if (mode.drawing) dragRegion(ui.theme, shown, lo, hi, hovered);
}

bool cancelRegion(Shown& shown) {
  RegionMode& mode = shown.mode.region;
  const bool was = mode.drawing || mode.from;
  mode.drawing = false;
  mode.from.reset();
  return was;
}

}  // namespace pileus::editor
