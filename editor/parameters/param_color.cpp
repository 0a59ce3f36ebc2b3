// The widget of a colour: a swatch that opens the picker, and the numbers in the working space.
#include <cmath>

#include "editor/app/editor.h"
#include "editor/parameters/color_picker.h"
#include "editor/parameters/param_widgets.h"

namespace pileus::editor {

void drawColor(const ParamWidget& w) {
  Editor& editor = w.editor;
  const Theme& theme = editor.theme;
  const dvec3 color = std::get<dvec3>(w.state.value);
  const float height = ImGui::GetFrameHeight(), swatch = std::round(height * 1.3f);
  if (colorSwatch(editor, "swatch", color, {swatch, height}, w.state.mixed())) ImGui::OpenPopup("picker");
  editor.trace.item("swatch/" + w.target.spec->id);
  ImGui::SameLine(0, theme.px(4));
  drawThree(w, w.width - swatch - theme.px(4));
  ColorPicker& picker = editor.parameters.picker;
  if (!ImGui::BeginPopup("picker")) {
    if (picker.open && picker.key == w.target.key()) closeColorPicker(picker, color);
    return;
  }
  picker.key = w.target.key();
  dvec3 next = color;
  const ColorEdit edit = drawColorPicker(editor, next, w.target.spec->hardMin, w.target.spec->hardMax);
  editor.trace.rect("picker", ImGui::GetWindowPos(),
                    {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
                     ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  if (edit.changed && !edit.cancelled) setParamValue(editor, w.target, next, edit.dragging);
  if (edit.finished) endParamEdit(editor, w.target, edit.cancelled);
  if (edit.eyedropper) {
    editor.parameters.eyedropper.target = w.target;
    editor.parameters.eyedropper.into = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
