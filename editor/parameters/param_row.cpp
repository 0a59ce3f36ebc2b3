#include "editor/parameters/param_row.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/parameters/param_help.h"
#include "editor/parameters/param_widgets.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "nodes/declare/value.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::editor {
namespace {

using nodes::ParamSpec;
using nodes::ParamType;

constexpr float kSocket = 12, kDot = 10, kKey = 16;  // design pixels of the marks

void drawDiamond(ImVec2 c, float r, ImU32 color, bool filled, float line) {
  const ImVec2 p[4] = {{c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (filled)
    draw->AddConvexPolyFilled(p, 4, color);
  else
    draw->AddPolyline(p, 4, color, ImDrawFlags_Closed, line);
}

/// The ring at the left: an input of the node, or a wish for one.
void socketMark(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target,
                const ParamState& state, const RowFrame& f, bool lit) {
  if (!canExpose(*target.spec) && !state.exposed) return;
  const Theme& theme = ui.theme;
  ImGui::SetCursorScreenPos(f.at);
  if (ImGui::InvisibleButton("socket", {theme.px(kSocket), f.height}) && canExpose(*target.spec))
    toggleExposed(ui, session, clock, target);
  ui.trace.item("expose/" + target.spec->id);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered)
    tooltip(theme,
            state.exposed ? "An input of the node; click to take it back" : "Expose as input of the node");
  const ImVec2 c = {f.at.x + theme.px(5), std::round(f.at.y + 0.5f * f.height)};
  const ImU32 color = socketColor(enumId(nodes::socketType(target.spec->type)));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (state.exposed)
    draw->AddCircleFilled(c, theme.px(hovered ? 4.5f : 4), color);
  else if (lit || hovered)
    draw->AddCircle(c, theme.px(3.5f), hovered ? color : palette::kTextFaint, 0, 1.2f * theme.scale);
}

bool animatable(const ParamSpec& spec) {
  return spec.type != ParamType::File && !nodes::constantOnly(spec.type);
}

/// The diamond at the right: outlined = no key, with accent = animated, filled = a key at this frame.
void keyMark(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target, const ParamState& state,
             const RowFrame& f, bool lit) {
  if (!animatable(*target.spec) || state.linked()) return;
  const Theme& theme = ui.theme;
  const float x = f.at.x + ImGui::GetContentRegionMax().x - theme.px(kKey);
  ImGui::SetCursorScreenPos({x, f.at.y});
  if (ImGui::InvisibleButton("key", {theme.px(kKey), f.height})) toggleKey(ui, session, clock, target);
  ui.trace.item("key/" + target.spec->id);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered)
    tooltip(theme,
            fmt::format("{} at frame {} (I)", state.keyHere ? "Remove the key" : "Set a key", clock.frame));
  if (!lit && !hovered && !state.animated) return;
  const ImVec2 c = {x + theme.px(kKey - 6), std::round(f.at.y + 0.5f * f.height)};
  const ImU32 color = state.animated ? palette::kSelect : hovered ? palette::kText : palette::kTextFaint;
  drawDiamond(c, theme.px(5), color, state.keyHere, 1.2f * theme.scale);
  if (state.animated && !state.keyHere) drawDiamond(c, theme.px(2), color, true, 1);
}

std::string liveValue(const Session& session, const Shown& shown, const ParamTarget& target) {
  const nodes::SocketValue* value =
      shown.preview.evaluator().input(session.document.scopedName(target.nodes.front()), target.spec->id);
  if (!value) return {};
  const bool whole = target.spec->type == ParamType::Int;
  if (const double* v = std::get_if<double>(value)) return numberText(*v, whole);
  const auto three = [](const dvec3& v) {
    return numberText(v.x, false) + "  " + numberText(v.y, false) + "  " + numberText(v.z, false);
  };
  if (const dvec3* v = std::get_if<dvec3>(value)) return three(*v);
  if (const nodes::Color* v = std::get_if<nodes::Color>(value)) return three(dvec3(v->rgb));
  if (const std::string* v = std::get_if<std::string>(value)) return *v;
  return {};
}

/// In place of the widget: where the value comes from, and what it is now.
void drawLinked(Ui& ui, Session& session, const Shown& shown, const ParamTarget& target,
                const ParamState& state, float width) {
  const Theme& theme = ui.theme;
  const ImVec2 lo = ImGui::GetCursorScreenPos(), hi = {lo.x + width, lo.y + ImGui::GetFrameHeight()};
  if (ImGui::InvisibleButton("linked", {width, hi.y - lo.y})) session.document.select({state.sourceNode});
  ui.trace.item("linked/" + target.spec->id);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(lo, hi, faded(hovered ? palette::kFieldHover : palette::kField, hovered ? 1 : 0.6f),
                      theme.px(4));
  const float y = lo.y + 0.5f * (hi.y - lo.y - theme.body->FontSize);
  const std::string value = liveValue(session, shown, target), from = "from " + state.sourceNode;
  const float room = std::min(textWidth(theme.body, value), 0.5f * width);
  drawText(draw, theme.body, {lo.x + theme.space(2), y}, hovered ? palette::kText : palette::kAccent, from,
           width - room - theme.space(5));
  drawText(draw, theme.body, {hi.x - room - theme.space(2), y}, palette::kTextFaint, value, room + 1);
  if (hovered)
    tooltip(theme, fmt::format("The value comes from {}.{}; click to select it", state.sourceNode,
                               state.sourceSocket));
}

void drawMenu(const ParameterRoom& room, const ParamTarget& target, const ParamState& state) {
  if (!ImGui::BeginPopup("row menu")) return;
  const auto item = [&](const char* id, const char* label, const char* key, bool enabled, bool on = false) {
    const bool chosen = ImGui::MenuItem(label, key, on, enabled);
    room.ui.trace.item(std::string("row menu/") + id);
    return chosen;
  };
  if (item("reset", "Reset to Default", "Backspace", state.modified))
    resetParam(room.ui, room.session, target);
  ImGui::Separator();
  if (item("copy", "Copy Value", "Ctrl+C", !state.mixed())) copyParam(room.session, room.clock, target);
  if (item("paste", "Paste Value", "Ctrl+V", true)) pasteParam(room, target);
  if (item("paste all", "Paste All Values of the Copied Node", "Ctrl+Shift+V", true))
    pasteValues(room.ui, room.session, room.clock, target.nodes);
  ImGui::Separator();
  if (animatable(*target.spec)) {
    if (item("key", state.keyHere ? "Remove Key" : "Set Key", "I", !state.linked()))
      toggleKey(room.ui, room.session, room.clock, target);
    if (item("clear keys", "Remove Animation", "", state.animated))
      clearAnimation(room.ui, room.session, room.clock, target);
  }
  if (canExpose(*target.spec) && item("expose", "Expose as Input", "", true, state.exposed))
    toggleExposed(room.ui, room.session, room.clock, target);
  ImGui::Separator();
  if (item("help", "Help", "F1", true))
    openHelpPage(room.ui, room.session, room.parameters, target.nodes.front(), target.spec->id);
  ImGui::EndPopup();
}

/// The frame of the row, whether the pointer is in it, and what its keys mean then.
bool hoverRow(Ui& ui, Parameters& parameters, const ParamTarget& target, ImVec2 lo, ImVec2 hi, bool clipped) {
  Parameters& panel = parameters;
  const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(lo, hi);
  if (!hovered) return false;
  panel.hovered = target;
  if (ImGui::IsMouseReleased(1) && !panel.points.removing) ImGui::OpenPopup("row menu");
  const bool busy = ImGui::IsAnyItemActive() || ui.fields.typing();
  const bool below = nodes::constantOnly(target.spec->type);  // the widget fills the lines under the label
  const bool onLabel = (!below || ImGui::GetIO().MousePos.y < lo.y + ImGui::GetFrameHeight()) &&
                       ImGui::GetIO().MousePos.x < lo.x + 0.38f * (hi.x - lo.x) &&
                       ImGui::GetIO().MousePos.x > lo.x + ui.theme.px(kSocket + kDot);
  const bool onKey = ImGui::GetIO().MousePos.x > hi.x - ui.theme.px(kKey);
  if (!busy && !onKey &&
      (onLabel ? panel.rest.short_
               : panel.rest.long_ && target.spec->type != ParamType::File &&
                     target.spec->type != ParamType::Enum && !below))
    drawParamTooltip(ui, target);
  else if (!busy && onLabel && clipped)
    tooltip(ui.theme, target.spec->label);
  return true;
}

}  // namespace

