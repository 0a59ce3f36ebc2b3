// The light mixer: layers by group add up to the picture, a mix is what a fresh render would be, and applying
// it writes that into the lights.
#include "editor/picture/light_mixer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/picture_layers.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/graph_animation.h"
#include "renderer/view/light_mix.h"
#include "tests/support/gpu.h"

namespace pileus::editor {
namespace {

/// A cloud and a glowing ball under two suns of one group, a lamp of none, and a sky seen behind them.
nodes::Graph scene(const std::string& scattering) {
  const std::string text = R"({ "pileus": 3, "settings": { "size": [96, 54] }, "nodes": {
    "Ball": { "type": "volume.sphere", "at": [0, 0], "params": { "radius": 0.8 } },
    "Medium": { "type": "volume.medium", "at": [0, 0], "params": { "extinction": 6, "albedo": [0.95, 0.8, 0.6] } },
    "Hot": { "type": "volume.sphere", "at": [0, 0], "params": { "center": [1.5, 0, 0], "radius": 0.2, "density": 1500 } },
    "Glow": { "type": "volume.blackbody", "at": [0, 0], "params": {} },
    "All": { "type": "volume.merge", "at": [0, 0], "params": {} },
    "Key": { "type": "light.sun", "at": [0, 0], "params": { "group": "Suns", "angle": 2, "disc_samples": 2 } },
    "Fill": { "type": "light.sun", "at": [0, 0], "params": { "azimuth": -120, "group": "Suns", "color": [0.3, 0.5, 1] } },
    "Lamp": { "type": "light.point", "at": [0, 0], "params": { "position": [-1.5, 1, 1] } },
    "Sky": { "type": "light.sky", "at": [0, 0], "params": { "exposure": -1 } },
    "Camera": { "type": "camera.perspective", "at": [0, 0], "params": { "eye": [0, 0.4, 5], "target": [0, 0, 0] } },
    "Render": { "type": "render.volume", "at": [0, 0], "params": { "samples": 2, "grid_cells": 16, "scattering": ")" +
                           scattering + R"(" } },
    "View": { "type": "output.view", "at": [0, 0], "params": {} },
    "File": { "type": "output.exr", "at": [0, 0], "params": { "light_groups": true } } },
  "links": [ "Ball.volume -> Medium.volume", "Medium.volume -> All.volumes", "Hot.volume -> Glow.volume",
    "Glow.volume -> All.volumes", "All.volume -> Render.volumes", "Key.light -> Render.lights",
    "Fill.light -> Render.lights", "Lamp.light -> Render.lights", "Sky.light -> Render.lights",
    "Camera.camera -> Render.camera", "Render.image -> View.image", "Render.image -> File.image" ] })";
  nodes::Loaded loaded = nodes::parseGraph(text).value();
  for (const nodes::Fault& f : loaded.faults) ADD_FAILURE() << nodes::faultText(f);
  return loaded.graph;
}

struct Window {
  Session session;
  Shown shown{test::renderer()};
  Messages messages;

  explicit Window(nodes::Graph graph) { session.document = nodes::Document(std::move(graph)); }

