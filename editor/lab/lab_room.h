#pragma once
// The parts that the measuring panels show and change.
namespace pileus::editor {

struct Clock;
struct Lab;
struct Session;
struct Settings;
struct Shown;
struct Ui;

struct LabRoom {
  Ui& ui;
  Session& session;
  Clock& clock;
  Shown& shown;
  Settings& settings;
  Lab& lab;
};

}  // namespace pileus::editor
