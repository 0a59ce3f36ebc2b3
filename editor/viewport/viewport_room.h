#pragma once
// The parts that the viewport shows and changes.
namespace pileus::editor {

struct Clock;
struct Session;
struct Settings;
struct Shown;
struct Ui;
struct Viewport;

struct ViewportRoom {
  Ui& ui;
  Session& session;
  Clock& clock;
  Shown& shown;
  Settings& settings;
  Viewport& viewport;
};

}  // namespace pileus::editor
