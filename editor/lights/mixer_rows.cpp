// The rows of the light mixer.
#include <imgui.h>

#include <algorithm>

#include "editor/lights/lights_panel.h"
#include "editor/lights/lights_room.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "renderer/scene/light.h"

namespace pileus::editor {
namespace {

std::vector<std::string> channelsOf(const LightsPanel& panel) {
  std::vector<std::string> all;
  for (const LightAt& light : panel.lights)
    if (std::find(all.begin(), all.end(), light.channel) == all.end()) all.push_back(light.channel);
  return all;
}

void drawExposure(Ui& ui, const std::string& channel, ChannelMix& mix) {
  NumberField field;
  field.hardMin = -40, field.hardMax = 40, field.softMin = -6, field.softMax = 6;
  field.unit = "stops";
  numberField(ui.fields.number, ui.theme, "exposure", mix.exposure, field, ImGui::GetContentRegionAvail().x);
  ui.trace.item("mixer/exposure/" + channel);
}

/// Three gains; a temperature typed into one of them sets all.
void drawColor(Ui& ui, const std::string& channel, ChannelMix& mix) {
  const char* const ids[] = {"red", "green", "blue"};
  const ImU32 marks[] = {palette::kAxisX, palette::kAxisY, palette::kAxisZ};
  const float gap = ui.theme.px(4), width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    NumberField field;
    field.hardMin = 0, field.hardMax = 1e6, field.softMin = 0, field.softMax = 2;
    field.takesKelvin = true;
    field.mark = marks[i];
    const NumberEdit edit = numberField(ui.fields.number, ui.theme, ids[i], mix.color[i], field, width);
    if (edit.kelvin) mix.color = dvec3(scene::temperatureColor(*edit.kelvin));
    ui.trace.item(std::string("mixer/") + ids[i] + "/" + channel);
  }
}

}  // namespace

void drawMixerRows(const LightsRoom& room) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  LightMixer& mixer = room.shown.mixer;
  const std::vector<std::string> channels = channelsOf(room.panel);
  if (channels.empty()) return ImGui::TextDisabled("There are no lights to mix.");
  if (!ImGui::BeginTable("mixer", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, theme.px(60));
  ImGui::TableSetupColumn("Group", ImGuiTableColumnFlags_WidthStretch, 2);
  ImGui::TableSetupColumn("Exposure", ImGuiTableColumnFlags_WidthStretch, 2.4f);
  ImGui::TableSetupColumn("Colour", ImGuiTableColumnFlags_WidthStretch, 3.2f);
  ImGui::TableHeadersRow();
  for (const std::string& channel : channels) {
    const auto it = mixer.channels.find(channel);
    ChannelMix mix = it == mixer.channels.end() ? ChannelMix{} : it->second;
    ImGui::PushID(channel.c_str());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (litButton(ui, "M", mix.muted, palette::kWarning, "mixer/mute/" + channel,
                  "Mute this group, at once."))
      mix.muted = !mix.muted;
    ImGui::SameLine(0, theme.px(4));
    if (litButton(ui, "S", mix.solo, palette::kAccentDim, "mixer/solo/" + channel,
                  "Solo: this group, and others that are solo, alone."))
      mix.solo = !mix.solo;
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(channel.c_str());
    ImGui::TableNextColumn();
    drawExposure(ui, channel, mix);
    ImGui::TableNextColumn();
    drawColor(ui, channel, mix);
    ImGui::PopID();
    if (it != mixer.channels.end() && mix == ChannelMix{})
      mixer.channels.erase(it);
    else if (!(mix == ChannelMix{}))
      mixer.channels[channel] = mix;
  }
  ImGui::EndTable();
}

}  // namespace pileus::editor
