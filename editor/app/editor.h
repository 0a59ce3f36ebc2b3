#pragma once
// The state of one editor window: the parts, each of which lives in its own file. Drawing and commands are
// free functions over it.
#include <memory>
#include <string>

#include "editor/commands/command_palette.h"
#include "editor/commands/menu.h"
#include "editor/dialogs/dialogs.h"
#include "editor/document/drops.h"
#include "editor/document/exporter.h"
#include "editor/document/graph_pictures.h"
#include "editor/document/recovery.h"
#include "editor/exchange/messages.h"
#include "editor/graph_view/canvas.h"
#include "editor/lab/lab.h"
#include "editor/lab/ray_scope.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/compare_mode.h"
#include "editor/picture/preview.h"
#include "editor/preferences/settings.h"
#include "editor/start/start_view.h"
#include "editor/start/tour.h"
#include "editor/status/log_panel.h"
#include "editor/time/timeline.h"
#include "editor/toolkit/file_browser.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/window.h"
#include "editor/viewport/viewport.h"
#include "nodes/graph/document.h"
#include "renderer/view/renderer.h"

namespace pileus::editor {

/// Panels that have keys of their own; Global ones work everywhere.
enum class Panel { Global, Viewport, Graph, Parameters, Scope, Lab, Log, Timeline };

struct Editor {
  Editor(Window& theWindow, std::unique_ptr<view::Renderer> theRenderer, Theme theTheme)
      : window(&theWindow),
        renderer(std::move(theRenderer)),
        theme(std::move(theTheme)),
        preview(renderer.get()),
        exporter(renderer.get()),
        viewport(*renderer) {}

  Window* window;
  std::unique_ptr<view::Renderer> renderer;  // before everything that holds GPU objects
  Theme theme;
  Settings settings;
  nodes::Document document;
  Preview preview;
  Exporter exporter;
  Viewport viewport;
  CompareMode compare;
  RayScope scope;
  Lab lab;
  LogPanel logPanel;
  Canvas canvas;
  Timeline timeline;
  Parameters parameters;
  FileBrowser browser;
  Dialogs dialogs;
  CommandPalette commands;
  MenuBar menuBar;
  Messages messages;
  Recovery recovery;
  GraphPictures pictures;
  Drops drops;
  StartView start;
  Tour tour;
  Key diskStamp{};  ///< of the document's file as it was last read or written here
  UiTrace trace;
  int frame = 1;                    ///< the current one: where keys are set and values shown
  Panel hovered = Panel::Global;    ///< under the pointer: whose keys act
  Panel maximised = Panel::Global;  ///< fills the window; Global: none does
  float uiScale = 0;                ///< chosen for this session; 0: the screen's
  double uiMs = 0;     ///< CPU time of it on the interface alone, new frame to draw data, traces left out
  double frameMs = 0;  ///< of the last frame drawn, evaluation included
  bool quit = false;
};

/// An edit that may be refused: shows the reason in the status line, returns whether it was made.
bool tryEdit(Editor& editor, Result<nodes::Graph> graph, const std::string& label,
             std::string_view mergeKey = {});
/// The same for the whole document, whatever scope the canvas shows.
bool tryEditRoot(Editor& editor, Result<nodes::Graph> root, const std::string& label,
                 std::string_view mergeKey = {});
/// A different document was put in place: forgets what belonged to the old one.
void documentReplaced(Editor& editor);

}  // namespace pileus::editor
