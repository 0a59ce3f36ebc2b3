#include "editor/panels/viewport_bar.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/actions.h"
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
  tryEditRoot(editor, nodes::setParam(editor.document.root(), node, param, value), label);
}

bool combo(Editor& editor, const char* id, const char* help, float width, const std::string& shown) {
  const bool open = beginCombo(editor.theme, id, shown, width);
  editor.trace.item("viewport" + std::string(id).substr(1));
  if (!open && ImGui::IsItemHovered()) tooltip(editor.theme, help);
  return open;
}

/// What the parts of the bar work on.
struct Bar {
  Editor& editor;
  const std::string& view;  ///< the node whose parameters count
  const nodes::NodeType& type;
  view::DisplaySettings settings;
  std::vector<std::string> outputs;
  std::vector<LayerChoice> layers;
  std::size_t layer = 0;
};

// Lists, for combos and for the menu of what has no room.

void listOutputs(Bar& bar) {
  for (const std::string& name : bar.outputs)
    if (ImGui::Selectable(name.c_str(), name == shownView(bar.editor))) bar.editor.viewport.activeView = name;
}

void listLayers(Bar& bar) {
  for (std::size_t i = 0; i < bar.layers.size(); ++i) {
    if (ImGui::Selectable(bar.layers[i].label.c_str(), i == bar.layer)) showLayer(bar.editor, bar.layers[i]);
    bar.editor.trace.item(fmt::format("viewport/layer/{}", i));
    if (ImGui::IsItemHovered()) tooltip(bar.editor.theme, bar.layers[i].help);
  }
}

void listChannels(Bar& bar) {
  for (const auto& item : enumInfo(static_cast<view::Channel*>(nullptr))) {
    if (item.value == view::Channel::Transmittance) continue;
    const std::string label = fmt::format("{}  {}", item.label, item.help);
    if (ImGui::Selectable(label.c_str(), item.value == bar.editor.viewport.mode.channel))
      bar.editor.viewport.mode.channel = item.value;
  }
}

void listDisplays(Bar& bar) {
  const image::ColorConfig& colors = *bar.editor.viewport.colors;
  const std::string shown = bar.settings.display.empty() ? colors.defaultDisplay() : bar.settings.display;
  for (const std::string& name : colors.displays())
    if (ImGui::Selectable(name.c_str(), name == shown) && name != shown)
      setText(bar.editor, bar.view, "display", name == colors.defaultDisplay() ? "" : name, "Display");
}

std::string shownViewTransform(const Bar& bar) {
  const image::ColorConfig& colors = *bar.editor.viewport.colors;
  return bar.settings.view.empty() ? colors.defaultView(bar.settings.display) : bar.settings.view;
}

void listViews(Bar& bar) {
  const image::ColorConfig& colors = *bar.editor.viewport.colors;
  const std::string shown = shownViewTransform(bar);
  for (const std::string& name : colors.views(bar.settings.display))
    if (ImGui::Selectable(name.c_str(), name == shown) && name != shown)
      setText(bar.editor, bar.view, "view", name == colors.defaultView(bar.settings.display) ? "" : name,
              "View");
}

void listLooks(Bar& bar) {
  if (ImGui::Selectable("As the view has it", bar.settings.look.empty()) && !bar.settings.look.empty())
    setText(bar.editor, bar.view, "look", "", "Look");
  for (const std::string& name : bar.editor.viewport.colors->looks())
    if (ImGui::Selectable(name.c_str(), name == bar.settings.look) && name != bar.settings.look)
      setText(bar.editor, bar.view, "look", name, "Look");
}

void listResolutions(Bar& bar) {
  struct Choice {
    double factor;
    const char* label;
  };
  for (const Choice& c : {Choice{1, "100 %"}, Choice{0.5, "50 %"}, Choice{0.25, "25 %"}})
    if (ImGui::Selectable(c.label, c.factor == bar.editor.settings.viewportResolution))
      bar.editor.settings.viewportResolution = c.factor;
}

