#pragma once
// The parts that the graph view shows and changes.
namespace pileus::editor {

class PresetShelf;
struct Canvas;
struct Clock;
struct Session;
struct Settings;
struct Shown;
struct Ui;

struct GraphRoom {
  Ui& ui;
  Session& session;
  Clock& clock;
  Shown& shown;
  Settings& settings;
  Canvas& canvas;
  PresetShelf& presets;
};

}  // namespace pileus::editor
