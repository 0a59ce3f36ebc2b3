#include "editor/parameters/param_widgets.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/time/playback.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "renderer/scene/light.h"

namespace pileus::editor {
namespace {

using nodes::ParamSpec;
using nodes::ParamType;
using nodes::ParamValue;

void drawNumber(const ParamWidget& w) {
  const bool integer = w.target.spec->type == ParamType::Int;
  const double before = integer ? std::get<int>(w.state.value) : std::get<double>(w.state.value);
  double number = before;
  NumberField f = numberFieldOf(*w.target.spec);
  f.mixed = w.state.mixed();
  const NumberEdit edit =
      numberField(w.room.ui.fields.number, w.room.ui.theme, w.target.spec->id.c_str(), number, f, w.width);
  applyNumber(w, edit, before, number, -1);
}

/// A few short choices side by side: true where they fit.
bool drawSegments(const ParamWidget& w) {
  const std::vector<nodes::Choice>& choices = w.target.spec->choices;
  if (choices.size() > 3 || choices.empty()) return false;
  const Theme& theme = w.room.ui.theme;
  const float each =
      std::floor((w.width - static_cast<float>(choices.size() - 1)) / static_cast<float>(choices.size()));
  for (const nodes::Choice& c : choices)
    if (textWidth(theme.body, c.label) + theme.px(10) > each) return false;
  const std::string& id = std::get<std::string>(w.state.value);
  const float height = ImGui::GetFrameHeight();
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const nodes::Choice& c = choices[i];
    if (i > 0) ImGui::SameLine(0, 1);
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const bool last = i + 1 == choices.size(), on = c.id == id && !w.state.mixed();
    const float width = last ? w.width - (each + 1) * static_cast<float>(i) : each;
    if (ImGui::InvisibleButton(c.id.c_str(), {width, height}) && !on) setParamValue(w.room, w.target, c.id);
    w.room.ui.trace.item("choice/" + c.id);
    const bool hovered = ImGui::IsItemHovered();
    const ImDrawFlags corners = choices.size() == 1 ? ImDrawFlags_RoundCornersAll
                                : i == 0            ? ImDrawFlags_RoundCornersLeft
                                : last              ? ImDrawFlags_RoundCornersRight
                                                    : ImDrawFlags_RoundCornersNone;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(lo, {lo.x + width, lo.y + height},
                        on        ? palette::kAccentDim
                        : hovered ? palette::kFieldHover
                                  : palette::kField,
                        theme.px(4), corners);
    const float text = textWidth(theme.body, c.label);
    drawText(draw, theme.body, {lo.x + 0.5f * (width - text), lo.y + 0.5f * (height - theme.body->FontSize)},
             on        ? palette::kTextStrong
             : hovered ? palette::kText
                       : palette::kTextDim,
             c.label, width);
    if (hovered && !c.help.empty() && w.room.parameters.rest.long_) tooltip(theme, c.help);
  }
  return true;
}

void drawEnum(const ParamWidget& w) {
  if (drawSegments(w)) return;
  const std::string& id = std::get<std::string>(w.state.value);
  const nodes::Choice* current = nullptr;
  for (const nodes::Choice& c : w.target.spec->choices)
    if (c.id == id && !w.state.mixed()) current = &c;
  const std::string shown = w.state.mixed() ? "\xe2\x80\x93" : current ? current->label : id;
  if (!beginCombo(w.room.ui.theme, "##combo", shown, w.width)) return;
  for (const nodes::Choice& c : w.target.spec->choices) {
    if (ImGui::Selectable(c.label.c_str(), &c == current)) setParamValue(w.room, w.target, c.id);
    w.room.ui.trace.item("choice/" + c.id);
    if (!c.help.empty() && ImGui::IsItemHovered()) tooltip(w.room.ui.theme, c.help);
  }
  ImGui::EndCombo();
}

}  // namespace

