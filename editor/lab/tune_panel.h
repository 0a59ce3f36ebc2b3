#pragma once
// Searches the cheapest shadow parameters that keep a bound, shows what was tried as a curve, and writes a
// choice into the nodes.
#include <memory>
#include <optional>
#include <string>

#include "nodes/shadows/shadow_groups.h"
#include "renderer/truth/tune.h"

namespace pileus::editor {

struct Lab;
struct Session;
struct Shown;
struct Ui;

struct TunePanel {
  truth::TuneGoal goal;
  std::array<double, 3> limits{0.02, 5, 16};  ///< by bound: |dT|, ms, MiB
  std::size_t group = 0;                      ///< of the shadows that are tuned together
  std::unique_ptr<truth::Tuner> run;
  bool running = false;
  double fraction = 0;
  std::string error;
  std::shared_ptr<const view::RenderScene> scene;  ///< what was measured
  nodes::ShadowGroup tuned;                        ///< whose nodes a choice is written into
  std::optional<shadow::ShadowSpec> chosen;        ///< a dot that was clicked; none: the best
};

void startTune(const Session& session, const Shown& shown, Lab& lab);
void stopTune(Lab& lab);
void stepTune(Ui& ui, const Shown& shown, Lab& lab, double ms);
void drawTune(Ui& ui, Session& session, const Shown& shown, Lab& lab, vec2 lo, vec2 hi);

}  // namespace pileus::editor
