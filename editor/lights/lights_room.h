#pragma once
// The parts that the light list and the mixer show and change.
namespace pileus::editor {

struct Clock;
struct LightsPanel;
struct Session;
struct Settings;
struct Shown;
struct Ui;

struct LightsRoom {
  Ui& ui;
  Session& session;
  Clock& clock;
  Shown& shown;
  Settings& settings;
  LightsPanel& panel;
};

}  // namespace pileus::editor
