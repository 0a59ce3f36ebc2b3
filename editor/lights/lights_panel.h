#pragma once
// The panel of all lights: a row for each with its strength, group, mute and solo; and the mixer, a row for
// each group, whose exposure and colour change the picture at once.
#include <cstdint>
#include <string>
#include <vector>

#include "editor/picture/display_color.h"
#include "editor/picture/light_mixer.h"

struct ImVec2;

namespace pileus::editor {

struct LightsRoom;
struct Ui;

struct LightsPanel {
  std::vector<LightAt> lights;                                 ///< of the document as it is
  std::uint64_t generation = 0, revision = ~std::uint64_t(0);  ///< it was then
  std::string typing, text;  ///< the light whose group is typed, and what is typed
  DisplayColors colors;      ///< of the swatches
};

void drawLights(const LightsRoom& room, ImVec2 min, ImVec2 max);

/// A small button that is lit while it is on; true if pressed.
bool litButton(Ui& ui, const char* letter, bool on, unsigned ink, const std::string& trace, const char* help);

// Rows, between the columns of a table.
void drawLightRows(const LightsRoom& room);
void drawMixerRows(const LightsRoom& room);

}  // namespace pileus::editor
