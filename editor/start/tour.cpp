#include "editor/start/tour.h"

#include <imgui.h>
#include <imgui_internal.h>  // FindWindowByName: where the panels are

#include <algorithm>
#include <array>
#include <string>

#include "editor/preferences/settings.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

struct Step {
  const char* panel;  ///< the ImGui window it frames
  const char* title;
  const char* text;
};

constexpr std::array<Step, 4> kSteps = {{
    {"##viewport", "The picture",
     "Drag to look around, turn the wheel to come closer; the picture refines by itself while you look. A "
     "frames all volumes."},
    {"##graph", "The graph",
     "The picture is made here, from left to right: volumes, lights with their shadows, a render and a view. "
     "Tab adds a node, and dragging from one socket to another links them."},
    {"##parameters", "The parameters",
     "They belong to the node you click in the graph. Drag a number to change it, double click to type it; "
     "every change can be undone."},
    {"##viewport", "Compare with the truth",
     "With the pointer on the picture, Tab puts the ray-marched truth beside it, and Shift+E shows the "
     "difference in colours. That is how you see what a shadow map costs in quality."},
}};

void finish(Settings& settings, Tour& tour) {
  tour.step = -1;
  settings.tourSeen = true;
}

/// Everything but the framed place is dimmed.
void drawFrame(const Theme& theme, ImDrawList* draw, const ImRect& place) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  draw->AddRectFilled({0, 0}, {display.x, place.Min.y}, palette::kDim);
  draw->AddRectFilled({0, place.Max.y}, display, palette::kDim);
  draw->AddRectFilled({0, place.Min.y}, {place.Min.x, place.Max.y}, palette::kDim);
  draw->AddRectFilled({place.Max.x, place.Min.y}, {display.x, place.Max.y}, palette::kDim);
  const float inset = theme.px(2);
  draw->AddRect({place.Min.x + inset, place.Min.y + inset}, {place.Max.x - inset, place.Max.y - inset},
                palette::kAccent, theme.px(5), 0, theme.px(3));
}

/// Inside the framed place where it is large, else beside it.
ImVec2 cardPlace(const Theme& theme, const ImRect& place, ImVec2 size) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float gap = theme.space(5);
  ImVec2 at = {place.Min.x + gap, place.Max.y - size.y - gap};
  if (place.GetWidth() < size.x + 3 * gap) at = {place.Min.x - size.x - gap, place.Min.y + gap};
  at.x = std::clamp(at.x, gap, std::max(gap, display.x - size.x - gap));
  at.y = std::clamp(at.y, gap, std::max(gap, display.y - size.y - gap));
  return at;
}

void drawCard(Ui& ui, Settings& settings, Tour& tour, const ImRect& place) {
  const Theme& theme = ui.theme;
  const int at = tour.step, last = static_cast<int>(kSteps.size()) - 1;
  const Step& step = kSteps[static_cast<std::size_t>(at)];
  static ImVec2 size{0, 0};  // of the last frame
  ImGui::SetNextWindowPos(
      cardPlace(ui.theme, place, size.x > 0 ? size : ImVec2(theme.px(380), theme.px(180))));
  ImGui::SetNextWindowSize({theme.px(380), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(5), theme.space(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kPopup);
  ImGui::Begin("##tour", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());  // focus would take the click from its buttons
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  ImGui::PushFont(theme.small);
  ImGui::TextDisabled("%d of %d", at + 1, last + 1);
  ImGui::PopFont();
  ImGui::PushFont(theme.title);
  ImGui::TextUnformatted(step.title);
  ImGui::PopFont();
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(step.text);
  ImGui::PopTextWrapPos();
  ui.trace.note("tour", step.title);
  ImGui::Dummy({0, theme.space(2)});
  const ImVec2 button = {theme.px(88), 0};
  int to = at;
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
  if (ImGui::Button(at == last ? "Done" : "Next", button)) ++to;
  ImGui::PopStyleColor();
  ui.trace.item("tour/next");
  ImGui::SameLine();
  if (at > 0) {
    if (ImGui::Button("Back", button)) --to;
    ui.trace.item("tour/back");
    ImGui::SameLine();
  }
  if (at < last && ImGui::Button("Skip", button)) to = last + 1;
  if (at < last) ui.trace.item("tour/skip");
  size = ImGui::GetWindowSize();
  ImGui::End();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) to = last + 1;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) ++to;
  if (to > last)
    finish(settings, tour);
  else
    tour.step = to;
}

}  // namespace

void startTour(Tour& tour) { tour.step = 0; }

void drawTour(Ui& ui, Settings& settings, Tour& tour) {
  if (!tour.on()) return;
  const ImGuiWindow* panel = ImGui::FindWindowByName(kSteps[static_cast<std::size_t>(tour.step)].panel);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImRect place = panel && panel->WasActive ? panel->Rect() : ImRect({0, 0}, display);
  // Below the card, above everything else: a window of its own.
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(display);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("##tour dim", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  ImGui::PopStyleVar();
  drawFrame(ui.theme, ImGui::GetWindowDrawList(), place);
  ImGui::End();
  drawCard(ui, settings, tour, place);
}

}  // namespace pileus::editor