NumberField numberFieldOf(const ParamSpec& spec) {
  NumberField f;
  f.softMin = spec.softMin, f.softMax = spec.softMax;
  f.hardMin = spec.hardMin, f.hardMax = spec.hardMax;
  f.integer = spec.type == ParamType::Int;
  f.logarithmic = spec.logarithmic;
  f.unit = spec.unit.c_str();
  f.takesKelvin = spec.type == ParamType::Color;
  return f;
}

void applyNumber(const ParamWidget& w, const NumberEdit& edit, double before, double after, int axis) {
  const ParameterRoom& room = w.room;
  const ParamSpec& spec = *w.target.spec;
  if (edit.began && w.state.animated) stopPlayback(room.clock);  // the key is for the frame that was seen
  if (edit.kelvin) {
    const dvec3 color = glm::round(dvec3(scene::temperatureColor(*edit.kelvin)) * 1e4) / 1e4;
    setParamValue(room, w.target, glm::clamp(color, dvec3(spec.hardMin), dvec3(spec.hardMax)));
  } else if (edit.changed && axis < 0) {
    setParamValue(room, w.target,
                  spec.type == ParamType::Int ? ParamValue(static_cast<int>(after)) : ParamValue(after),
                  edit.dragging);
  } else if (edit.changed) {
    // Colours and ratios move along in proportion, places by the same distance.
    const bool ratio = (spec.type == ParamType::Color || spec.logarithmic) && before != 0;
    changeParam(
        room, w.target,
        [&](const ParamValue& own) -> ParamValue {
          dvec3 v = std::get<dvec3>(own);
          if (edit.gang)
            for (int i = 0; i < 3; ++i)
              v[i] = std::clamp(i == axis ? after
                                : ratio   ? v[i] * after / before
                                          : v[i] + (after - before),
                                spec.hardMin, spec.hardMax);
          v[axis] = after;
          return v;
        },
        edit.dragging);
  }
  if (edit.finished) endParamEdit(room.ui, room.session, room.parameters, w.target, edit.cancelled);
  Parameters& panel = room.parameters;
  if (edit.refused)
    panel.refusedKey = w.target.key(), panel.refusedAt = ImGui::GetTime();
  else if ((edit.changed || edit.finished) && panel.refusedKey == w.target.key())
    panel.refusedKey.clear();
}

void drawThree(const ParamWidget& w, float width) {
  const dvec3 v = std::get<dvec3>(w.state.value);
  const float gap = w.room.ui.theme.px(4), each = std::floor((width - 2 * gap) / 3);
  const ImU32 marks[3] = {palette::kAxisX, palette::kAxisY, palette::kAxisZ};
  for (int i = 0; i < 3; ++i) {
    NumberField f = numberFieldOf(*w.target.spec);
    f.showUnit = false;
    f.mark = marks[i];
    f.mixed = w.state.differs[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    double number = v[i];
    const NumberEdit edit = numberField(w.room.ui.fields.number, w.room.ui.theme, w.target.spec->id.c_str(),
                                        number, f, i < 2 ? each : width - 2 * (each + gap));
    w.room.ui.trace.item("param/" + w.target.spec->id + "/" + std::to_string(i));
    ImGui::PopID();
    if (i < 2) ImGui::SameLine(0, gap);
    applyNumber(w, edit, v[i], number, i);
  }
}

bool switchField(const Theme& theme, const char* id, bool on, bool mixed) {
  const float height = ImGui::GetFrameHeight(), h = theme.px(18), width = theme.px(34);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(id, {width, height});
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 lo = {at.x, at.y + std::round(0.5f * (height - h))}, hi = {lo.x + width, lo.y + h};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const bool lit = on && !mixed;
  draw->AddRectFilled(lo, hi,
                      lit       ? (hovered ? palette::kAccentHover : palette::kAccentDim)
                      : hovered ? palette::kFieldHover
                                : palette::kField,
                      0.5f * h);
  draw->AddRect(lo, hi, lit ? palette::kAccent : palette::kTextFaint, 0.5f * h);
  const float y = 0.5f * (lo.y + hi.y), r = 0.5f * h - theme.px(3);
  const float x = mixed ? 0.5f * (lo.x + hi.x) : lit ? hi.x - 0.5f * h : lo.x + 0.5f * h;
  if (mixed)
    draw->AddRectFilled({x - r, y - theme.px(1)}, {x + r, y + theme.px(1)}, palette::kText);
  else
    draw->AddCircleFilled({x, y}, r, lit ? palette::kTextStrong : palette::kTextDim);
  return clicked;
}

/// Over the field of a path that does not fit: its end, which names the file.
void showEndOfPath(const std::string& path) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  ImFont* font = ImGui::GetFont();
  const float room = hi.x - lo.x - 2 * style.FramePadding.x;
  if (textWidth(font, path) <= room) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(lo, hi,
                      ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                      style.FrameRounding);
  drawText(draw, font, {lo.x + style.FramePadding.x, lo.y + style.FramePadding.y},
           ImGui::GetColorU32(ImGuiCol_Text), endOfPath(font, path, room), room + 1);
  noteCut(vec(lo), vec(hi), path);
}

