#include "editor/viewport/display_mode.h"

#include <fmt/core.h>

#include "editor/app/editor.h"
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
  }
  return "";
}

}  // namespace

std::vector<LayerChoice> layerChoices(const Editor& editor) {
  using C = view::Channel;
  std::vector<LayerChoice> out{
      {"Beauty", "All light that reaches the camera.", {}, C::Color},
      {"Alpha", "How much of what is behind is covered.", {}, C::Alpha},
      {"Depth",
       "Metres along the viewing axis to the mean point that scatters; near is white.",
       {Kind::Depth, 0},
       C::Color},
      {"Transmittance", "What passes through the media: 1 - alpha.", {}, C::Transmittance}};
  const auto& picture = editor.preview.picture();
  if (!picture || !picture->scene) return out;
  const auto& lights = picture->scene->lights;
  for (std::size_t i = 0; i < lights.size() && i < 64; ++i)
    out.push_back({fmt::format("Light {}, {}", i + 1, lightName(lights[i].light.kind)),
                   "The part of one light alone, in the order of the links.",
                   {Kind::Light, static_cast<int>(i)},
                   C::Color});
  if (view::emits(*picture->scene))
    out.push_back({"Emission", "What glows alone, without any light.", {Kind::Emission, 0}, C::Color});
  return out;
}

std::size_t shownLayer(const Editor& editor, const std::vector<LayerChoice>& choices) {
  const DisplayMode& mode = editor.viewport.mode;
  const bool noLight = mode.channel == view::Channel::Alpha || mode.channel == view::Channel::Transmittance;
  std::size_t found = 0;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i].layer == mode.layer && (!noLight || choices[i].channel == mode.channel)) {
      found = i;
      break;
    }
  return found;
}

void showLayer(Editor& editor, const LayerChoice& choice) {
  DisplayMode& mode = editor.viewport.mode;
  if (mode.layer != choice.layer) mode.scan.forget();
  mode.layer = choice.layer;
  const bool noLight = mode.channel == view::Channel::Alpha || mode.channel == view::Channel::Transmittance;
  if (choice.channel != view::Channel::Color || noLight) mode.channel = choice.channel;
  editor.messages.note(choice.label + ": " + choice.help);
}

view::PictureRegion wantedRegion(const Editor& editor) {
  const RegionMode& region = editor.viewport.mode.region;
  return region.on ? region.region : view::PictureRegion{};
}

void stepLayer(Editor& editor, int by) {
  const auto choices = layerChoices(editor);
  const auto count = static_cast<int>(choices.size());
  const int next = (static_cast<int>(shownLayer(editor, choices)) + by + count) % count;
  showLayer(editor, choices[static_cast<std::size_t>(next)]);
}

void toggleChannel(Editor& editor, view::Channel channel) {
  view::Channel& shown = editor.viewport.mode.channel;
  shown = shown == channel ? view::Channel::Color : channel;
}

void toggleRaw(Editor& editor) {
  bool& raw = editor.viewport.mode.raw;
  raw = !raw;
  editor.messages.note(raw ? "Raw: scene values as they are, no view transform" : "View transform on");
}

void toggleFalseColor(Editor& editor) { editor.viewport.mode.falseColor = !editor.viewport.mode.falseColor; }

void toggleZebra(Editor& editor) { editor.viewport.mode.zebra = !editor.viewport.mode.zebra; }

void drawRegion(Editor& editor) {
  RegionMode& region = editor.viewport.mode.region;
  region.drawing = !region.drawing;
  region.from.reset();
  if (region.drawing) editor.messages.note("Drag a rectangle in the picture; Esc leaves it");
}

void toggleRegion(Editor& editor) {
  RegionMode& region = editor.viewport.mode.region;
  if (region.region.whole()) return drawRegion(editor);
  region.on = !region.on;
}

}  // namespace pileus::editor
