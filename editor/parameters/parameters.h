#pragma once
// The parameter panel: the selected node's name, parameters (from its declaration alone), faults and
// statistics; of several nodes of a type what they share; with nothing selected, the document's settings.
#include <imgui.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "editor/parameters/color_picker.h"
#include "editor/parameters/eyedropper.h"
#include "editor/parameters/file_state.h"
#include "editor/parameters/grid_names.h"
#include "editor/parameters/param_edit.h"
#include "editor/parameters/param_help.h"
#include "editor/parameters/point_edit.h"
#include "editor/parameters/variation_rows.h"
#include "editor/picture/display_color.h"
#include "editor/toolkit/number_field.h"
#include "editor/toolkit/pointer_rest.h"

namespace pileus::editor {

struct ParameterRoom;
struct Session;
struct Fields;
struct FrameState;

struct Parameters {
  std::string refusedKey;        ///< "Node.param" whose last typed value was refused (numbers.refusal)
  double refusedAt = -1e9;       ///< ImGui time of that
  std::string nameOf, nameText;  ///< the name being edited
  std::string textKey, text;     ///< the text parameter being edited ("Node.param") and its state

  std::string pinned;                    ///< node that is shown whatever is selected; "" or gone = none
  bool onlyModified = false;             ///< hides what has its default
  std::optional<ParamTarget> hovered;    ///< row under the pointer, as last drawn: what keys act on
  std::string litParam, nextLit;         ///< its parameter, this frame and the next
  std::map<std::string, float> scrolls;  ///< by node
  std::string scrollOf;                  ///< node whose rows were drawn last
  ImVec2 min{0, 0};                      ///< of the panel
  PointerRest rest;
  DragMemory drag;
  VariationRows variations;
  std::optional<nodes::Settings> settingsBefore;  ///< when a drag of a setting began
  DisplayColors colors;
  ColorPicker picker;
  Eyedropper eyedropper;
  FileStates files;
  GridNames grids;
  PointEdit points;
  DensityHistograms densities;
  HelpPage help;
};

void drawParameters(const ParameterRoom& room, ImVec2 min, ImVec2 max);
/// What the panel shows: the pinned node, or the selection if it is of one type; else nothing.
std::vector<std::string> shownNodes(const Session& session, const Parameters& parameters);

/// Is something going on in the panel that Esc and letters belong to?
bool keysAreTaken(const Fields& fields, const Parameters& panel);
/// For keys: the row under the pointer, where that is in the panel; null: there is none.
const ParamTarget* hoveredParam(const FrameState& now, const Parameters& panel);

}  // namespace pileus::editor
