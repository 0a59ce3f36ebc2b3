#pragma once
// The parts that the timeline shows and changes.
namespace pileus::editor {

struct Clock;
struct Session;
struct Settings;
struct Shown;
struct Timeline;
struct Ui;

struct TimelineRoom {
  Ui& ui;
  Session& session;
  Clock& clock;
  Shown& shown;
  Settings& settings;
  Timeline& timeline;
};

}  // namespace pileus::editor
