#include "editor/lab/lab.h"

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/segments.h"

namespace pileus::editor {
namespace {

void toggleTab(Editor& editor, LabTab tab) {
  editor.settings.showLab = !(editor.settings.showLab && editor.lab.tab == tab);
  editor.lab.tab = tab;
}

}  // namespace

bool labWantsFrame(const Editor& editor) {
  return editor.preview.settled() && (editor.lab.shootout.running || editor.lab.tune.running);
}

void stepLab(Editor& editor, double ms) {
  if (!labWantsFrame(editor)) return;
  if (editor.lab.shootout.running) return stepShootout(editor, ms);
  stepTune(editor, ms);
}

void drawLab(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(min, max, palette::kPanel);
  editor.trace.rect("lab", min, max);
  const float bar = theme.px(36);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  segments(editor, "lab", editor.lab.tab);
  ImGui::SameLine(0, theme.space(6));
  const ImVec2 next = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({max.x - bar, min.y});
  if (ImGui::InvisibleButton("lab close", {bar, bar})) editor.settings.showLab = false;
  editor.trace.item("lab/close");
  drawText(draw, theme.small,
           {max.x - 0.5f * (bar + textWidth(theme.small, icon::kTimes)),
            min.y + 0.5f * (bar - theme.small->FontSize)},
           ImGui::IsItemHovered() ? palette::kText : palette::kTextDim, icon::kTimes, bar);
  const vec2 lo(min.x, min.y + bar), hi = vec(max);
  if (editor.lab.tab == LabTab::Shootout)
    ImGui::SetCursorScreenPos(next), drawShootout(editor, max.x - bar, lo, hi);
  else
    drawTune(editor, lo, hi);
}

void toggleShootout(Editor& editor) { toggleTab(editor, LabTab::Shootout); }
void toggleTune(Editor& editor) { toggleTab(editor, LabTab::Tune); }

}  // namespace pileus::editor
