#pragma once
// The widgets of parameters by type. Each draws at the cursor, `width` wide, and makes the edits.
#include <string_view>

#include "editor/parameters/param_edit.h"
#include "editor/toolkit/number_field.h"

namespace pileus::editor {

struct ParameterRoom;
struct Parameters;
struct Session;
struct Theme;

struct ParamWidget {
  const ParameterRoom& room;
  const ParamTarget& target;
  const ParamState& state;
  float width;
};

void drawParamWidget(const ParamWidget& w);

NumberField numberFieldOf(const nodes::ParamSpec& spec);
/// What a number field did, as an edit of component `axis` (-1: a single number).
void applyNumber(const ParamWidget& w, const NumberEdit& edit, double before, double after, int axis);
void drawThree(const ParamWidget& w, float width);
void drawColor(const ParamWidget& w);
/// A graph over the histogram of what comes in, the selected point's numbers and presets below.
void drawCurve(const ParamWidget& w);
/// A bar of colours with its stops as handles.
void drawRamp(const ParamWidget& w);
void drawText(const ParamWidget& w, float width);
void drawFile(const ParamWidget& w);
/// A name of a grid in the node's .vdb file, to choose or to type.
void drawGridName(const ParamWidget& w);
bool isGridName(const nodes::NodeType& type, const nodes::ParamSpec& spec);

/// A text field with its state kept in Parameters; true when a new text is there.
bool textField(const Session& session, Parameters& parameters, const std::string& key, std::string& text,
               float width, const char* hint, const std::vector<std::string>* completeKinds = nullptr);
/// A toggle, drawn as a switch; true if clicked.
bool switchField(const Theme& theme, const char* id, bool on, bool mixed);

}  // namespace pileus::editor
