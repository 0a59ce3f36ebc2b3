#pragma once
// One parameter as a row: socket mark, "modified" dot, label, the widget its type asks for, and key mark.
#include <imgui.h>

#include <string>

#include "editor/parameters/param_edit.h"

namespace pileus::editor {

struct ParameterRoom;
struct Parameters;
struct Theme;
struct Ui;

void drawParamRow(const ParameterRoom& room, const ParamTarget& target);

/// Where the parts of a row are.
struct RowFrame {
  ImVec2 at;                    ///< top left
  float height = 0, label = 0;  ///< of a line; where the label begins, from the left
  float widget = 0, width = 0;  ///< where the widget begins, and its width
  bool stacked = false;         ///< the widget is below the label
};
/// `wide` widgets go below their label where the panel is narrow, those of `below` always.
RowFrame rowFrame(const Theme& theme, bool wide, bool below = false);
/// The label in its place; true if it does not fit.
bool rowLabel(const Theme& theme, const RowFrame& frame, const std::string& label, bool strong);
/// The dot of a value that is not the default; true: it was clicked, to reset that.
bool modifiedDot(Ui& ui, const std::string& id, const char* help, const RowFrame& f);
/// Moves to where the widget goes.
void toWidget(const RowFrame& frame);
/// The reason why the last text typed into the row `key` was not taken, below it.
void drawRefusal(Ui& ui, const Parameters& parameters, const std::string& key);

}  // namespace pileus::editor
