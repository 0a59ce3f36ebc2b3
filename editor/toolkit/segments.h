#pragma once
// A row of exclusive choices, drawn as one control.
#include <algorithm>
#include <string>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "renderer/base/enum_info.h"

namespace pileus::editor {

/// One segment at the cursor, which moves on; true if clicked. `first` and `last` round their outer corners.
bool segment(Ui& ui, const std::string& trace, std::string_view label, std::string_view help, bool on,
             bool first, bool last);

/// Of one segment.
float segmentWidth(const Theme& theme, std::string_view label);
/// Of all that an enum has.
template <DescribedEnum E>
float segmentsWidth(const Theme& theme, E) {
  float width = 0;
  for (const auto& item : enumInfo(static_cast<E*>(nullptr))) width += segmentWidth(theme, item.label) + 1;
  return width;
}

/// Segments for all values of an enum; true if `value` changed. Traced as "PREFIX/id". With `room` there is
/// none for them: a list no wider than that has them, traced as PREFIX.
template <DescribedEnum E>
bool segments(Ui& ui, const std::string& prefix, E& value, float room = 0) {
  constexpr auto items = enumInfo(static_cast<E*>(nullptr));
  bool changed = false;
  if (room > 0) {
    std::string shown;
    float width = 0;
    for (const auto& item : items) {
      if (item.value == value) shown = item.label;
      width = std::max(width, segmentWidth(ui.theme, item.label));
    }
    const bool open =
        beginCombo(ui.theme, ("##" + prefix).c_str(), shown, std::min(width + ui.theme.px(20), room));
    ui.trace.item(prefix);
    if (!open) return false;
    for (const auto& item : items) {
      if (ImGui::Selectable(std::string(item.label).c_str(), item.value == value))
        changed = value != item.value, value = item.value;
      ui.trace.item(prefix + "/" + std::string(item.id));
      if (ImGui::IsItemHovered()) tooltip(ui.theme, item.help);
    }
    ImGui::EndCombo();
    return changed;
  }
  ImGui::PushID(prefix.c_str());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 1);
    if (segment(ui, prefix + "/" + std::string(items[i].id), items[i].label, items[i].help,
                value == items[i].value, i == 0, i + 1 == items.size())) {
      changed = value != items[i].value;
      value = items[i].value;
    }
  }
  ImGui::PopID();
  return changed;
}

}  // namespace pileus::editor
