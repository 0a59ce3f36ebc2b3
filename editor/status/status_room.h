#pragma once
// The parts that the status line shows and changes.
namespace pileus::editor {

class Exporter;
struct Clock;
struct LogPanel;
struct Session;
struct Shown;
struct Ui;

struct StatusRoom {
  Ui& ui;
  Session& session;
  Clock& clock;
  Shown& shown;
  Exporter& exporter;
  LogPanel& logPanel;
};

}  // namespace pileus::editor
