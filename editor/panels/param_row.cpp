#include "editor/panels/param_row.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/icons.h"
#include "editor/widgets.h"

namespace pileus::editor {
namespace {

using nodes::ParamSpec;
using nodes::ParamType;
using nodes::ParamValue;

constexpr const ImU32* kAxisColors[3] = {&palette::kAxisX, &palette::kAxisY, &palette::kAxisZ};

struct Row {
  Editor& editor;
  const std::string& node;
  const ParamSpec& spec;
  float width;
  std::string key() const { return node + "." + spec.id; }
};

void set(const Row& row, const ParamValue& value, bool dragging) {
  tryEdit(row.editor, nodes::setParam(row.editor.document.graph(), row.node, row.spec.id, value),
          "Set " + row.key(), dragging ? "param " + row.key() : "");
}

NumberField numbers(const ParamSpec& spec) {
  NumberField f;
  f.softMin = spec.softMin, f.softMax = spec.softMax;
  f.hardMin = spec.hardMin, f.hardMax = spec.hardMax;
  f.integer = spec.type == ParamType::Int;
  f.logarithmic = spec.logarithmic;
  f.unit = spec.unit.c_str();
  return f;
}

void after(const Row& row, const NumberEdit& edit, const ParamValue& value) {
  if (edit.changed) set(row, value, edit.dragging);
  if (edit.dragging) row.editor.preview.touch();
  if (edit.finished) row.editor.document.endMerge();
  Parameters& panel = row.editor.parameters;
  if (edit.refused)
    panel.refusedKey = row.key(), panel.refusedAt = ImGui::GetTime();
  else if (edit.changed)
    panel.refusedKey.clear();
}

void drawNumber(const Row& row, const ParamValue& value) {
  const bool integer = row.spec.type == ParamType::Int;
  double number = integer ? std::get<int>(value) : std::get<double>(value);
  const NumberEdit edit = numberField(row.editor.parameters.numbers, row.editor.theme, row.spec.id.c_str(),
                                      number, numbers(row.spec), row.width);
  if (integer)
    after(row, edit, static_cast<int>(number));
  else
    after(row, edit, number);
}

void drawThree(const Row& row, const ParamValue& value, float width) {
  dvec3 v = std::get<dvec3>(value);
  const float gap = row.editor.theme.px(4), each = std::floor((width - 2 * gap) / 3);
  for (int i = 0; i < 3; ++i) {
    NumberField f = numbers(row.spec);
    f.unit = "";
    f.mark = *kAxisColors[i];
    ImGui::PushID(i);
    const NumberEdit edit = numberField(row.editor.parameters.numbers, row.editor.theme, row.spec.id.c_str(),
                                        v[i], f, i < 2 ? each : width - 2 * (each + gap));
    row.editor.trace.item("param/" + row.spec.id + "/" + std::to_string(i));
    ImGui::PopID();
    if (i < 2) ImGui::SameLine(0, gap);
    after(row, edit, v);
  }
}

float encoded(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; }
float decoded(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

/// A swatch that opens a picker, and the linear numbers. The picker works on the encoded colour below 1 and
/// keeps what is above as a factor.
void drawColor(const Row& row, const ParamValue& value) {
  const Theme& theme = row.editor.theme;
  const dvec3 linear = std::get<dvec3>(value);
  const double strength = std::max({1.0, linear.x, linear.y, linear.z});
  float shown[3];
  for (int i = 0; i < 3; ++i) shown[i] = encoded(static_cast<float>(std::max(linear[i], 0.0) / strength));
  const float swatch = ImGui::GetFrameHeight() * 1.3f;
  if (ImGui::ColorButton("##swatch", {shown[0], shown[1], shown[2], 1},
                         ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                         {swatch, ImGui::GetFrameHeight()}))
    ImGui::OpenPopup("picker");
  ImGui::SameLine(0, theme.px(4));
  drawThree(row, value, row.width - swatch - theme.px(4));
  if (ImGui::BeginPopup("picker")) {
    ImGui::SetNextItemWidth(theme.px(220));
    if (ImGui::ColorPicker3("##picker", shown,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoInputs |
                                ImGuiColorEditFlags_PickerHueBar)) {
      dvec3 next;
      for (int i = 0; i < 3; ++i)
        next[i] = std::clamp(std::round(static_cast<double>(decoded(shown[i])) * strength * 1e4) / 1e4,
                             row.spec.hardMin, row.spec.hardMax);
      set(row, next, true);
      row.editor.preview.touch();
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) row.editor.document.endMerge();
    ImGui::EndPopup();
  }
}

void drawEnum(const Row& row, const ParamValue& value) {
  const std::string& id = std::get<std::string>(value);
  const nodes::Choice* current = nullptr;
  for (const nodes::Choice& c : row.spec.choices)
    if (c.id == id) current = &c;
  if (!beginCombo(row.editor.theme, "##combo", current ? current->label : id, row.width)) return;
  for (const nodes::Choice& c : row.spec.choices) {
    if (ImGui::Selectable(c.label.c_str(), &c == current)) set(row, c.id, false);
    row.editor.trace.item("choice/" + c.id);
    if (!c.help.empty() && ImGui::IsItemHovered()) tooltip(row.editor.theme, c.help);
  }
  ImGui::EndCombo();
}

void drawText(const Row& row, const ParamValue& value, float width) {
  Parameters& panel = row.editor.parameters;
  const bool editing = panel.textKey == row.key();
  std::string text = editing ? panel.text : std::get<std::string>(value);
  ImGui::SetNextItemWidth(width);
  const bool enter = ImGui::InputText("##text", &text, ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemActive()) panel.textKey = row.key(), panel.text = text;
  if (enter || ImGui::IsItemDeactivatedAfterEdit()) set(row, text, false);
  if (editing && !ImGui::IsItemActive()) panel.textKey.clear();
}

void drawFile(const Row& row, const ParamValue& value) {
  Editor& editor = row.editor;
  const float button = ImGui::GetFrameHeight() + editor.theme.px(4);
  drawText(row, value, row.width - button - editor.theme.px(4));
  ImGui::SameLine(0, editor.theme.px(4));
  if (ImGui::Button(icon::kFolderOpen, {button, 0})) {
    const std::filesystem::path folder = editor.document.path().parent_path();
    std::filesystem::path start = std::get<std::string>(value);
    if (start.is_relative() && !start.empty()) start = folder / start;
    BrowserRequest request;
    request.title = row.spec.label + " of " + row.node;
    request.button = "Choose";
    request.saving = row.spec.writes;
    request.start = start;
    if (!row.spec.fileKinds.empty()) request.kinds = {row.spec.fileKinds};
    request.done = [&editor, node = row.node, param = row.spec.id](const std::filesystem::path& path) {
      tryEdit(editor, nodes::setParam(editor.document.graph(), node, param, path.string()),
              "Set " + node + "." + param);
    };
    editor.browser.open(editor, std::move(request));
  }
  editor.trace.item("browse/" + row.spec.id);
}

void drawWidget(const Row& row, const ParamValue& value) {
  switch (row.spec.type) {
    case ParamType::Bool: {
      bool on = std::get<bool>(value);
      ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
      if (ImGui::Checkbox("##bool", &on)) set(row, on, false);
      ImGui::PopStyleVar();
      break;
    }
    case ParamType::Int:
    case ParamType::Float:
      drawNumber(row, value);
      break;
    case ParamType::Vector:
      drawThree(row, value, row.width);
      break;
    case ParamType::Color:
      drawColor(row, value);
      break;
    case ParamType::Text:
      drawText(row, value, row.width);
      break;
    case ParamType::File:
      drawFile(row, value);
      break;
    case ParamType::Enum:
      drawEnum(row, value);
      break;
  }
}

void drawHelp(const Theme& theme, const ParamSpec& spec) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(theme.px(320));
  if (!spec.help.empty()) ImGui::TextUnformatted(spec.help.c_str());
  std::string facts;
  const bool numeric = spec.type == ParamType::Int || spec.type == ParamType::Float ||
                       spec.type == ParamType::Vector || spec.type == ParamType::Color;
  const bool whole = spec.type == ParamType::Int;
  if (numeric && spec.hardMin > -1e9)
    facts += fmt::format("{} to {}{}{}, ", numberText(spec.hardMin, whole), numberText(spec.hardMax, whole),
                         spec.unit.empty() ? "" : " ", spec.unit);
  const std::string fallback = nodes::formatParam(spec, spec.fallback);
  facts += "default " + (fallback.empty() ? std::string("empty") : fallback);
  ImGui::PushFont(theme.small);
  ImGui::TextDisabled("%s", facts.c_str());
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

float beginRow(const Editor& editor, const std::string& label, bool modified, bool* reset) {
  const Theme& theme = editor.theme;
  const float all = ImGui::GetContentRegionAvail().x, labels = std::floor(all * 0.42f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), dot = theme.px(12);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (modified) {
    if (ImGui::InvisibleButton("##reset", {dot, height}) && reset) *reset = true;
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ImGui::SetTooltip("Changed; click to reset");
    draw->AddCircleFilled({at.x + theme.px(4), at.y + 0.5f * height}, theme.px(hovered ? 4.0f : 2.5f),
                          palette::kAccent);
  }
  editor::drawText(draw, theme.body, {at.x + dot, at.y + 0.5f * (height - theme.body->FontSize)},
                   modified ? palette::kText : palette::kTextDim, label, labels - dot - theme.space(2));
  ImGui::SetCursorScreenPos({at.x + labels, at.y});
  return all - labels;
}

void drawParamRow(Editor& editor, const std::string& name, const ParamSpec& spec) {
  const nodes::Node* node = nodes::findNode(editor.document.graph(), name);
  if (!node) return;
  const ParamValue value = nodes::paramValue(*node, spec);
  const bool modified = node->params.contains(spec.id),
             animated = node->unknown.contains("params/" + spec.id);
  ImGui::PushID(spec.id.c_str());
  const ImVec2 start = ImGui::GetCursorScreenPos();
  bool reset = false;
  const Row row{editor, name, spec, beginRow(editor, spec.label, modified || animated, &reset)};
  if (animated) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("animated in the file");
  } else {
    ImGui::BeginGroup();
    drawWidget(row, value);
    ImGui::EndGroup();
  }
  editor.trace.item("param/" + spec.id);
  const ImVec2 lo = start, hi = {ImGui::GetItemRectMax().x, start.y + ImGui::GetFrameHeight()};
  const bool hovered =
      ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect({lo.x + editor.theme.px(14), lo.y}, hi);
  if (hovered && ImGui::IsMouseReleased(1)) ImGui::OpenPopup("row menu");
  const bool busy = ImGui::IsAnyItemActive() || editor.parameters.numbers.typing != 0;
  if (hovered && !busy && ImGui::GetIO().MousePos.x < lo.x + (hi.x - lo.x) * 0.41f)
    drawHelp(editor.theme, spec);
  if (ImGui::BeginPopup("row menu")) {
    if (ImGui::MenuItem("Reset to Default", nullptr, false, modified)) reset = true;
    editor.trace.item("row menu/reset");
    if (ImGui::MenuItem("Copy Value")) ImGui::SetClipboardText(nodes::formatParam(spec, value).c_str());
    ImGui::EndPopup();
  }
  const Parameters& panel = editor.parameters;
  if (panel.refusedKey == row.key() && ImGui::GetTime() - panel.refusedAt < 8) {
    ImGui::PushTextWrapPos();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::TextUnformatted(panel.numbers.refusal.c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    editor.trace.note("refusal", panel.numbers.refusal);
  }
  ImGui::PopID();
  if (reset) set(row, spec.fallback, false);
}

}  // namespace pileus::editor
