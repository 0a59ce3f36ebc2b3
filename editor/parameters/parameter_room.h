#pragma once
// The parts that the parameter panel shows and changes.
namespace pileus::editor {

struct Clock;
struct Parameters;
struct Session;
struct Settings;
struct Shown;
struct Ui;

struct ParameterRoom {
  Ui& ui;
  Session& session;
  Clock& clock;
  Shown& shown;
  Settings& settings;
  Parameters& parameters;
};

}  // namespace pileus::editor