bool textField(const Session& session, Parameters& parameters, const std::string& key, std::string& text,
               float width, const char* hint, const std::vector<std::string>* completeKinds) {
  Parameters& panel = parameters;
  const bool editing = panel.textKey == key;
  const std::string before = text;
  if (editing) text = panel.text;
  struct Completion {
    std::filesystem::path folder;
    const std::vector<std::string>* kinds;
  } completion{session.document.path().parent_path(), completeKinds};
  const auto complete = [](ImGuiInputTextCallbackData* data) {
    const auto& c = *static_cast<Completion*>(data->UserData);
    const std::string typed(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    const std::string longer = completedPath(typed, c.folder, *c.kinds);
    if (longer == typed) return 0;
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, longer.c_str());
    return 0;
  };
  ImGui::SetNextItemWidth(width);
  const ImGuiInputTextFlags flags =
      ImGuiInputTextFlags_EnterReturnsTrue | (completeKinds ? ImGuiInputTextFlags_CallbackCompletion : 0);
  const bool enter = completeKinds
                         ? ImGui::InputTextWithHint("##text", hint, &text, flags, complete, &completion)
                         : ImGui::InputTextWithHint("##text", hint, &text, flags);
  const bool active = ImGui::IsItemActive();
  if (completeKinds && !active) showEndOfPath(text);
  if (active) panel.textKey = key, panel.text = text;
  const bool cancelled = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  const bool done = (enter || (editing && ImGui::IsItemDeactivated() && !cancelled)) && text != before;
  if (editing && !active) panel.textKey.clear();
  if (!done) text = before;
  return done;
}

void drawText(const ParamWidget& w, float width) {
  std::string text = w.state.mixed() ? "" : std::get<std::string>(w.state.value);
  if (textField(w.room.session, w.room.parameters, w.target.key(), text, width,
                w.state.mixed() ? "\xe2\x80\x93" : "default"))
    setParamValue(w.room, w.target, text);
}

void drawParamWidget(const ParamWidget& w) {
  switch (w.target.spec->type) {
    case ParamType::Bool: {
      const bool on = std::get<bool>(w.state.value);
      if (switchField(w.room.ui.theme, "switch", on, w.state.mixed()))
        setParamValue(w.room, w.target, w.state.mixed() || !on);
      return;
    }
    case ParamType::Int:
    case ParamType::Float:
      return drawNumber(w);
    case ParamType::Vector:
      return drawThree(w, w.width);
    case ParamType::Color:
      return drawColor(w);
    case ParamType::Text: {
      const nodes::Node* node = nodes::findNode(w.room.session.document.graph(), w.target.nodes.front());
      const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
      return type && isGridName(*type, *w.target.spec) ? drawGridName(w) : drawText(w, w.width);
    }
    case ParamType::File:
      return drawFile(w);
    case ParamType::Enum:
      return drawEnum(w);
    case ParamType::Curve:
      return drawCurve(w);
    case ParamType::Ramp:
      return drawRamp(w);
  }
}

}  // namespace pileus::editor