void listDraftTimes(Bar& bar) {
  for (const double time : {30.0, 60.0, 100.0})
    if (ImGui::Selectable(fmt::format("{:.0f} ms", time).c_str(), time == bar.editor.settings.draftMs))
      bar.editor.settings.draftMs = time;
}

// The parts, from left to right; each draws at the cursor.

void drawOutput(Bar& bar) {
  if (combo(bar.editor, "##/output", "The node shown here", bar.editor.theme.px(120), shownView(bar.editor)))
    listOutputs(bar), ImGui::EndCombo();
}

void drawLayer(Bar& bar) {
  if (combo(bar.editor, "##/layer", "Layer: what the picture holds. PgUp and PgDn step through them.",
            bar.editor.theme.px(116), bar.layers[bar.layer].label))
    listLayers(bar), ImGui::EndCombo();
}

void drawChannel(Bar& bar) {
  const view::Channel shown = bar.editor.viewport.mode.channel;
  std::string label;
  for (const auto& item : enumInfo(static_cast<view::Channel*>(nullptr)))
    if (item.value == shown) label = item.label;
  bar.editor.trace.note("viewport channel", label);
  if (combo(bar.editor, "##/channel", "One channel alone: Shift+R, G, B, A or L; again: all of them",
            bar.editor.theme.px(62), label))
    listChannels(bar), ImGui::EndCombo();
}

void drawDisplay(Bar& bar) {
  const image::ColorConfig& colors = *bar.editor.viewport.colors;
  if (combo(bar.editor, "##/display", "Display: what the picture is shown on", bar.editor.theme.px(108),
            bar.settings.display.empty() ? colors.defaultDisplay() : bar.settings.display))
    listDisplays(bar), ImGui::EndCombo();
}

void drawView(Bar& bar) {
  const bool raw = bar.editor.viewport.mode.raw;
  if (combo(bar.editor, "##/view", "View transform: from scene light to that display",
            bar.editor.theme.px(138), raw ? "Raw, no transform" : shownViewTransform(bar)))
    listViews(bar), ImGui::EndCombo();
}

void drawLook(Bar& bar) {
  if (combo(bar.editor, "##/look", "Look: a grade before the view transform", bar.editor.theme.px(110),
            bar.settings.look.empty() ? "Look of the view" : bar.settings.look))
    listLooks(bar), ImGui::EndCombo();
}

void drawResolution(Bar& bar) {
  if (combo(bar.editor, "##/resolution", "Rendered pixels per pixel of this panel", bar.editor.theme.px(78),
            fmt::format("{:.0f} %", 100 * bar.editor.settings.viewportResolution)))
    listResolutions(bar), ImGui::EndCombo();
}

/// A number of the view node, to drag or type.
void dragNumber(Bar& bar, const char* param, double value, const char* unit, const char* label,
                const char* help, float width) {
  Editor& editor = bar.editor;
  const nodes::ParamSpec* spec = bar.type.param(param);
  if (!spec) return;
  NumberField field;
  field.softMin = spec->softMin, field.softMax = spec->softMax;
  field.hardMin = spec->hardMin, field.hardMax = spec->hardMax;
  field.logarithmic = spec->logarithmic;
  field.unit = unit;
  const NumberEdit edit = numberField(editor.parameters.numbers, editor.theme,
                                      (std::string("##") + param).c_str(), value, field, width);
  editor.trace.item(std::string("viewport/") + param);
  if (edit.changed)
    tryEditRoot(editor, nodes::setParam(editor.document.root(), bar.view, param, value), label,
                edit.dragging ? std::string("viewport ") + param : "");
  if (edit.finished) editor.document.endMerge();
  if (ImGui::IsItemHovered() && !edit.dragging) tooltip(editor.theme, help);
  if (ImGui::IsItemClicked(1))
    tryEditRoot(editor, nodes::setParam(editor.document.root(), bar.view, param, spec->fallback), label);
}

