// The rows of the light list.
#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/lights/lights_panel.h"
#include "editor/lights/lights_room.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

/// The shadow nodes that a light goes through, by their names.
std::string shadowsOf(const nodes::Graph& root, const LightAt& light) {
  const nodes::NodeAt at = nodes::nodeAt(light.path);
  const nodes::Graph* graph = nodes::graphAt(root, at.scope);
  std::string names;
  if (!graph) return names;
  for (const nodes::Link& link : graph->links) {
    const nodes::Node* to = nodes::findNode(*graph, link.toNode);
    if (link.muted || link.fromNode != at.name || !to || !to->type.starts_with("shadow.") || to->bypass)
      continue;
    if (names.find(link.toNode) == names.npos) names += (names.empty() ? "" : ", ") + link.toNode;
  }
  return names;
}

void select(const LightsRoom& room, const std::string& path) {
  const nodes::NodeAt at = nodes::nodeAt(path);
  room.session.document.setScope(at.scope);
  room.session.document.select({at.name});
}

/// Strength as the node has it, to be dragged or typed.
void drawStrength(const LightsRoom& room, const LightAt& light, float width) {
  const nodes::NodeType* type = nodes::findNodeType(light.node->type);
  const nodes::ParamSpec* spec = type ? type->param(lightParams(light.node->type).strength) : nullptr;
  if (!spec) return;
  double value = std::get<double>(nodes::paramValue(*light.node, *spec, room.clock.frame));
  NumberField field;
  field.hardMin = spec->hardMin, field.hardMax = spec->hardMax;
  field.softMin = spec->softMin, field.softMax = spec->softMax;
  field.unit = spec->unit.c_str();
  const NumberEdit edit = numberField(room.ui.fields.number, room.ui.theme, "strength", value, field, width);
  room.ui.trace.item("lights/strength/" + light.path);
  if (edit.changed) {
    tryEditRoot(
        room.session, room.ui.messages,
        nodes::setParamAt(room.session.document.root(), light.path, spec->id, value, room.clock.frame),
        light.path + " " + spec->label, "light list " + light.path);
    if (edit.dragging) room.shown.preview.touch();
  }
  if (edit.finished) room.session.document.endMerge();
}

void drawGroup(const LightsRoom& room, const LightAt& light, float width) {
  LightsPanel& panel = room.panel;
  const bool grouped = light.channel != light.path;
  const bool typing = panel.typing == light.path;
  std::string text = typing ? panel.text : grouped ? light.channel : std::string();
  ImGui::SetNextItemWidth(width);
  ImGui::InputTextWithHint("##group", "no group", &text);
  room.ui.trace.item("lights/group/" + light.path);
  if (ImGui::IsItemActive()) panel.typing = light.path, panel.text = text;
  if (!ImGui::IsItemDeactivated() || !typing) return;
  panel.typing.clear();
  if (!ImGui::IsItemDeactivatedAfterEdit() || text == (grouped ? light.channel : std::string())) return;
  tryEditRoot(room.session, room.ui.messages,
              nodes::setParamAt(room.session.document.root(), light.path, "group", text, room.clock.frame),
              "Group of " + light.path);
  room.session.document.endMerge();
  room.shown.mixer.of.reset();  // its layers belong together in another way
}

/// A swatch of the light's own colour; the parameters have the picker.
void drawColor(const LightsRoom& room, const LightAt& light) {
  const LightParams params = lightParams(light.node->type);
  const nodes::NodeType* type = nodes::findNodeType(light.node->type);
  const nodes::ParamSpec* spec = type && !params.color.empty() ? type->param(params.color) : nullptr;
  dvec3 color = spec ? std::get<dvec3>(nodes::paramValue(*light.node, *spec, room.clock.frame)) : dvec3(1);
  color /= std::max({color.x, color.y, color.z, 1e-9});
  const float height = ImGui::GetFrameHeight();
  const ImVec4 shown = ImGui::ColorConvertU32ToFloat4(displayColor(room.shown, room.panel.colors, color));
  ImGui::ColorButton("color", shown, ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                     {height, height});
  if (ImGui::IsItemClicked()) select(room, light.path);
  if (ImGui::IsItemHovered())
    tooltip(room.ui.theme,
            spec ? "Its colour; a click shows it in the parameters." : "It has no colour of its own.");
}

}  // namespace

void drawLightRows(const LightsRoom& room) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  if (room.panel.lights.empty()) return ImGui::TextDisabled("There are no lights in this document.");
  if (!ImGui::BeginTable("lights", 6, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, theme.px(60));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, theme.px(28));
  ImGui::TableSetupColumn("Light", ImGuiTableColumnFlags_WidthStretch, 3);
  ImGui::TableSetupColumn("Strength", ImGuiTableColumnFlags_WidthStretch, 2.4f);
  ImGui::TableSetupColumn("Group", ImGuiTableColumnFlags_WidthStretch, 2);
  ImGui::TableSetupColumn("Shadow", ImGuiTableColumnFlags_WidthStretch, 2.2f);
  ImGui::TableHeadersRow();
  LightSwitches& switches = room.shown.lights;
  for (const LightAt& light : room.panel.lights) {
    ImGui::PushID(light.path.c_str());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const auto in = [&](const std::vector<std::string>& list) {
      return std::find(list.begin(), list.end(), light.path) != list.end();
    };
    if (litButton(ui, "M", in(switches.muted), palette::kWarning, "lights/mute/" + light.path,
                  "Mute: the viewport renders as if it gave nothing. The document stays."))
      toggle(switches.muted, light.path);
    ImGui::SameLine(0, theme.px(4));
    if (litButton(ui, "S", in(switches.solo), palette::kAccentDim, "lights/solo/" + light.path,
                  "Solo: it, and others that are solo, alone in the viewport."))
      toggle(switches.solo, light.path);
    ImGui::TableNextColumn();
    drawColor(room, light);
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const bool selected = room.session.document.selection().contains(nodes::nodeAt(light.path).name);
    if (ImGui::Selectable(light.path.c_str(), selected)) select(room, light.path);
    ui.trace.item("lights/name/" + light.path);
    if (const nodes::NodeType* type = nodes::findNodeType(light.node->type); type && ImGui::IsItemHovered())
      tooltip(theme, type->label + ". A click selects it.");
    ImGui::TableNextColumn();
    drawStrength(room, light, ImGui::GetContentRegionAvail().x);
    ImGui::TableNextColumn();
    drawGroup(room, light, -1);
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const std::string shadows = shadowsOf(room.session.document.root(), light);
    ImGui::TextDisabled("%s", shadows.empty() ? "none" : shadows.c_str());
    ImGui::PopID();
  }
  ImGui::EndTable();
}

}  // namespace pileus::editor
