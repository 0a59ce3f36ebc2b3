#include "editor/parameters/param_help.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/parameters/parameters.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

using nodes::ParamSpec;
using nodes::ParamType;

bool numeric(const ParamSpec& s) {
  return s.type == ParamType::Int || s.type == ParamType::Float || s.type == ParamType::Vector ||
         s.type == ParamType::Color;
}

std::string kindOf(const ParamSpec& s) {
  switch (s.type) {
    case ParamType::Bool:
      return "on or off";
    case ParamType::Int:
      return "whole number";
    case ParamType::Float:
      return "number";
    case ParamType::Vector:
      return "three numbers";
    case ParamType::Color:
      return "colour in the working space";
    case ParamType::Text:
      return "text";
    case ParamType::File:
      return s.fileKinds.empty() ? "file" : fmt::format("{} file", fmt::join(s.fileKinds, " or "));
    case ParamType::Enum:
      return "choice";
    case ParamType::Curve:
      return "curve";
    case ParamType::Ramp:
      return "colour ramp in the working space";
  }
  return "";
}

/// "number in m, default 0.5, 0 to 100 (drag: 0 to 10)".
std::string facts(const ParamSpec& s) {
  std::string text = kindOf(s);
  if (!s.unit.empty()) text += " in " + s.unit;
  std::string fallback = nodes::formatParam(s, s.fallback);
  for (const nodes::Choice& c : s.choices)
    if (c.id == fallback) fallback = c.label;
  text += ", default " + (fallback.empty() ? std::string("empty") : fallback);
  if (!numeric(s)) return text;
  const bool whole = s.type == ParamType::Int;
  const auto range = [&](double lo, double hi) {
    return numberText(lo, whole) + " to " + numberText(hi, whole);
  };
  const bool hard = s.hardMin > -1e9 || s.hardMax < 1e9;
  if (hard) text += ", " + range(s.hardMin, s.hardMax);
  if (s.softMax > s.softMin && (s.softMin != s.hardMin || s.softMax != s.hardMax))
    text += fmt::format("{} {} by dragging", hard ? "," : ", any value;", range(s.softMin, s.softMax));
  return text;
}

void colored(ImU32 ink, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void labelAndId(const Theme& theme, const std::string& label, const std::string& id) {
  ImGui::PushFont(theme.strong);
  colored(palette::kTextStrong, label);
  ImGui::PopFont();
  ImGui::SameLine(0, theme.space(2));
  ImGui::PushFont(theme.small);
  colored(palette::kTextFaint, id);
  ImGui::PopFont();
}

void small(const Theme& theme, ImU32 ink, const std::string& text) {
  ImGui::PushFont(theme.small);
  colored(ink, text);
  ImGui::PopFont();
}

void drawParam(const Theme& theme, Parameters& parameters, const ParamSpec& spec) {
  HelpPage& page = parameters.help;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (page.scroll && page.param == spec.id) {
    ImGui::SetScrollHereY(0.15f);
    page.scroll = false;
  }
  labelAndId(theme, spec.label, spec.id);
  if (!spec.help.empty()) colored(palette::kText, spec.help);
  small(theme, palette::kTextDim, facts(spec));
  for (const nodes::Choice& c : spec.choices) {
    ImGui::Indent(theme.space(3));
    ImGui::PushFont(theme.small);
    colored(palette::kTextDim, c.label + (c.help.empty() ? "" : ": " + c.help));
    ImGui::PopFont();
    ImGui::Unindent(theme.space(3));
  }
  if (page.param == spec.id)
    ImGui::GetWindowDrawList()->AddRectFilled({at.x - theme.px(9), at.y},
                                              {at.x - theme.px(6), ImGui::GetItemRectMax().y},
                                              palette::kAccent, theme.px(1));
  ImGui::Dummy({0, theme.space(1)});
}

std::string_view labelOf(nodes::SocketType type) {
  for (const auto& item : enumInfo(static_cast<nodes::SocketType*>(nullptr)))
    if (item.value == type) return item.label;
  return {};
}

void drawSockets(const Theme& theme, const char* title, const std::vector<nodes::SocketSpec>& sockets) {
  if (sockets.empty()) return;
  ImGui::Dummy({0, theme.space(1)});
  small(theme, palette::kTextFaint, title);
  for (const nodes::SocketSpec& s : sockets) {
    labelAndId(theme, s.label, s.id);
    std::string kind(labelOf(s.type));
    if (s.many) kind += ", takes many links";
    if (s.required) kind += ", needed";
    if (!s.help.empty()) colored(palette::kText, s.help);
    small(theme, palette::kTextDim, kind);
  }
}

void drawType(const Theme& theme, Parameters& parameters, const nodes::NodeType& type) {
  if (!type.help.empty()) colored(palette::kText, type.help);
  if (!type.params.empty()) {
    ImGui::Dummy({0, theme.space(1)});
    small(theme, palette::kTextFaint, "Parameters");
  }
  for (const ParamSpec& spec : type.params) drawParam(theme, parameters, spec);
  drawSockets(theme, "Inputs", type.inputs);
  drawSockets(theme, "Outputs", type.outputs);
}

}  // namespace