void drawExposure(Bar& bar) {
  const Theme& theme = bar.editor.theme;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", icon::kSun);
  ImGui::SameLine(0, theme.px(5));
  dragNumber(bar, "exposure", bar.settings.exposure, "stops", "Exposure",
             "Exposure: [ and ] change it by half a stop, Ctrl+R or a right click resets it", theme.px(104));
}

void drawGamma(Bar& bar) {
  const Theme& theme = bar.editor.theme;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Gamma");
  ImGui::SameLine(0, theme.px(5));
  dragNumber(bar, "gamma", bar.settings.gamma, "", "Gamma",
             "Gamma behind the view transform; a right click resets it", theme.px(56));
}

/// A square button for a command; lit while that is on.
void actionButton(Editor& editor, const char* id, const char* mark) {
  const Action* action = findAction(id);
  if (!action) return;
  const Theme& theme = editor.theme;
  const float side = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(id, {side, side}), hovered = ImGui::IsItemHovered();
  editor.trace.item(std::string("viewport/button/") + id);
  const bool on = action->checked && action->checked(editor),
             enabled = !action->enabled || action->enabled(editor);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (on || hovered)
    draw->AddRectFilled(at, {at.x + side, at.y + side}, on ? palette::kAccentDim : palette::kButtonHover,
                        theme.px(4));
  const ImU32 ink = !enabled  ? faded(palette::kTextFaint, 0.5f)
                    : on      ? palette::kTextStrong
                    : hovered ? palette::kText
                              : palette::kTextDim;
  drawText(draw, theme.body,
           {std::round(at.x + 0.5f * (side - textWidth(theme.body, mark))),
            std::round(at.y + 0.5f * (side - theme.body->FontSize))},
           ink, mark, side);
  if (hovered) {
    const std::string keys = shortcutText(action->keys[0]);
    tooltip(theme, keys.empty() ? std::string(action->label) : fmt::format("{} ({})", action->label, keys));
  }
  if (clicked && enabled) action->run(editor);
}

void drawRaw(Bar& bar) { actionButton(bar.editor, "viewport.raw", icon::kBan); }
void drawFalse(Bar& bar) { actionButton(bar.editor, "viewport.false_color", icon::kPaint); }
void drawZebra(Bar& bar) { actionButton(bar.editor, "viewport.zebra", icon::kAdjust); }
void drawInspect(Bar& bar) { actionButton(bar.editor, "viewport.inspector", icon::kEyedropper); }
void drawHisto(Bar& bar) { actionButton(bar.editor, "viewport.histogram", icon::kChart); }
void drawHudButton(Bar& bar) { actionButton(bar.editor, "viewport.hud", icon::kInfo); }
void drawRegionButton(Bar& bar) { actionButton(bar.editor, "viewport.region", icon::kSquare); }
void drawStill(Bar& bar) { actionButton(bar.editor, "viewport.snapshot", icon::kPicture); }
void drawCompareButton(Bar& bar) { actionButton(bar.editor, "viewport.compare", icon::kColumns); }

std::string cameraText(const Editor& editor) {
  const std::string camera = linkedCamera(editor, shownView(editor));
  return std::string(icon::kCamera) + "  " +
         (camera.empty() ? (editor.viewport.freeCamera ? "Free camera" : "Framed volumes") : camera);
}

void drawCamera(Bar& bar) {
  const Theme& theme = bar.editor.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = theme.px(110), height = ImGui::GetFrameHeight();
  drawText(ImGui::GetWindowDrawList(), theme.small, {at.x, at.y + 0.5f * (height - theme.small->FontSize)},
           palette::kTextDim, cameraText(bar.editor), width);
  ImGui::Dummy({width, height});
}

bool hasOutputs(const Bar& bar) { return bar.outputs.size() > 1; }
bool hasDisplay(const Bar& bar) { return bar.type.param("display") && bar.type.param("view"); }
bool hasLooks(const Bar& bar) {
  return bar.type.param("look") && !bar.editor.viewport.colors->looks().empty();
}
bool hasExposure(const Bar& bar) { return bar.type.param("exposure"); }

