#pragma once
// Four steps around the window: a frame around the place, and two sentences about it.

namespace pileus::editor {

struct Settings;
struct Ui;

struct Tour {
  int step = -1;  ///< 0 to 3; below 0: not on
  bool on() const { return step >= 0; }
};

void startTour(Tour& tour);
/// Once a frame, after everything else.
void drawTour(Ui& ui, Settings& settings, Tour& tour);

}  // namespace pileus::editor
