#pragma once
// Help on parameters and nodes, from their declarations: the tooltip of a row, and a page for the whole node.
#include <string>

#include "editor/parameters/param_edit.h"

namespace pileus::editor {

struct Parameters;
struct Session;
struct Ui;

struct HelpPage {
  std::string type;   ///< node type shown; "" = closed
  std::string param;  ///< marked in it
  bool scroll = false, appear = false;

  bool open() const { return !type.empty(); }
};

/// Label, help, default, range, unit and id.
void drawParamTooltip(Ui& ui, const ParamTarget& target);
/// Opens the page of a node's type at a parameter ("" = its top).
void openHelpPage(Ui& ui, const Session& session, Parameters& parameters, const std::string& node,
                  const std::string& param);
void drawHelpPage(Ui& ui, Parameters& parameters);
/// For F1: the page of what the pointer means, or the shortcut sheet.
void openHelp(Ui& ui, const Session& session, Parameters& parameters);

}  // namespace pileus::editor