RowFrame rowFrame(const Theme& theme, bool wide, bool below) {
  RowFrame f;
  f.at = ImGui::GetCursorScreenPos();
  f.height = ImGui::GetFrameHeight();
  f.label = theme.px(kSocket + kDot);
  const float all = ImGui::GetContentRegionAvail().x, right = all - theme.px(kKey) - theme.px(2);
  f.widget = std::floor(std::max(f.label + theme.px(56), all * 0.40f));
  f.width = right - f.widget;
  f.stacked = below || (wide && f.width < theme.px(176));
  if (f.stacked) f.widget = f.label, f.width = right - f.label;
  return f;
}

bool rowLabel(const Theme& theme, const RowFrame& f, const std::string& label, bool strong) {
  const float room = (f.stacked ? f.width : f.widget - f.label) - theme.space(1);
  // A long label is written smaller before it is cut.
  ImFont* font = textWidth(theme.body, label) > room ? theme.small : theme.body;
  editor::drawText(ImGui::GetWindowDrawList(), font,
                   {f.at.x + f.label, f.at.y + 0.5f * (f.height - font->FontSize)},
                   strong ? palette::kText : palette::kTextDim, label, room);
  return textWidth(font, label) > room;
}

bool modifiedDot(Ui& ui, const std::string& id, const char* help, const RowFrame& f) {
  const Theme& theme = ui.theme;
  ImGui::SetCursorScreenPos({f.at.x + theme.px(kSocket), f.at.y});
  const bool reset = ImGui::InvisibleButton("reset", {theme.px(kDot), f.height});
  ui.trace.item("modified/" + id);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) tooltip(theme, help);
  ImGui::GetWindowDrawList()->AddCircleFilled(
      {f.at.x + theme.px(kSocket + 4), std::round(f.at.y + 0.5f * f.height)}, theme.px(hovered ? 4.0f : 2.5f),
      palette::kAccent);
  return reset;
}

