// The widget of a colour: a swatch that opens the picker, and the numbers in the working space.
#include <cmath>

#include "editor/document/session.h"
#include "editor/parameters/color_picker.h"
#include "editor/parameters/param_widgets.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {

void drawColor(const ParamWidget& w) {
  const ParameterRoom& room = w.room;
  const Theme& theme = room.ui.theme;
  const dvec3 color = std::get<dvec3>(w.state.value);
  const float height = ImGui::GetFrameHeight(), swatch = std::round(height * 1.3f);
  if (colorSwatch(room.ui.theme, room.shown, room.parameters, "swatch", color, {swatch, height},
                  w.state.mixed()))
    ImGui::OpenPopup("picker");
  room.ui.trace.item("swatch/" + w.target.spec->id);
  ImGui::SameLine(0, theme.px(4));
  drawThree(w, w.width - swatch - theme.px(4));
  ColorPicker& picker = room.parameters.picker;
  if (!ImGui::BeginPopup("picker")) {
    if (picker.open && picker.key == w.target.key()) closeColorPicker(picker, color);
    return;
  }
  picker.key = w.target.key();
  dvec3 next = color;
  const ColorEdit edit = drawColorPicker(room.ui, room.shown, room.parameters, next, w.target.spec->hardMin,
                                         w.target.spec->hardMax);
  room.ui.trace.rect("picker", ImGui::GetWindowPos(),
                     {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
                      ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  if (edit.changed && !edit.cancelled) setParamValue(room, w.target, next, edit.dragging);
  if (edit.finished) endParamEdit(room.ui, room.session, room.parameters, w.target, edit.cancelled);
  if (edit.eyedropper) {
    room.parameters.eyedropper.target = w.target;
    room.parameters.eyedropper.into = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
