#pragma once
// How the viewport shows its picture, apart from what the view node says: layer, channel, raw, false colours,
// clip marks and region. Never part of the document.
#include <optional>
#include <string>
#include <vector>

#include "renderer/view/display.h"
#include "renderer/view/picture_layer.h"
#include "renderer/view/picture_scan.h"

namespace pileus::editor {

class Messages;
struct Shown;

/// Part of the picture that is rendered alone.
struct RegionMode {
  view::PictureRegion region;  ///< drawn last
  bool on = false;
  bool drawing = false;       ///< the next drag in the picture draws one
  std::optional<dvec2> from;  ///< where that drag began, 0..1
};

struct DisplayMode {
  bool raw = false, falseColor = false, zebra = false;
  view::Channel channel = view::Channel::Color;
  view::PictureLayer layer;
  view::PictureScan scan;  ///< of the picture: for the histogram and the range of depths
  RegionMode region;
};

/// One entry of the layer selector: a layer that is rendered, or a channel that is no light.
struct LayerChoice {
  std::string label, help;
  view::PictureLayer layer;
  view::Channel channel = view::Channel::Color;
};
/// Beauty, alpha, depth, transmittance and each light of the picture.
std::vector<LayerChoice> layerChoices(const Shown& shown);
/// Which of them is shown.
std::size_t shownLayer(const Shown& shown, const std::vector<LayerChoice>& choices);
void showLayer(Messages& messages, Shown& shown, const LayerChoice& choice);
/// What is asked of the preview.
view::PictureRegion wantedRegion(const Shown& shown);

// Actions.
void stepLayer(Messages& messages, Shown& shown, int by);
/// Alone, or all of them again.
void toggleChannel(Shown& shown, view::Channel channel);
void toggleRaw(Messages& messages, Shown& shown);
void toggleFalseColor(Shown& shown);
void toggleZebra(Shown& shown);
void drawRegion(Messages& messages, Shown& shown);
void toggleRegion(Messages& messages, Shown& shown);

}  // namespace pileus::editor