void toWidget(const RowFrame& f) {
  ImGui::SetCursorScreenPos({f.at.x + f.widget, f.stacked ? f.at.y + f.height : f.at.y});
}

void drawRefusal(Ui& ui, const Parameters& parameters, const std::string& key) {
  const Parameters& panel = parameters;
  const bool staying = ui.fields.number.wasRefused && ui.fields.typing();
  if (panel.refusedKey != key || (!staying && ImGui::GetTime() - panel.refusedAt > 8)) return;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.theme.px(kSocket + kDot));
  ImGui::PushTextWrapPos();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
  ImGui::PushFont(ui.theme.small);
  ImGui::TextUnformatted(ui.fields.number.refusal.c_str());
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ui.trace.note("refusal", ui.fields.number.refusal);
}

void drawParamRow(const ParameterRoom& room, const ParamTarget& target) {
  const ParamSpec& spec = *target.spec;
  const ParamState state = paramState(room.session, room.clock, target);
  if (room.parameters.onlyModified && !state.modified && !state.linked() && !state.exposed) return;
  ImGui::PushID(spec.id.c_str());
  const bool wide = spec.type == ParamType::Vector || spec.type == ParamType::Color;
  const RowFrame f = rowFrame(room.ui.theme, wide, nodes::constantOnly(spec.type));
  const bool lit = room.parameters.litParam == spec.id;
  socketMark(room.ui, room.session, room.clock, target, state, f, lit);
  const bool reset =
      state.modified && modifiedDot(room.ui, spec.id, "Changed; click to reset (Backspace)", f);
  const bool clipped = rowLabel(room.ui.theme, f, spec.label, state.modified);
  ImGui::SetCursorScreenPos(f.at);
  keyMark(room.ui, room.session, room.clock, target, state, f, lit);
  toWidget(f);
  ImGui::BeginGroup();
  if (state.linked())
    drawLinked(room.ui, room.session, room.shown, target, state, f.width);
  else if (state.faulty) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("unreadable in the file");
  } else {
    drawParamWidget({room, target, state, f.width});
  }
  ImGui::EndGroup();
  room.ui.trace.item("param/" + spec.id);
  const float bottom = std::max(ImGui::GetItemRectMax().y, f.at.y + f.height);
  const float right = f.at.x + ImGui::GetContentRegionMax().x;
  const bool hovered = hoverRow(room.ui, room.parameters, target, {f.at.x, f.at.y},
                                {right, bottom + ImGui::GetStyle().ItemSpacing.y}, clipped);
  if (hovered) room.parameters.nextLit = spec.id;
  drawMenu(room, target, state);
  ImGui::SetCursorScreenPos({f.at.x, bottom + ImGui::GetStyle().ItemSpacing.y});
  drawRefusal(room.ui, room.parameters, target.key());
  ImGui::PopID();
  if (reset) resetParam(room.ui, room.session, target);
}

}  // namespace pileus::editor
