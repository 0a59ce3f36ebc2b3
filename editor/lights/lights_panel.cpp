#include "editor/lights/lights_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include "editor/document/session.h"
#include "editor/lights/lights_room.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

constexpr float kBar = 36, kLeastForBoth = 900;  // design pixels

void follow(const LightsRoom& room) {
  LightsPanel& panel = room.panel;
  const nodes::Document& document = room.session.document;
  if (panel.revision == document.revision() && panel.generation == room.session.generation) return;
  panel.revision = document.revision(), panel.generation = room.session.generation;
  panel.lights = lightsOf(document.root());
}

bool closeButton(Ui& ui, ImVec2 min, ImVec2 max, float bar) {
  ImGui::SetCursorScreenPos({max.x - bar, min.y});
  const bool pressed = ImGui::InvisibleButton("lights close", {bar, bar});
  ui.trace.item("lights/close");
  drawText(ImGui::GetWindowDrawList(), ui.theme.small,
           {max.x - 0.5f * (bar + textWidth(ui.theme.small, icon::kTimes)),
            min.y + 0.5f * (bar - ui.theme.small->FontSize)},
           ImGui::IsItemHovered() ? palette::kText : palette::kTextDim, icon::kTimes, bar);
  return pressed;
}

/// What the mixer is doing, in words.
std::string stateOf(const Shown& shown) {
  const LightMixer& mixer = shown.mixer;
  if (!mixer.on) return {};
  if (!mixer.error.empty()) return "Not mixed: " + mixer.error + ".";
  const auto& picture = shown.preview.rendered();
  if (!picture || picture->layers.empty())
    return fmt::format("Rendering a layer for each light, {:.0f} %: the mix is heard then.",
                       100 * shown.preview.fraction());
  return mixer.neutral() ? "" : "The viewport shows the mix. Apply writes it into the lights.";
}

void drawBar(const LightsRoom& room) {
  Ui& ui = room.ui;
  LightMixer& mixer = room.shown.mixer;
  if (ImGui::Checkbox("Mixer", &mixer.on)) room.shown.preview.touch();
  ui.trace.item("lights/mixer");
  if (ImGui::IsItemHovered())
    tooltip(
        ui.theme,
        "Keeps what each group of lights gives as a layer of the picture. Exposure and colour then change it "
        "at once, without rendering.");
  ImGui::SameLine(0, ui.theme.space(3));
  ImGui::BeginDisabled(!mixer.writes());
  if (ImGui::Button("Apply")) ui.requests.push(RunCommand{"lights.apply"});
  ui.trace.item("lights/apply");
  ImGui::EndDisabled();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    tooltip(ui.theme, "Writes exposure and colour of each group into its lights: one undo step.");
  ImGui::SameLine();
  ImGui::BeginDisabled(mixer.neutral() && !room.shown.lights.any());
  if (ImGui::Button("Reset")) ui.requests.push(RunCommand{"lights.reset"});
  ui.trace.item("lights/reset");
  ImGui::EndDisabled();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    tooltip(ui.theme, "All lights as they are in the document, none muted or alone.");
  ImGui::SameLine(0, ui.theme.space(3));
  ImGui::AlignTextToFramePadding();
  const std::string state = stateOf(room.shown);
  ImGui::TextDisabled("%s", state.c_str());
  ui.trace.note("lights/state", state);
}

}  // namespace

bool litButton(Ui& ui, const char* letter, bool on, unsigned ink, const std::string& trace,
               const char* help) {
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ink);
  const bool pressed = ImGui::Button(letter, {ui.theme.px(26), 0});
  if (on) ImGui::PopStyleColor();
  ui.trace.item(trace);
  if (ImGui::IsItemHovered()) tooltip(ui.theme, help);
  return pressed;
}

void drawLights(const LightsRoom& room, ImVec2 min, ImVec2 max) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  follow(room);
  updateDisplayColors(room.shown, room.panel.colors);
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  ui.trace.rect("lights", min, max);
  const float bar = theme.px(kBar), pad = theme.space(2);
  if (closeButton(ui, min, max, bar)) room.settings.showLights = false;
  ImGui::SetCursorScreenPos({min.x + pad, min.y + theme.px(5)});
  drawBar(room);
  const bool both = room.shown.mixer.on && max.x - min.x >= theme.px(kLeastForBoth);
  const float width = max.x - min.x - 2 * pad, height = max.y - min.y - bar - pad;
  ImGui::SetCursorScreenPos({min.x + pad, min.y + bar});
  ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, palette::kPanel);
  if (!room.shown.mixer.on || both) {
    ImGui::BeginChild("lights", {both ? 0.56f * width : width, height});
    drawLightRows(room);
    ImGui::EndChild();
  }
  if (room.shown.mixer.on) {
    if (both) ImGui::SameLine(0, theme.space(4));
    ImGui::BeginChild("mixer", {max.x - pad - ImGui::GetCursorScreenPos().x, height});
    drawMixerRows(room);
    ImGui::EndChild();
  }
  ImGui::PopStyleColor();
}

}  // namespace pileus::editor
