#include "editor/viewport/bar_parts.h"

#include <fmt/core.h>

#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/number_field.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/viewport_room.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {
namespace {

bool combo(Ui& ui, const char* id, const char* help, float width, const std::string& shown) {
  const bool open = beginCombo(ui.theme, id, shown, width);
  ui.trace.item("viewport" + std::string(id).substr(1));
  if (!open && ImGui::IsItemHovered()) tooltip(ui.theme, help);
  return open;
}
/// A square button for a command; lit while that is on.
void actionButton(Ui& ui, const char* id, const char* mark, const char* help = "") {
  const std::optional<CommandLook> look = ui.commands(id);
  if (!look) return;
  const Theme& theme = ui.theme;
  const float side = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(id, {side, side}), hovered = ImGui::IsItemHovered();
  ui.trace.item(std::string("viewport/button/") + id);
  const bool on = look->checked, enabled = look->enabled;
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
  if (hovered)
    tooltip(theme, *help                ? help
                   : look->keys.empty() ? look->label
                                        : fmt::format("{} ({})", look->label, look->keys));
  if (clicked && enabled) ui.requests.push(RunCommand{id});
}
std::string cameraText(const Session& session, const Shown& shown) {
  if (aroundCamera(session, shown)) return std::string(icon::kEye) + "  Looking around";
  const std::string camera = linkedCamera(session, shownView(session, shown));
  return std::string(icon::kCamera) + "  " +
         (camera.empty() ? (shown.freeCamera ? "Free camera" : "Framed volumes") : camera);
}
}  // namespace

// The parts, from left to right; each draws at the cursor.

void drawOutput(Bar& bar) {
  if (combo(bar.room.ui, "##/output", "The node shown here", bar.room.ui.theme.px(120),
            shownView(bar.room.session, bar.room.shown)))
    listOutputs(bar), ImGui::EndCombo();
}

void drawLayer(Bar& bar) {
  if (combo(bar.room.ui, "##/layer", "Layer: what the picture holds. PgUp and PgDn step through them.",
            bar.room.ui.theme.px(116), bar.layers[bar.layer].label))
    listLayers(bar), ImGui::EndCombo();
}

void drawChannel(Bar& bar) {
  const view::Channel shown = bar.room.shown.mode.channel;
  std::string label;
  for (const auto& item : enumInfo(static_cast<view::Channel*>(nullptr)))
    if (item.value == shown) label = item.label;
  bar.room.ui.trace.note("viewport channel", label);
  if (combo(bar.room.ui, "##/channel", "One channel alone: Shift+R, G, B, A or L; again: all of them",
            bar.room.ui.theme.px(62), label))
    listChannels(bar), ImGui::EndCombo();
}

void drawDisplay(Bar& bar) {
  const image::ColorConfig& colors = *bar.room.shown.displayed.colors;
  if (combo(bar.room.ui, "##/display", "Display: what the picture is shown on", bar.room.ui.theme.px(108),
            bar.settings.display.empty() ? colors.defaultDisplay() : bar.settings.display))
    listDisplays(bar), ImGui::EndCombo();
}

void drawView(Bar& bar) {
  const bool raw = bar.room.shown.mode.raw;
  if (combo(bar.room.ui, "##/view", "View transform: from scene light to that display",
            bar.room.ui.theme.px(138), raw ? "Raw, no transform" : shownViewTransform(bar)))
    listViews(bar), ImGui::EndCombo();
}

void drawLook(Bar& bar) {
  if (combo(bar.room.ui, "##/look", "Look: a grade before the view transform", bar.room.ui.theme.px(110),
            bar.settings.look.empty() ? "Look of the view" : bar.settings.look))
    listLooks(bar), ImGui::EndCombo();
}

void drawResolution(Bar& bar) {
  if (combo(bar.room.ui, "##/resolution", "Rendered pixels per pixel of this panel", bar.room.ui.theme.px(78),
            fmt::format("{:.0f} %", 100 * bar.room.settings.viewportResolution)))
    listResolutions(bar), ImGui::EndCombo();
}

