#include "editor/editor.h"

#include <utility>

#include "editor/app/trace_report.h"
#include "editor/commands/actions.h"
#include "editor/commands/command_palette.h"
#include "editor/commands/library/presets.h"
#include "editor/commands/menu.h"
#include "editor/commands/shortcut_sheet.h"
#include "editor/document/drops.h"
#include "editor/document/graph_pictures.h"
#include "editor/document/preset_shelf.h"
#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/graph_room.h"
#include "editor/lab/lab.h"
#include "editor/lab/lab_room.h"
#include "editor/lab/ray_scope.h"
#include "editor/lights/lights_panel.h"
#include "editor/lights/lights_room.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/exporter.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/preferences/settings_file.h"
#include "editor/start/start_room.h"
#include "editor/start/start_view.h"
#include "editor/start/tour.h"
#include "editor/status/log_panel.h"
#include "editor/status/status_room.h"
#include "editor/time/clock.h"
#include "editor/timeline_view/timeline_room.h"
#include "editor/timeline_view/timeline_state.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/window.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"
#include "renderer/base/file.h"

namespace pileus::editor {

/// In the order in which they need each other: what holds GPU objects goes before the renderer does.
struct Editor::Parts {
  Parts(Editor& editor, std::unique_ptr<view::Renderer> theRenderer, Theme theTheme, Settings theSettings)
      : renderer(std::move(theRenderer)),
        settings(std::move(theSettings)),
        settingsFile(configFolder(), settings),
        theme(std::move(theTheme)),
        commandLooks([&editor](std::string_view id) { return commandLook(editor, id); }),
        shown(*renderer),
        exporter(renderer.get()) {}

  std::unique_ptr<view::Renderer> renderer;
  Settings settings;
  SettingsFile settingsFile;
  Theme theme;
  UiTrace trace;
  TraceReport report;
  Messages messages;
  Requests requests;
  Fields fields;
  Modals modals;
  FrameState now;
  CommandLooks commandLooks;
  Ui ui{theme, trace, messages, requests, fields, modals, now, commandLooks};

  Session session;
  Clock clock;
  Shown shown;
  Exporter exporter;
  Drops drops;
  GraphPictures pictures;
  PresetShelf presets;

  Canvas canvas;
  Viewport viewport;
  Parameters parameters;
  Timeline timeline;
  RayScope scope;
  Lab lab;
  LightsPanel lights;
  LogPanel logPanel;
  StartView start;
  Tour tour;
  MenuBar menuBar;
  CommandPalette commands;
  ShortcutSheet sheet;
  PresetDialog presetDialog;

  GraphRoom graphRoom{ui, session, clock, shown, settings, canvas, presets};
  ViewportRoom viewportRoom{ui, session, clock, shown, settings, viewport};
  ParameterRoom parameterRoom{ui, session, clock, shown, settings, parameters, pictures};
  TimelineRoom timelineRoom{ui, session, clock, shown, settings, timeline};
  LabRoom labRoom{ui, session, clock, shown, settings, lab};
  LightsRoom lightsRoom{ui, session, clock, shown, settings, lights};
  StatusRoom statusRoom{ui, session, clock, shown, exporter, logPanel};
  StartRoom startRoom{ui, settings, pictures, presets, start};
};

Editor::Editor(Window& theWindow, std::unique_ptr<view::Renderer> theRenderer, Theme theTheme,
               Settings theSettings)
    : parts_(std::make_unique<Parts>(*this, std::move(theRenderer), std::move(theTheme),
                                     std::move(theSettings))),
      window(theWindow),
      settings(parts_->settings),
      settingsFile(parts_->settingsFile),
      ui(parts_->ui),
      theme(parts_->theme),
      trace(parts_->trace),
      report(parts_->report),
      messages(parts_->messages),
      requests(parts_->requests),
      fields(parts_->fields),
      modals(parts_->modals),
      now(parts_->now),
      session(parts_->session),
      clock(parts_->clock),
      shown(parts_->shown),
      exporter(parts_->exporter),
      drops(parts_->drops),
      pictures(parts_->pictures),
      presets(parts_->presets),
      canvas(parts_->canvas),
      viewport(parts_->viewport),
      parameters(parts_->parameters),
      timeline(parts_->timeline),
      scope(parts_->scope),
      lab(parts_->lab),
      lights(parts_->lights),
      logPanel(parts_->logPanel),
      start(parts_->start),
      tour(parts_->tour),
      menuBar(parts_->menuBar),
      commands(parts_->commands),
      sheet(parts_->sheet),
      presetDialog(parts_->presetDialog),
      graphRoom(parts_->graphRoom),
      viewportRoom(parts_->viewportRoom),
      parameterRoom(parts_->parameterRoom),
      timelineRoom(parts_->timelineRoom),
      labRoom(parts_->labRoom),
      lightsRoom(parts_->lightsRoom),
      statusRoom(parts_->statusRoom),
      startRoom(parts_->startRoom) {}

Editor::~Editor() = default;

void documentReplaced(Editor& editor) {
  ++editor.session.generation;
  editor.session.selectedLink.reset();
  editor.clock = Clock{};
  editor.clock.frame = editor.session.document.root().settings.frames.x;
  Shown& shown = editor.shown;
  shown.activeView.clear();
  shown.slots = {};
  shown.freeCamera.reset();
  shown.look = {};
  shown.around = {};
  shown.scene = {};
  shown.mode.layer = {};
  shown.mode.scan.forget();
  shown.mode.region = {};
  shown.displayed.colorsOf = "\n";
  shown.snapshots = {};
  shown.ray = {};
  shown.mixer = {};
  shown.lights = {};
  shown.preview.newDocument();
  editor.viewport.tools = {};
  editor.canvas = Canvas{};
  editor.timeline = Timeline{};
  editor.parameters = Parameters{};
  editor.fields = Fields{};
  editor.scope = RayScope{};
  editor.lab = Lab{};
  editor.lights = LightsPanel{};
}

}  // namespace pileus::editor