  void settle() {
    for (int i = 0; i < 100000; ++i) {
      PreviewRequest request;
      request.graph = session.document.root();
      request.revision = session.document.revision();
      request.view = "View";
      request.size = {96, 54};
      applyLights(shown, request);
      shown.preview.step(request);
      stepMixer(session, shown);
      if (i > 0 && shown.preview.settled()) return;
      if (shown.preview.waiting()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    FAIL() << shown.preview.error();
  }
  image::Image picture() { return view::readBack(*shown.preview.picture()).value(); }
};

/// The largest difference, as a part of the mean and of what is there.
double difference(const image::Image& a, const image::Image& b) {
  const std::vector<float>&p = a.layers[0].pixels, &q = b.layers[0].pixels;
  double mean = 0, worst = 0;
  for (const float v : q) mean += double(v) / double(q.size());
  for (std::size_t i = 0; i < q.size(); ++i)
    worst = std::max(worst, std::abs(double(p[i]) - double(q[i])) / (mean + double(q[i])));
  return worst;
}

class Mixer : public testing::TestWithParam<const char*> {};

TEST_P(Mixer, AMixIsWhatAFreshRenderWouldBe) {
  Window window(scene(GetParam()));
  window.settle();
  const image::Image before = window.picture();
  window.shown.mixer.on = true;
  window.settle();
  const LightMixer& mixer = window.shown.mixer;
  ASSERT_EQ(mixer.error, "");
  ASSERT_EQ(mixer.layers.size(), 3u);
  EXPECT_EQ(mixer.layers[0].channel, "Suns");
  EXPECT_EQ(mixer.layers[1].channel, "Lamp");
  EXPECT_EQ(mixer.layers[2].channel, "Sky");
  ASSERT_TRUE(mixer.rest);

  // All of them as they are: the picture.
  std::vector<view::MixPart> parts{{mixer.rest, vec3(1.0f)}};
  for (const LightMixer::Layer& layer : mixer.layers) parts.push_back({layer.picture, vec3(1.0f)});
  const auto sum = view::mixLights(window.shown.renderer.shaders(), *window.shown.preview.rendered(), parts);
  ASSERT_TRUE(sum) << sum.error().message;
  image::Image whole = view::readBack(**sum).value();
  const double sumError = difference(whole, before);
  std::printf("  %s: the sum differs by %.1e\n", GetParam(), sumError);
  EXPECT_LT(sumError, 1e-4);

  // Exposure and colour, heard without a render.
  window.shown.mixer.channels["Suns"] = {.exposure = 1.5, .color = {1, 0.6, 0.4}};
  window.shown.mixer.channels["Sky"] = {.exposure = -2};
  const auto rendered = window.shown.preview.rendered();
  const std::uint64_t answered = window.shown.preview.answered();
  window.settle();
  EXPECT_EQ(window.shown.preview.rendered(), rendered);
  EXPECT_EQ(window.shown.preview.answered(), answered) << "nothing was rendered";
  EXPECT_NE(window.shown.preview.picture(), rendered);
  const image::Image mixed = window.picture();

  // Written into the lights: one step, and the render is the mix.
  applyMix(window.session, window.shown, window.messages);
  EXPECT_TRUE(window.shown.mixer.neutral());
  window.shown.mixer.on = false;
  window.settle();
  const double error = difference(mixed, window.picture());
  std::printf("  %s: the mix differs from a render by %.1e\n", GetParam(), error);
  EXPECT_LT(error, 1e-3);
  window.session.document.undo();
  EXPECT_FALSE(window.session.document.canUndo());

  // One alone, and none.
  window.shown.mixer.on = true;
  window.shown.mixer.channels["Lamp"].solo = true;
  window.settle();
  EXPECT_EQ(window.shown.mixer.gain("Suns"), vec3(0.0f));
  EXPECT_EQ(window.shown.mixer.gain("Lamp"), vec3(1.0f));
  EXPECT_GT(difference(window.picture(), before), 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, Mixer, testing::Values("grid", "single"));

TEST(LightMixer, LayersOfAFileAreGroups) {
  const nodes::Graph graph = scene("single");
  nodes::Evaluator evaluator(&test::renderer());
  nodes::EvalSettings settings;
  settings.size = {48, 27};
  settings.extra = nodes::wantedLayers(graph, "File");
  EXPECT_TRUE(settings.extra.lights && settings.extra.backdrops);
  while (!evaluator.evaluate(graph, {"File"}, settings).complete)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto* image = std::get_if<nodes::ImageValue>(evaluator.input("File", "image"));
  ASSERT_TRUE(image);
  image::Image picture = view::readBack(*image->picture).value();
  nodes::nameLightLayers(picture, evaluator, graph, "File");
  std::vector<std::string> names;
  for (const image::Layer& layer : picture.layers) names.push_back(layer.name);
  EXPECT_EQ(names, (std::vector<std::string>{"", "Suns", "Lamp", "Sky", "emission"}));
  image::Image sum = picture;
  std::vector<float>& all = sum.layers[0].pixels;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 4 == 3) continue;
    all[i] = 0;
    for (std::size_t k = 1; k < picture.layers.size(); ++k) all[i] += picture.layers[k].pixels[i];
  }
  EXPECT_LT(difference(sum, picture), 1e-4);
}

TEST(LightMixer, SwitchesRenderWithoutALight) {
  Window window(scene("single"));
  window.settle();
  const image::Image before = window.picture();
  const nodes::Graph graph = window.session.document.root();
  for (const char* path : {"Key", "Fill", "Lamp", "Sky"}) toggle(window.shown.lights.muted, path);
  window.settle();
  EXPECT_TRUE(window.session.document.root() == graph) << "the document stays";
  const image::Image dark = window.picture();
  double most = 0, bright = 0;
  for (std::size_t i = 0; i < dark.layers[0].pixels.size(); i += 4) {
    bright = std::max(bright, double(before.layers[0].pixels[i + 2]));
    most = std::max(most, double(dark.layers[0].pixels[i + 2]));
  }
  EXPECT_LT(most, 0.5 * bright) << "what glows is left";
  window.shown.lights = {};
  window.settle();
  EXPECT_EQ(difference(window.picture(), before), 0);
}

}  // namespace
}  // namespace pileus::editor
