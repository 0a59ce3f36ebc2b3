#include "editor/toolkit/number_field.h"

#include <fmt/core.h>
#include <imgui_internal.h>  // Tab is ours
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/number_text.h"
#include "editor/toolkit/theme.h"

namespace pileus::editor {
namespace {

constexpr double kWheelRest = 0.6;  // seconds after which wheel notches are a step of their own

void typeInto(NumberFieldState& state, ImGuiID id, double value, const NumberField& f) {
  state.typing = id;
  state.drawn = ImGui::GetFrameCount();
  state.focus = true;
  state.live = state.wasRefused = false;
  state.onwards = state.next = 0;
  state.before = value;
  state.refusal.clear();
  state.text = state.initial = f.mixed ? "" : numberText(value, f.integer);
}

/// Why the text cannot be the value; "" = it can, and `value` is set.
std::string commit(const std::string& text, double current, double& value, const NumberField& f) {
  const Result<double> typed = numberFromText(text, {current, f.unit});
  if (!typed) return typed.error().message;
  if (f.integer && *typed != std::floor(*typed)) return "A whole number is needed.";
  if (*typed < f.hardMin || *typed > f.hardMax)
    return fmt::format("{} is out of range: {} to {}.", numberText(*typed, f.integer),
                       numberText(f.hardMin, f.integer), numberText(f.hardMax, f.integer));
  value = *typed;
  return {};
}

struct Arrows {
  bool stepped = false;
};

/// Up and down change the digit at the caret.
int onArrow(ImGuiInputTextCallbackData* data) {
  if (data->EventFlag != ImGuiInputTextFlags_CallbackHistory) return 0;
  const auto next = steppedDigit({data->Buf, static_cast<std::size_t>(data->BufTextLen)}, data->CursorPos,
                                 data->EventKey == ImGuiKey_UpArrow ? 1 : -1);
  if (!next) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, next->text.c_str());
  data->CursorPos = data->SelectionStart = data->SelectionEnd = next->caret;
  static_cast<Arrows*>(data->UserData)->stepped = true;
  return 0;
}

/// The end of typing by Enter or Tab, which stay where the text cannot be, or by going elsewhere.
void endTyping(NumberFieldState& state, NumberEdit& edit, double& value, const NumberField& f, bool enter) {
  const double shown = value;
  if (f.takesKelvin) edit.kelvin = kelvinFromText(state.text);
  const bool untouched = state.text == (f.mixed ? "" : numberText(state.before, f.integer));
  state.refusal = edit.kelvin || untouched ? "" : commit(state.text, state.before, value, f);
  edit.refused = !state.refusal.empty();
  edit.changed = value != shown || (f.mixed && !untouched && !edit.refused);
  edit.dragging = state.live;  // with what the arrows did: one step
  state.wasRefused = edit.refused && enter;
  if (state.wasRefused) return void(state.focus = true);  // stays, to be mended
  if (edit.refused) state.dropped = fmt::format("\"{}\" was not taken. {}", state.text, state.refusal);
  state.typing = 0;
  edit.finished = true;
}

NumberEdit typeField(NumberFieldState& state, const Theme& theme, double& value, const NumberField& f,
                     float width) {
  NumberEdit edit;
  ImGui::SetNextItemWidth(width);
  const bool first = state.focus;
  edit.began = first;
  if (first) ImGui::SetKeyboardFocusHere();
  if (first) state.focused = false, state.asked = ImGui::GetFrameCount();
  state.focus = false;
  Arrows arrows;
  const bool enter =
      ImGui::InputText("##typed", &state.text,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                           ImGuiInputTextFlags_CallbackHistory,
                       onArrow, &arrows);
  if (ImGui::IsItemActive()) {
    state.focused = true;
    ImGui::GetCurrentContext()->ActiveIdUsingKeyInputMask |= ImU64(1) << ImGuiKey_Tab;
  }
  const bool left = !first && ImGui::IsItemDeactivated();
  const bool tab = ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false);
  if (left && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    edit.cancelled = state.live;
    edit.finished = true;
    state.refusal.clear();
    state.wasRefused = false;
    state.typing = 0;
  } else if (tab) {
    const bool back = ImGui::GetIO().KeyShift;
    endTyping(state, edit, value, f, true);
    if (state.typing == 0) {
      ImGui::ClearActiveID();
      const ImGuiID window = ImGui::GetCurrentWindow()->ID;
      state.onwards = back ? 0 : window;
      state.next = back && state.lastWindow == window ? state.last : 0;
      state.nextAt = ImGui::GetFrameCount();
    }
  } else if (enter || left) {
    endTyping(state, edit, value, f, enter);
  } else if (!state.focused && ImGui::GetFrameCount() > state.asked + kFocusFrames) {
    state.typing = 0;  // something else has the keyboard
    edit.finished = true;
  } else if (arrows.stepped) {
    double next = value;
    if (commit(state.text, state.before, next, f).empty() && next != value) {
      value = next;
      edit.changed = edit.dragging = state.live = true;
    }
  }
  if (state.wasRefused) {
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled({lo.x + theme.px(3), hi.y - theme.px(2)},
                                              {hi.x - theme.px(3), hi.y}, palette::kError);
  }
  return edit;
}

