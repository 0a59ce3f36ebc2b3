#include "editor/lab/lab.h"

#include "editor/document/session.h"
#include "editor/lab/lab_room.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/segments.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

void toggleTab(Settings& settings, Lab& lab, LabTab tab) {
  settings.showLab = !(settings.showLab && lab.tab == tab);
  lab.tab = tab;
}

}  // namespace

bool labWantsFrame(const Shown& shown, const Lab& lab) {
  return shown.preview.settled() && (lab.shootout.running || lab.tune.running);
}

void stepLab(Ui& ui, const Shown& shown, Lab& lab, double ms) {
  if (!labWantsFrame(shown, lab)) return;
  if (lab.shootout.running) return stepShootout(ui, shown, lab, ms);
  stepTune(ui, shown, lab, ms);
}

void drawLab(const LabRoom& room, ImVec2 min, ImVec2 max) {
  const Theme& theme = room.ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(min, max, palette::kPanel);
  room.ui.trace.rect("lab", min, max);
  const float bar = theme.px(36);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  segments(room.ui, "lab", room.lab.tab);
  ImGui::SameLine(0, theme.space(6));
  const ImVec2 next = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({max.x - bar, min.y});
  if (ImGui::InvisibleButton("lab close", {bar, bar})) room.settings.showLab = false;
  room.ui.trace.item("lab/close");
  drawText(draw, theme.small,
           {max.x - 0.5f * (bar + textWidth(theme.small, icon::kTimes)),
            min.y + 0.5f * (bar - theme.small->FontSize)},
           ImGui::IsItemHovered() ? palette::kText : palette::kTextDim, icon::kTimes, bar);
  const vec2 lo(min.x, min.y + bar), hi = vec(max);
  if (room.lab.tab == LabTab::Shootout)
    ImGui::SetCursorScreenPos(next), drawShootout(room, max.x - bar, lo, hi);
  else
    drawTune(room.ui, room.session, room.shown, room.lab, lo, hi);
}

void toggleShootout(Settings& settings, Lab& lab) { toggleTab(settings, lab, LabTab::Shootout); }
void toggleTune(Settings& settings, Lab& lab) { toggleTab(settings, lab, LabTab::Tune); }

}  // namespace pileus::editor
