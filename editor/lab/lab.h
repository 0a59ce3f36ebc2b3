#pragma once
// The measuring dock below the graph: shoot-out and tuner as two tabs. Both work on the picture's scene as it
// was when they were started, a slice of time per frame.
#include <imgui.h>

#include "editor/lab/shootout_panel.h"
#include "editor/lab/tune_panel.h"
#include "renderer/base/enum_info.h"

namespace pileus::editor {

struct LabRoom;
struct Settings;
struct Shown;
struct Ui;

enum class LabTab { Shootout, Tune };
constexpr auto enumInfo(LabTab*) {
  using T = LabTab;
  return std::array{EnumItem<T>{T::Shootout, "shootout", "Shoot-out",
                                "Every shadow representation on this picture's lights"},
                    EnumItem<T>{T::Tune, "tune", "Tune", "The cheapest shadow parameters that keep a bound"}};
}

struct Lab {
  LabTab tab = LabTab::Shootout;
  ShootoutPanel shootout;
  TunePanel tune;
};

/// Is something being measured that can go on now?
bool labWantsFrame(const Shown& shown, const Lab& lab);
void stepLab(Ui& ui, const Shown& shown, Lab& lab, double ms);
void drawLab(const LabRoom& room, ImVec2 min, ImVec2 max);

/// Opens the dock at that tab, or closes it there.
void toggleShootout(Settings& settings, Lab& lab);
void toggleTune(Settings& settings, Lab& lab);

}  // namespace pileus::editor
