#include "editor/viewport/bar_parts.h"

#include <fmt/core.h>

#include <cmath>

#include "editor/commands/actions.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/picture/shown_camera.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/number_field.h"
#include "editor/toolkit/widgets.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {
namespace {

bool combo(Editor& editor, const char* id, const char* help, float width, const std::string& shown) {
  const bool open = beginCombo(editor.theme, id, shown, width);
  editor.trace.item("viewport" + std::string(id).substr(1));
  if (!open && ImGui::IsItemHovered()) tooltip(editor.theme, help);
  return open;
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
std::string cameraText(const Editor& editor) {
  const std::string camera = linkedCamera(editor, shownView(editor));
  return std::string(icon::kCamera) + "  " +
         (camera.empty() ? (editor.viewport.freeCamera ? "Free camera" : "Framed volumes") : camera);
}
}  // namespace

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
    tryEditRoot(editor, nodes::setParamAt(editor.document.root(), bar.view, param, value, editor.frame),
                label, edit.dragging ? std::string("viewport ") + param : "");
  if (edit.finished) editor.document.endMerge();
  if (ImGui::IsItemHovered() && !edit.dragging) tooltip(editor.theme, help);
  if (ImGui::IsItemClicked(1))
    tryEditRoot(editor,
                nodes::setParamAt(editor.document.root(), bar.view, param, spec->fallback, editor.frame),
                label);
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
void drawRaw(Bar& bar) { actionButton(bar.editor, "viewport.raw", icon::kBan); }
void drawFalse(Bar& bar) { actionButton(bar.editor, "viewport.false_color", icon::kPaint); }
void drawZebra(Bar& bar) { actionButton(bar.editor, "viewport.zebra", icon::kAdjust); }
void drawInspect(Bar& bar) { actionButton(bar.editor, "viewport.inspector", icon::kEyedropper); }
void drawHisto(Bar& bar) { actionButton(bar.editor, "viewport.histogram", icon::kChart); }
void drawHudButton(Bar& bar) { actionButton(bar.editor, "viewport.hud", icon::kInfo); }
void drawRegionButton(Bar& bar) { actionButton(bar.editor, "viewport.region", icon::kSquare); }
void drawStill(Bar& bar) { actionButton(bar.editor, "viewport.snapshot", icon::kPicture); }
void drawCompareButton(Bar& bar) { actionButton(bar.editor, "viewport.compare", icon::kColumns); }
void drawCamera(Bar& bar) {
  const Theme& theme = bar.editor.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = theme.px(110), height = ImGui::GetFrameHeight();
  drawText(ImGui::GetWindowDrawList(), theme.small, {at.x, at.y + 0.5f * (height - theme.small->FontSize)},
           palette::kTextDim, cameraText(bar.editor), width);
  ImGui::Dummy({width, height});
}
}  // namespace pileus::editor
