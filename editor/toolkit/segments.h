#pragma once
// A row of exclusive choices, drawn as one control.
#include <string>

#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/widgets.h"
#include "renderer/base/enum_info.h"

namespace pileus::editor {

struct Ui;

/// One segment at the cursor, which moves on; true if clicked. `first` and `last` round their outer corners.
bool segment(Ui& ui, const std::string& trace, std::string_view label, std::string_view help, bool on,
             bool first, bool last);

/// Segments for all values of an enum; true if `value` changed. Traced as "PREFIX/id".
template <DescribedEnum E>
bool segments(Ui& ui, const std::string& prefix, E& value) {
  constexpr auto items = enumInfo(static_cast<E*>(nullptr));
  bool changed = false;
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
