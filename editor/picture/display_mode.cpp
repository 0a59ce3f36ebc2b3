#include "editor/picture/display_mode.h"

#include <fmt/core.h>

#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"
#include "renderer/view/render_scene.h"

namespace pileus::editor {
namespace {

using Kind = view::PictureLayer::Kind;

const char* lightName(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::Sun:
      return "sun";
    case scene::LightKind::Point:
      return "point";
    case scene::LightKind::Spot:
      return "spot";
    case scene::LightKind::Environment:
      return "environment";
  }
  return "";
}

}  // namespace

std::vector<LayerChoice> layerChoices(const Shown& shown) {
  using C = view::Channel;
  std::vector<LayerChoice> out{
      {"Beauty", "All light that reaches the camera.", {}, C::Color},
      {"Alpha", "How much of what is behind is covered.", {}, C::Alpha},
      {"Depth",
       "Metres along the viewing axis to the mean point that scatters; near is white.",
       {Kind::Depth, 0},
       C::Color},
      {"Transmittance", "What passes through the media: 1 - alpha.", {}, C::Transmittance}};
  const auto& picture = shown.preview.picture();
  if (!picture || !picture->scene) return out;
  const auto& lights = picture->scene->lights;
  for (std::size_t i = 0; i < lights.size() && i < 64; ++i)
    out.push_back({fmt::format("Light {}, {}", i + 1, lightName(lights[i].light.kind)),
                   "The part of one light alone, in the order of the links.",
                   {Kind::Light, static_cast<int>(i)},
                   C::Color});
  if (view::emits(*picture->scene))
    out.push_back({"Emission", "What glows alone, without any light.", {Kind::Emission, 0}, C::Color});
  if (picture->scene->bounces || picture->scene->options.scatter.kind != view::Scattering::Single) {
    out.push_back({"Single scattering", "Light that was scattered once.", {Kind::Single, 0}, C::Color});
    out.push_back({"Multiple scattering",
                   "What the beauty has beside light that was scattered once.",
                   {Kind::Multiple, 0},
                   C::Color});
  }
  return out;
}

std::size_t shownLayer(const Shown& shown, const std::vector<LayerChoice>& choices) {
  const DisplayMode& mode = shown.mode;
  const bool noLight = mode.channel == view::Channel::Alpha || mode.channel == view::Channel::Transmittance;
  std::size_t found = 0;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i].layer == mode.layer && (!noLight || choices[i].channel == mode.channel)) {
      found = i;
      break;
    }
  return found;
}

void showLayer(Messages& messages, Shown& shown, const LayerChoice& choice) {
  DisplayMode& mode = shown.mode;
  if (mode.layer != choice.layer) mode.scan.forget();
  mode.layer = choice.layer;
  const bool noLight = mode.channel == view::Channel::Alpha || mode.channel == view::Channel::Transmittance;
  if (choice.channel != view::Channel::Color || noLight) mode.channel = choice.channel;
  messages.note(choice.label + ": " + choice.help);
}

view::PictureRegion wantedRegion(const Shown& shown) {
  const RegionMode& region = shown.mode.region;
  return region.on ? region.region : view::PictureRegion{};
}

void stepLayer(Messages& messages, Shown& shown, int by) {
  const auto choices = layerChoices(shown);
  const auto count = static_cast<int>(choices.size());
  const int next = (static_cast<int>(shownLayer(shown, choices)) + by + count) % count;
  showLayer(messages, shown, choices[static_cast<std::size_t>(next)]);
}

void toggleChannel(Shown& shown, view::Channel channel) {
  view::Channel& chosen = shown.mode.channel;
  chosen = chosen == channel ? view::Channel::Color : channel;
}

void toggleRaw(Messages& messages, Shown& shown) {
  bool& raw = shown.mode.raw;
  raw = !raw;
  messages.note(raw ? "Raw: scene values as they are, no view transform" : "View transform on");
}

void toggleFalseColor(Shown& shown) { shown.mode.falseColor = !shown.mode.falseColor; }

void toggleZebra(Shown& shown) { shown.mode.zebra = !shown.mode.zebra; }

void drawRegion(Messages& messages, Shown& shown) {
  RegionMode& region = shown.mode.region;
  region.drawing = !region.drawing;
  region.from.reset();
  if (region.drawing) messages.note("Drag a rectangle in the picture; Esc leaves it");
}

void toggleRegion(Messages& messages, Shown& shown) {
  RegionMode& region = shown.mode.region;
  if (region.region.whole()) return drawRegion(messages, shown);
  region.on = !region.on;
}

}  // namespace pileus::editor