/// Where the buttons of an integer are: both at the left, which the number leaves free.
int buttonAt(const Theme& theme, ImVec2 lo, ImVec2 hi, const NumberField& f) {
  const float each = theme.px(18), x = ImGui::GetIO().MousePos.x - lo.x;
  if (!f.integer || f.locked || hi.x - lo.x < theme.px(84) || x < 0 || x >= 2 * each) return 0;
  return x < each ? -1 : 1;
}

void drawButtons(const Theme& theme, ImVec2 lo, ImVec2 hi, int over) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float each = theme.px(18), y = std::round(0.5f * (lo.y + hi.y)), r = theme.px(4),
              line = theme.px(1.5f);
  for (int i = 0; i < 2; ++i) {
    const float x = std::round(lo.x + theme.px(2) + (static_cast<float>(i) + 0.5f) * each);
    const ImU32 ink = over == (i ? 1 : -1) ? palette::kTextStrong : palette::kTextDim;
    draw->AddRectFilled({x - r, y - 0.5f * line}, {x + r, y + 0.5f * line}, ink);
    if (i) draw->AddRectFilled({x - 0.5f * line, y - r}, {x + 0.5f * line, y + r}, ink);
  }
}

void drawField(const Theme& theme, ImVec2 lo, ImVec2 hi, double value, const NumberField& f, bool lit) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float r = theme.px(4);
  draw->AddRectFilled(lo, hi,
                      f.locked ? faded(palette::kField, 0.5f)
                      : lit    ? palette::kFieldHover
                               : palette::kField,
                      r);
  if (f.hasSoft() && !f.mixed && !f.locked) {
    const FieldRows rows = fieldRows(hi.y - lo.y, theme.body->FontSize, theme.scale);
    const float x = std::round(lo.x + (hi.x - lo.x) * static_cast<float>(softShare(value, f)));
    const auto bar = [&](float from, float to, ImU32 ink) {  // within the field's rounded corners
      if (to <= from) return;
      draw->PushClipRect({from, lo.y + rows.barTop}, {to, lo.y + rows.barEnd}, true);
      draw->AddRectFilled(lo, hi, ink, r);
      draw->PopClipRect();
    };
    bar(x, hi.x, palette::kFieldTrack);
    bar(lo.x, x, lit ? palette::kAccent : palette::kFieldBar);
  }
  if (f.mark)
    draw->AddRectFilled({lo.x, lo.y + theme.px(5)}, {lo.x + theme.px(2), hi.y - theme.px(5)}, f.mark,
                        theme.px(1));
  const std::string text = f.mixed ? "\xe2\x80\x93" : numberText(value, f.integer);
  const float y = 0.5f * (lo.y + hi.y), left = lo.x + theme.px(f.mark ? 5 : 8);
  float right = hi.x - (f.mark ? theme.px(5) : theme.space(2));
  if (f.showUnit && f.unit && *f.unit) {
    const float unit = textWidth(theme.small, f.unit), number = textWidth(theme.body, text);
    if (right - left > unit + number + theme.px(8)) {
      drawText(draw, theme.small, {right - unit, y - 0.5f * theme.small->FontSize}, palette::kTextDim, f.unit,
               unit + 1);
      right -= unit + theme.px(5);
    }
  }
  // A number without room keeps its leading digits: the font that still holds them.
  ImFont* font = textWidth(theme.body, text) > right - left ? theme.small : theme.body;
  const float width = textWidth(font, text);
  drawText(draw, font, {std::max(left, right - width), y - 0.5f * font->FontSize},
           f.locked ? palette::kTextFaint : palette::kText, text, right - left + 1);
}

