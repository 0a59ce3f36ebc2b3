#pragma once
// What everything that is drawn needs: how it looks, where it says what happened, and what it asks of others.
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "editor/exchange/messages.h"
#include "editor/exchange/panel.h"
#include "editor/exchange/requests.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/fields.h"
#include "editor/toolkit/modals.h"
#include "editor/toolkit/pointer_rest.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui_trace.h"

namespace pileus::editor {

class Messages;
class Requests;
struct Theme;

/// The frame that is being drawn.
struct FrameState {
  Panel hovered = Panel::Global;    ///< under the pointer: whose keys act
  Panel maximised = Panel::Global;  ///< fills the window; Global: none does
  float uiScale = 0;                ///< chosen for this session; 0: the screen's
  double uiMs = 0;     ///< CPU time of the last interface alone, new frame to draw data, traces left out
  double frameMs = 0;  ///< of the last frame drawn, evaluation included
  CutTexts cut;        ///< texts without room
  PointerRest rest;    ///< over any of the window, for those
};

/// A command of the table as a menu shows it.
struct CommandLook {
  const char* label = "";
  const char* icon = nullptr;  ///< null: none
  std::string keys;            ///< "Ctrl+S"; "" = none
  bool enabled = true, checked = false;
};
/// By id; nothing for one that is not in the table.
using CommandLooks = std::function<std::optional<CommandLook>(std::string_view id)>;

struct Ui {
  const Theme& theme;
  UiTrace& trace;
  Messages& messages;
  Requests& requests;
  Fields& fields;
  Modals& modals;
  FrameState& now;
  const CommandLooks& commands;
};

/// A row of an open menu that runs a command; traced as "menu/ID".
void commandMenuItem(Ui& ui, std::string_view id);

}  // namespace pileus::editor
