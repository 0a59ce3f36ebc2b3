#pragma once
// The owner of one editor window's parts, named here and defined in their rooms. Only commands, dialogs and
// the main loop see it; everything else takes the parts that it shows or changes.
#include <memory>

namespace pileus::view {
class Renderer;
}

namespace pileus::editor {

class Drops;
class Exporter;
class GraphPictures;
class Messages;
class PresetShelf;
class Requests;
class SettingsFile;
class TraceReport;
class UiTrace;
class Window;
struct Canvas;
struct Clock;
struct CommandPalette;
struct Fields;
struct FrameState;
struct GraphRoom;
struct Lab;
struct LabRoom;
struct LightsPanel;
struct LightsRoom;
struct LogPanel;
struct MenuBar;
struct Modals;
struct ParameterRoom;
struct Parameters;
struct PresetDialog;
struct RayScope;
struct Session;
struct Settings;
struct ShortcutSheet;
struct Shown;
struct StartRoom;
struct StartView;
struct StatusRoom;
struct Theme;
struct Timeline;
struct TimelineRoom;
struct Tour;
struct Ui;
struct Viewport;
struct ViewportRoom;

struct Editor {
  Editor(Window& theWindow, std::unique_ptr<view::Renderer> theRenderer, Theme theTheme,
         Settings theSettings);
  ~Editor();
  Editor(const Editor&) = delete;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;

 public:
  Window& window;
  Settings& settings;          ///< preferences/settings.h
  SettingsFile& settingsFile;  ///< preferences/settings_file.h

  // How it is drawn, and what is said.
  Ui& ui;  ///< toolkit/ui.h
  Theme& theme;
  UiTrace& trace;
  TraceReport& report;
  Messages& messages;
  Requests& requests;
  Fields& fields;
  Modals& modals;
  FrameState& now;

  // What is true.
  Session& session;  ///< document/session.h
  Clock& clock;      ///< time/clock.h
  Shown& shown;      ///< picture/shown.h
  Exporter& exporter;
  Drops& drops;
  GraphPictures& pictures;
  PresetShelf& presets;

  // What the rooms remember of how they are looked at.
  Canvas& canvas;
  Viewport& viewport;
  Parameters& parameters;
  Timeline& timeline;
  RayScope& scope;
  Lab& lab;
  LightsPanel& lights;
  LogPanel& logPanel;
  StartView& start;
  Tour& tour;
  MenuBar& menuBar;
  CommandPalette& commands;
  ShortcutSheet& sheet;
  PresetDialog& presetDialog;

  // The parts by room, for functions that need more than four.
  const GraphRoom& graphRoom;
  const ViewportRoom& viewportRoom;
  const ParameterRoom& parameterRoom;
  const TimelineRoom& timelineRoom;
  const LabRoom& labRoom;
  const LightsRoom& lightsRoom;
  const StatusRoom& statusRoom;
  const StartRoom& startRoom;

  bool quit = false, quitAfterExport = false;
};

/// A different document was put in place: forgets what belonged to the old one.
void documentReplaced(Editor& editor);

}  // namespace pileus::editor
