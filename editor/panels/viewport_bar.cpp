#include "editor/panels/viewport_bar.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/icons.h"
#include "editor/panels/number_field.h"
#include "editor/panels/viewport_camera.h"
#include "editor/widgets.h"

namespace pileus::editor {
namespace {

std::string textParam(const nodes::Node& node, const nodes::NodeType& type, const char* id) {
  const nodes::ParamSpec* spec = type.param(id);
  if (!spec) return {};
  const nodes::ParamValue value = nodes::paramValue(node, *spec);
  const std::string* text = std::get_if<std::string>(&value);
  return text ? *text : std::string();
}

void setText(Editor& editor, const std::string& node, const char* param, const std::string& value,
             const char* label) {
  tryEdit(editor, nodes::setParam(editor.document.graph(), node, param, value), label);
}

bool combo(Editor& editor, const char* id, const char* help, float width, const std::string& shown) {
  const bool open = beginCombo(editor.theme, id, shown, width);
  editor.trace.item("viewport" + std::string(id).substr(1));
  if (!open && ImGui::IsItemHovered()) tooltip(editor.theme, help);
  return open;
}

void chooseOutput(Editor& editor, const std::string& view) {
  std::vector<std::string> views;
  for (const auto& [name, node] : editor.document.graph().nodes)
    if (const nodes::NodeType* type = nodes::findNodeType(node->type); type && type->isOutput)
      views.push_back(name);
  if (!view.empty() && std::find(views.begin(), views.end(), view) == views.end()) views.push_back(view);
  if (views.size() < 2) return;
  if (combo(editor, "##/output", "The output shown here", editor.theme.px(120), view)) {
    for (const std::string& name : views)
      if (ImGui::Selectable(name.c_str(), name == view)) editor.viewport.activeView = name;
    ImGui::EndCombo();
  }
  ImGui::SameLine();
}

void chooseDisplay(Editor& editor, const std::string& node, const view::DisplaySettings& current) {
  const image::ColorConfig& colors = *editor.viewport.colors;
  const std::string display = current.display.empty() ? colors.defaultDisplay() : current.display;
  const std::string view = current.view.empty() ? colors.defaultView(display) : current.view;
  if (combo(editor, "##/display", "Display: what the picture is shown on", editor.theme.px(126), display)) {
    for (const std::string& name : colors.displays())
      if (ImGui::Selectable(name.c_str(), name == display) && name != display)
        setText(editor, node, "display", name == colors.defaultDisplay() ? "" : name, "Display");
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  if (combo(editor, "##/view", "View transform: from scene light to that display", editor.theme.px(150),
            view)) {
    for (const std::string& name : colors.views(display))
      if (ImGui::Selectable(name.c_str(), name == view) && name != view)
        setText(editor, node, "view", name == colors.defaultView(display) ? "" : name, "View");
    ImGui::EndCombo();
  }
  ImGui::SameLine();
}

void dragExposure(Editor& editor, const std::string& node, const nodes::ParamSpec& spec, double value) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Exposure");
  ImGui::SameLine();
  NumberField field;
  field.softMin = spec.softMin, field.softMax = spec.softMax;
  field.hardMin = spec.hardMin, field.hardMax = spec.hardMax;
  field.unit = "stops";
  const NumberEdit edit =
      numberField(editor.parameters.numbers, editor.theme, "##exposure", value, field, editor.theme.px(112));
  editor.trace.item("viewport/exposure");
  if (edit.changed)
    tryEdit(editor, nodes::setParam(editor.document.graph(), node, "exposure", value), "Exposure",
            edit.dragging ? "viewport exposure" : "");
  if (edit.finished) editor.document.endMerge();
  if (ImGui::IsItemHovered() && !edit.dragging)
    tooltip(editor.theme, "Exposure: [ and ] change it by half a stop, Ctrl+R resets it");
  if (ImGui::IsItemClicked(1)) resetExposure(editor);
}

void chooseResolution(Editor& editor) {
  struct Choice {
    double factor;
    const char* label;
  };
  constexpr Choice kChoices[] = {{1, "100 %"}, {0.5, "50 %"}, {0.25, "25 %"}};
  const std::string shown = fmt::format("{:.0f} %", 100 * editor.settings.viewportResolution);
  if (combo(editor, "##/resolution", "Rendered pixels per pixel of this panel", editor.theme.px(84), shown)) {
    for (const Choice& c : kChoices)
      if (ImGui::Selectable(c.label, c.factor == editor.settings.viewportResolution))
        editor.settings.viewportResolution = c.factor;
    ImGui::EndCombo();
  }
  ImGui::SameLine();
}

}  // namespace

view::DisplaySettings displaySettings(const Editor& editor) {
  const nodes::Node* node = nodes::findNode(editor.document.graph(), displayNode(editor));
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  view::DisplaySettings settings;
  if (!type) return settings;
  settings.display = textParam(*node, *type, "display");
  settings.view = textParam(*node, *type, "view");
  if (const nodes::ParamSpec* spec = type->param("exposure")) {
    const nodes::ParamValue value = nodes::paramValue(*node, *spec);
    if (const double* v = std::get_if<double>(&value)) settings.exposure = *v;
  }
  return settings;
}

void drawViewportBar(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  const std::string shown = shownView(editor), view = displayNode(editor);
  const nodes::Node* node = nodes::findNode(editor.document.graph(), view);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (!type || !editor.viewport.colors) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Viewport");
    return;
  }
  ImGui::BeginGroup();
  chooseOutput(editor, shown);
  if (type->param("display") && type->param("view")) chooseDisplay(editor, view, displaySettings(editor));
  chooseResolution(editor);
  if (const nodes::ParamSpec* spec = type->param("exposure"))
    dragExposure(editor, view, *spec, displaySettings(editor).exposure);
  ImGui::EndGroup();
  const float used = ImGui::GetItemRectMax().x;
  const std::string camera = linkedCamera(editor, shown);
  const std::string text =
      std::string(icon::kCamera) + "  " +
      (camera.empty() ? (editor.viewport.freeCamera ? "Free camera" : "Framed volumes") : camera);
  const float width = textWidth(theme.small, text), room = max.x - theme.space(3) - used - theme.space(3);
  if (room > theme.px(60))
    drawText(ImGui::GetWindowDrawList(), theme.small,
             {std::max(max.x - theme.space(3) - width, used + theme.space(3)),
              min.y + 0.5f * (max.y - min.y - theme.small->FontSize)},
             palette::kTextDim, text, room);
}

}  // namespace pileus::editor