void drawParamTooltip(Ui& ui, const ParamTarget& target) {
  const Theme& theme = ui.theme;
  const ParamSpec& spec = *target.spec;
  if (CutTexts* cut = cutTexts()) cut->told += spec.label;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(theme.px(340));
  labelAndId(theme, spec.label, spec.id);
  if (!spec.help.empty()) ImGui::TextUnformatted(spec.help.c_str());
  small(theme, palette::kTextDim, facts(spec));
  small(theme, palette::kTextFaint, "F1: the whole page");
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ui.trace.note("param help", spec.id);
}

void openHelpPage(Ui& ui, const Session& session, Parameters& parameters, const std::string& node,
                  const std::string& param) {
  const nodes::Node* n = nodes::findNode(session.document.graph(), node);
  if (!n || !nodes::findNodeType(n->type))
    return ui.messages.hint("There is no page about this type of node.");
  parameters.help = {n->type, param, !param.empty(), true};
}

void openHelp(Ui& ui, const Session& session, Parameters& parameters) {
  const Parameters& panel = parameters;
  if (ui.now.hovered == Panel::Parameters && panel.hovered)
    return openHelpPage(ui, session, parameters, panel.hovered->nodes.front(), panel.hovered->spec->id);
  const bool graph = ui.now.hovered == Panel::Graph, here = ui.now.hovered == Panel::Parameters;
  const std::vector<std::string> shown = shownNodes(session, parameters);
  if (graph && session.document.selection().size() == 1)
    return openHelpPage(ui, session, parameters, *session.document.selection().begin(), "");
  if (here && !shown.empty()) return openHelpPage(ui, session, parameters, shown.front(), "");
  ui.modals.shortcuts = true;
}

void drawHelpPage(Ui& ui, Parameters& parameters) {
  HelpPage& page = parameters.help;
  const nodes::NodeType* type = page.open() ? nodes::findNodeType(page.type) : nullptr;
  if (!type) return;
  const Theme& theme = ui.theme;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(theme.px(460), display.x - theme.px(40));
  const float height = std::min(theme.px(620), display.y - theme.px(120));
  ImGui::SetNextWindowSize({width, height}, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos(
      {std::max(theme.px(10), parameters.min.x - width - theme.px(12)), parameters.min.y + theme.px(24)},
      ImGuiCond_Appearing);
  if (page.appear) ImGui::SetNextWindowFocus();
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kPopup);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(4), theme.space(3)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const bool visible = ImGui::Begin("##help page", nullptr,
                                    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor();
  bool close = false;
  if (visible) {
    ImGui::PushFont(theme.title);
    colored(palette::kTextStrong, type->label);
    ImGui::PopFont();
    ImGui::SameLine(0, theme.space(2));
    small(theme, palette::kTextFaint, type->id);
    const float button = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button);
    close = ImGui::Button(icon::kTimes, {button, 0});
    ui.trace.item("help/close");
    ImGui::Separator();
    ImGui::BeginChild("text", {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushTextWrapPos();
    drawType(ui.theme, parameters, *type);
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    const ImVec2 lo = ImGui::GetWindowPos();
    ui.trace.rect("help page", lo, {lo.x + ImGui::GetWindowWidth(), lo.y + ImGui::GetWindowHeight()});
    ui.trace.note("help page", type->id + "#" + page.param);
  }
  ImGui::End();
  page.appear = false;
  if (close || (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) && !ui.fields.typing()))
    page = {};
}

}  // namespace pileus::editor