constexpr float kSquare = 0;  // width of a button: as high as a frame

struct Part {
  void (*draw)(Bar&);
  float width;   ///< design pixels
  int priority;  ///< the lowest stay longest where room is short
  bool right = false;
  bool (*wanted)(const Bar&) = nullptr;  ///< null: always
};
constexpr Part kParts[] = {{drawOutput, 120, 7, false, hasOutputs},
                           {drawLayer, 116, 1},
                           {drawChannel, 62, 4},
                           {drawDisplay, 108, 6, false, hasDisplay},
                           {drawView, 138, 3, false, hasDisplay},
                           {drawLook, 110, 8, false, hasLooks},
                           {drawExposure, 127, 2, false, hasExposure},
                           {drawGamma, 112, 16, false, hasExposure},
                           {drawResolution, 78, 18},
                           {drawCamera, 110, 19, true},
                           {drawRaw, kSquare, 15, true},
                           {drawFalse, kSquare, 12, true},
                           {drawZebra, kSquare, 14, true},
                           {drawHisto, kSquare, 11, true},
                           {drawInspect, kSquare, 9, true},
                           {drawRegionButton, kSquare, 13, true},
                           {drawStill, kSquare, 10, true},
                           {drawCompareButton, kSquare, 5, true},
                           {drawHudButton, kSquare, 17, true}};
constexpr std::size_t kCount = std::size(kParts);

float partWidth(const Theme& theme, const Part& part) {
  return part.width == kSquare ? ImGui::GetFrameHeight() : theme.px(part.width);
}

/// The parts that fit into `room`, most important ones first.
std::array<bool, kCount> fitting(const Bar& bar, float room) {
  std::array<bool, kCount> shown{};
  const Theme& theme = bar.editor.theme;
  for (int priority = 1; priority <= static_cast<int>(kCount); ++priority)
    for (std::size_t i = 0; i < kCount; ++i) {
      const Part& part = kParts[i];
      if (part.priority != priority || (part.wanted && !part.wanted(bar))) continue;
      const float width =
          partWidth(theme, part) + (part.right && part.width == kSquare ? theme.px(2) : theme.space(2));
      if (width > room) return shown;
      room -= width;
      shown[i] = true;
    }
  return shown;
}

/// Everything, by mouse, however narrow the bar is.
void drawMore(Bar& bar) {
  const auto list = [&](const char* label, void (*items)(Bar&), bool wanted = true) {
    if (!wanted) return;
    const bool open = ImGui::BeginMenu(label);
    bar.editor.trace.item(fmt::format("viewport/more/{}", label));
    if (open) items(bar), ImGui::EndMenu();
  };
  list("Shown Node", listOutputs, hasOutputs(bar));
  list("Layer", listLayers);
  list("Channel", listChannels);
  list("Display", listDisplays, hasDisplay(bar));
  list("View Transform", listViews, hasDisplay(bar));
  list("Look", listLooks, hasLooks(bar));
  list("Resolution", listResolutions);
  list("Draft Time", listDraftTimes);
  if (bar.type.param("gamma") && ImGui::BeginMenu("Gamma")) {
    dragNumber(bar, "gamma", bar.settings.gamma, "", "Gamma", "Gamma behind the view transform",
               bar.editor.theme.px(96));
    ImGui::EndMenu();
  }
  ImGui::Separator();
  for (const char* id : {"viewport.raw", "viewport.false_color", "viewport.zebra", "viewport.inspector",
                         "viewport.histogram", "viewport.hud"})
    actionMenuItem(bar.editor, id);
  ImGui::Separator();
  for (const char* id : {"viewport.region", "viewport.region_toggle", "viewport.snapshot",
                         "viewport.snapshot_wipe", "viewport.compare"})
    actionMenuItem(bar.editor, id);
  ImGui::Separator();
  for (const char* id : {"viewport.frame", "viewport.reset_camera", "viewport.exposure_reset"})
    actionMenuItem(bar.editor, id);
}

