#include "editor/toolkit/question.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

/// Which answer was given this frame; -1: none yet.
int drawAnswers(Ui& ui, const Question& question) {
  int chosen = -1;
  const bool fresh = ImGui::IsWindowAppearing();
  for (std::size_t i = 0; i < question.answers.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const bool primary = i == 0;
    if (primary) {
      ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
      ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kAccentHover);
    }
    const char* label = question.answers[i].label.c_str();
    const float width = std::max(ui.theme.px(112), ImGui::CalcTextSize(label).x + ui.theme.space(6));
    if (ImGui::Button(label, {width, 0})) chosen = static_cast<int>(i);
    if (primary) ImGui::PopStyleColor(2);
    ui.trace.item("dialog/" + question.id + "/" + std::to_string(i));
  }
  if (!fresh && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) chosen = 0;
  if (!fresh && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
    chosen = static_cast<int>(question.answers.size()) - 1;
  return chosen;
}

}  // namespace

void drawQuestions(Ui& ui, Questions& questions) {
  if (!questions.open()) return;
  const Theme& theme = ui.theme;
  if (!ImGui::IsPopupOpen("Question")) ImGui::OpenPopup("Question");
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.46f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(theme.px(520), display.x - theme.space(8)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(5), theme.space(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
  const bool open = ImGui::BeginPopupModal(
      "Question", nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar(2);
  if (!open) return;
  const Question& question = questions.waiting.front();
  ImGui::PushFont(theme.title);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(question.title.c_str());
  ImGui::PopFont();
  ImGui::Dummy({0, theme.px(2)});
  ImGui::TextUnformatted(question.text.c_str());
  ImGui::PopTextWrapPos();
  ui.trace.note("question", question.title + "\n" + question.text);
  ImGui::Dummy({0, theme.space(2)});
  const int chosen = drawAnswers(ui, question);
  std::function<void()> then;
  if (chosen >= 0) {
    then = question.answers[static_cast<std::size_t>(chosen)].run;
    questions.waiting.pop_front();  // before it runs: it may ask the next one
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (then) ui.requests.push(std::move(then));
}

}  // namespace pileus::editor
