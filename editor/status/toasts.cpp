#include "editor/status/toasts.h"

#include <algorithm>
#include <string>
#include <vector>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

constexpr float kWidth = 340;
constexpr double kFadeMs = 300;

struct Wish {
  int dismissed = 0;
  std::string command;
};

ImU32 inkOf(log::Level level) {
  return level == log::Level::Error     ? palette::kError
         : level == log::Level::Warning ? palette::kWarning
                                        : palette::kAccent;
}

void drawText(const Theme& theme, const Notice& notice, float right) {
  const char* mark = notice.level == log::Level::Error     ? icon::kError
                     : notice.level == log::Level::Warning ? icon::kWarning
                                                           : icon::kInfo;
  ImGui::PushStyleColor(ImGuiCol_Text, inkOf(notice.level));
  ImGui::TextUnformatted(mark);
  ImGui::PopStyleColor();
  ImGui::SameLine(theme.space(9));
  ImGui::PushTextWrapPos(right);
  ImGui::TextUnformatted(notice.text.c_str());
  ImGui::PopTextWrapPos();
}

/// Returns its height.
float drawOne(Ui& ui, const Notice& notice, ImVec2 corner, Wish& wish) {
  const Theme& theme = ui.theme;
  const std::string id = "##notice" + std::to_string(notice.id), trace = "toast/" + std::to_string(notice.id);
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSize({theme.px(kWidth), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(3), theme.space(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha,
                      static_cast<float>(std::clamp(notice.msLeft() / kFadeMs, 0.0, 1.0)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kPopup);
  ImGui::Begin(id.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleColor();
  const float close = theme.px(20);
  drawText(ui.theme, notice, theme.px(kWidth) - theme.space(3) - close);
  const ImVec2 min = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  if (!notice.command.empty()) {
    ImGui::SetCursorPosX(theme.space(9));
    if (ImGui::Button(notice.button.c_str())) wish = {notice.id, notice.command};
    ui.trace.item(trace + "/button");
  }
  if (ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) {
    ui.messages.hold(notice.id);
    if (!notice.command.empty()) ImGui::SameLine();
    if (notice.command.empty()) ImGui::SetCursorPosX(theme.space(9));
    if (ImGui::SmallButton("Copy text")) ImGui::SetClipboardText(notice.text.c_str());
    ui.trace.item(trace + "/copy");
  }
  ImGui::SetCursorScreenPos({min.x + size.x - theme.space(2) - close, min.y + theme.space(2)});
  if (ImGui::InvisibleButton("close", {close, close})) wish.dismissed = notice.id;
  ui.trace.item(trace + "/close");
  const ImU32 ink = ImGui::IsItemHovered() ? palette::kText : palette::kTextFaint;
  const ImVec2 x = ImGui::GetItemRectMin();
  editor::drawText(ImGui::GetWindowDrawList(), theme.small, {x.x + theme.px(4), x.y + theme.px(1)}, ink,
                   icon::kTimes, close);
  // A click anywhere else on an error says that it was read.
  if (notice.level == log::Level::Error && ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered() &&
      ImGui::IsMouseReleased(0))
    wish.dismissed = notice.id;
  ImGui::GetWindowDrawList()->AddRectFilled({min.x, min.y + theme.px(6)},
                                            {min.x + theme.px(3), min.y + size.y - theme.px(6)},
                                            inkOf(notice.level), theme.px(2));
  ui.trace.rect(trace, min, {min.x + size.x, min.y + size.y});
  ui.trace.note(trace, notice.text);
  ImGui::End();
  ImGui::PopStyleVar(4);
  return size.y;
}

}  // namespace

void drawToasts(Ui& ui, ImVec2 corner) {
  ui.messages.dropOld();
  if (ui.messages.notices().empty()) return;
  const float gap = ui.theme.space(2);
  corner = {corner.x - ui.theme.space(3), corner.y - ui.theme.space(3)};
  Wish wish;
  for (auto n = ui.messages.notices().rbegin(); n != ui.messages.notices().rend(); ++n)
    corner.y -= drawOne(ui, *n, corner, wish) + gap;
  if (wish.dismissed) ui.messages.dismiss(wish.dismissed);
  if (!wish.command.empty()) ui.requests.push(RunCommand{wish.command});
}

}  // namespace pileus::editor