void drawMoreButton(Bar& bar, ImVec2 at) {
  Editor& editor = bar.editor;
  const float side = ImGui::GetFrameHeight();
  ImGui::SetCursorScreenPos(at);
  const bool clicked = ImGui::InvisibleButton("##more", {side, side}), hovered = ImGui::IsItemHovered();
  editor.trace.item("viewport/more");
  if (hovered)
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, palette::kButtonHover,
                                              editor.theme.px(4));
  drawText(ImGui::GetWindowDrawList(), editor.theme.body,
           {std::round(at.x + 0.5f * (side - textWidth(editor.theme.body, icon::kMore))),
            std::round(at.y + 0.5f * (side - editor.theme.body->FontSize))},
           hovered ? palette::kText : palette::kTextDim, icon::kMore, side);
  if (hovered) tooltip(editor.theme, "Everything about how the picture is shown");
  if (clicked) ImGui::OpenPopup("viewport more");
  ImGui::SetNextWindowPos({at.x + side, at.y + side + editor.theme.px(4)}, ImGuiCond_Appearing, {1, 0});
  if (!ImGui::BeginPopup("viewport more")) return;
  drawMore(bar);
  ImGui::EndPopup();
}

std::vector<std::string> outputsOf(const Editor& editor, const std::string& shown) {
  std::vector<std::string> names;
  for (const auto& [name, node] : editor.document.root().nodes)
    if (const nodes::NodeType* type = nodes::findNodeType(node->type); type && type->isOutput)
      names.push_back(name);
  if (!shown.empty() && std::find(names.begin(), names.end(), shown) == names.end()) names.push_back(shown);
  return names;
}

}  // namespace

view::DisplaySettings displaySettings(const Editor& editor) {
  const nodes::Node* node = nodes::findNode(editor.document.root(), displayNode(editor));
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const DisplayMode& mode = editor.viewport.mode;
  view::DisplaySettings settings;
  settings.raw = mode.raw;
  settings.channel = mode.channel;
  settings.falseColor = mode.falseColor;
  settings.zebra = mode.zebra;
  if (!type) return settings;
  settings.display = textParam(*node, *type, "display");
  settings.view = textParam(*node, *type, "view");
  settings.look = textParam(*node, *type, "look");
  const auto number = [&](const char* id, double& out) {
    const nodes::ParamSpec* spec = type->param(id);
    if (!spec) return;
    const nodes::ParamValue value = nodes::paramValue(*node, *spec);
    if (const double* v = std::get_if<double>(&value)) out = *v;
  };
  number("exposure", settings.exposure);
  number("gamma", settings.gamma);
  return settings;
}

void drawViewportBar(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  const std::string view = displayNode(editor);
  const nodes::Node* node = nodes::findNode(editor.document.root(), view);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (!type || !editor.viewport.colors) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Viewport");
    return;
  }
  Bar bar{editor,
          view,
          *type,
          displaySettings(editor),
          outputsOf(editor, shownView(editor)),
          layerChoices(editor),
          0};
  bar.layer = shownLayer(editor, bar.layers);
  const float side = ImGui::GetFrameHeight(), more = max.x - theme.space(2) - side, y = min.y + theme.px(5);
  const auto shown = fitting(bar, more - theme.space(2) - (min.x + theme.space(2)));
  float left = min.x + theme.space(2), rightWidth = 0;
  for (std::size_t i = 0; i < kCount; ++i)
    if (shown[i] && kParts[i].right)
      rightWidth += partWidth(theme, kParts[i]) + (kParts[i].width == kSquare ? theme.px(2) : theme.space(2));
  float right = more - theme.px(2) - rightWidth;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Part& part = kParts[i];
    if (!shown[i]) continue;
    float& x = part.right ? right : left;
    ImGui::SetCursorScreenPos({x, y});
    part.draw(bar);
    x += partWidth(theme, part) + (part.right && part.width == kSquare ? theme.px(2) : theme.space(2));
  }
  drawMoreButton(bar, {more, y});
}

}  // namespace pileus::editor
