#pragma once
// The parts that the graph view shows and changes.
namespace pileus::editor {

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
};

}  // namespace pileus::editor