void dragField(NumberFieldState& state, const Theme& theme, NumberEdit& edit, double& value,
               const NumberField& f, float width) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsMouseDragging(0, 3 * theme.scale) && !state.moved) return;
  edit.began = !state.moved;
  const double pixels = state.moved ? static_cast<double>(io.MouseDelta.x)
                                    : static_cast<double>(ImGui::GetMouseDragDelta(0, 0).x);
  state.moved = true;
  state.raw = draggedValue(state.raw, pixels, static_cast<double>(width), f, io.KeyShift);
  const double lo = f.hasSoft() ? f.softMin : f.hardMin, hi = f.hasSoft() ? f.softMax : f.hardMax;
  // A value typed beyond the soft range is not pulled back by touching it.
  state.raw = std::clamp(state.raw, std::min(lo, value), std::max(hi, value));
  const double next =
      state.raw < lo || state.raw > hi ? value : tidiedValue(state.raw, f, io.KeyShift, io.KeyCtrl);
  edit.changed = next != value;
  value = next;
  edit.dragging = true;
  edit.gang = io.KeyAlt;
}

/// Ctrl+wheel over the field; a rest ends the undo step.
void wheelField(NumberFieldState& state, NumberEdit& edit, double& value, const NumberField& f, ImGuiID self,
                bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const double now = ImGui::GetTime();
  if (state.wheel == self && (!hovered || !io.KeyCtrl || now - state.wheelAt > kWheelRest)) {
    state.wheel = 0;
    edit.finished = true;
  }
  if (!hovered || !io.KeyCtrl || io.MouseWheel == 0.0f) return;
  const double next = steppedValue(value, io.MouseWheel > 0 ? 1 : -1, f, io.KeyShift);
  state.wheel = self;
  state.wheelAt = now;
  edit.changed = next != value;
  edit.dragging = true;
  edit.gang = io.KeyAlt;
  value = next;
}

}  // namespace

NumberEdit numberField(NumberFieldState& state, const Theme& theme, const char* id, double& value,
                       const NumberField& f, float width) {
  NumberEdit edit;
  ImGui::PushID(id);
  const ImGuiID self = ImGui::GetID("field");
  const ImGuiIO& io = ImGui::GetIO();
  // It was not drawn for a while: what was typed then is given up.
  if (state.typing == self && !state.shown()) state.typing = 0, state.wasRefused = false;
  const ImGuiID window = ImGui::GetCurrentWindow()->ID;
  if (state.typing == 0 && !f.locked &&
      ((state.next == self && ImGui::GetFrameCount() <= state.nextAt + 1) || state.onwards == window))
    typeInto(state, self, value, f);
  if (state.typing == self || state.active == self) state.drawn = ImGui::GetFrameCount();
  if (state.typing == self && !f.locked) {
    edit = typeField(state, theme, value, f, width);
    state.last = self, state.lastWindow = window;
    ImGui::PopID();
    return edit;
  }
  if (!f.locked) state.last = self, state.lastWindow = window;
  const ImVec2 lo = ImGui::GetCursorScreenPos(), hi = {lo.x + width, lo.y + ImGui::GetFrameHeight()};
  ImGui::InvisibleButton("field", {std::max(width, 8.0f), hi.y - lo.y});
  const bool hovered = ImGui::IsItemHovered() && !f.locked, active = ImGui::IsItemActive() && !f.locked;
  const int over = hovered || active ? buttonAt(theme, lo, hi, f) : 0;
  if (ImGui::IsItemActivated() && !f.locked) {
    state.active = self;
    state.drawn = ImGui::GetFrameCount();
    state.raw = value;
    state.moved = false;
    state.button = io.KeyCtrl ? 0 : over;
    if (io.KeyCtrl || (ImGui::IsMouseDoubleClicked(0) && !over)) typeInto(state, self, value, f);
  }
  if (active && state.active == self && state.typing != self) {
    if (state.moved && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
      edit.cancelled = edit.finished = true;
      state.moved = false;
      state.active = 0;  // the button stays held, but moves nothing any more
    } else {
      dragField(state, theme, edit, value, f, width);
    }
  }
  wheelField(state, edit, value, f, self, hovered);
  if ((hovered || active) && !over) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemDeactivated() && state.active == self) {
    edit.finished = state.moved;
    if (!state.moved && state.button && state.button == over) {
      const double next = steppedValue(value, state.button, f, false);
      edit.changed = edit.finished = next != value;
      value = next;
    }
    state.moved = false;
    state.active = 0;
  }
  drawField(theme, lo, hi, value, f, hovered || active);
  if (f.integer && (hovered || active) && !state.moved && hi.x - lo.x >= theme.px(84))
    drawButtons(theme, lo, hi, over);
  ImGui::PopID();
  return edit;
}

}  // namespace pileus::editor