/// A number of the view node, to drag or type.
void dragNumber(Bar& bar, const char* param, double value, const char* unit, const char* label,
                const char* help, float width) {
  const ViewportRoom& room = bar.room;
  const nodes::ParamSpec* spec = bar.type.param(param);
  if (!spec) return;
  NumberField field;
  field.softMin = spec->softMin, field.softMax = spec->softMax;
  field.hardMin = spec->hardMin, field.hardMax = spec->hardMax;
  field.logarithmic = spec->logarithmic;
  field.unit = unit;
  const NumberEdit edit = numberField(room.ui.fields.number, room.ui.theme,
                                      (std::string("##") + param).c_str(), value, field, width);
  room.ui.trace.item(std::string("viewport/") + param);
  if (edit.changed)
    tryEditRoot(room.session, room.ui.messages,
                nodes::setParamAt(room.session.document.root(), bar.view, param, value, room.clock.frame),
                label, edit.dragging ? std::string("viewport ") + param : "");
  if (edit.finished) room.session.document.endMerge();
  if (ImGui::IsItemHovered() && !edit.dragging) tooltip(room.ui.theme, help);
  if (ImGui::IsItemClicked(1))
    tryEditRoot(
        room.session, room.ui.messages,
        nodes::setParamAt(room.session.document.root(), bar.view, param, spec->fallback, room.clock.frame),
        label);
}

void drawExposure(Bar& bar) {
  const Theme& theme = bar.room.ui.theme;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", icon::kSun);
  ImGui::SameLine(0, theme.px(5));
  dragNumber(bar, "exposure", bar.settings.exposure, "stops", "Exposure",
             "Exposure: [ and ] change it by half a stop, Ctrl+R or a right click resets it", theme.px(104));
}

void drawGamma(Bar& bar) {
  const Theme& theme = bar.room.ui.theme;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Gamma");
  ImGui::SameLine(0, theme.px(5));
  dragNumber(bar, "gamma", bar.settings.gamma, "", "Gamma",
             "Gamma behind the view transform; a right click resets it", theme.px(56));
}
bool hasCamera(const Bar& bar) {
  return !linkedCamera(bar.room.session, shownView(bar.room.session, bar.room.shown)).empty();
}
void drawLock(Bar& bar) {
  const bool locked = cameraLocked(bar.room.session, bar.room.clock, bar.room.shown);
  actionButton(bar.room.ui, "viewport.lock_camera", locked ? icon::kLock : icon::kUnlock,
               locked ? "The camera is locked: moves here look around and leave it alone. A click unlocks it"
                      : "Moves here move the camera. A click locks it");
}
void drawRaw(Bar& bar) { actionButton(bar.room.ui, "viewport.raw", icon::kBan); }
void drawFalse(Bar& bar) { actionButton(bar.room.ui, "viewport.false_color", icon::kPaint); }
void drawZebra(Bar& bar) { actionButton(bar.room.ui, "viewport.zebra", icon::kAdjust); }
void drawInspect(Bar& bar) { actionButton(bar.room.ui, "viewport.inspector", icon::kEyedropper); }
void drawHisto(Bar& bar) { actionButton(bar.room.ui, "viewport.histogram", icon::kChart); }
void drawHudButton(Bar& bar) { actionButton(bar.room.ui, "viewport.hud", icon::kInfo); }
void drawRegionButton(Bar& bar) { actionButton(bar.room.ui, "viewport.region", icon::kSquare); }
void drawStill(Bar& bar) { actionButton(bar.room.ui, "viewport.snapshot", icon::kPicture); }
void drawCompareButton(Bar& bar) { actionButton(bar.room.ui, "viewport.compare", icon::kColumns); }
void drawCamera(Bar& bar) {
  const Theme& theme = bar.room.ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = theme.px(110), height = ImGui::GetFrameHeight();
  drawText(ImGui::GetWindowDrawList(), theme.small, {at.x, at.y + 0.5f * (height - theme.small->FontSize)},
           palette::kTextDim, cameraText(bar.room.session, bar.room.shown), width);
  ImGui::Dummy({width, height});
}
}  // namespace pileus::editor
