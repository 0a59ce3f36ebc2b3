#pragma once
// The parts that the parameter panel shows and changes.
namespace pileus::editor {

class GraphPictures;
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
  GraphPictures& pictures;
};

}  // namespace pileus::editor
