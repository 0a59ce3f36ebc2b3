// Stills of fire: from a file with no density at all, and layers that add up in the file.
#include <algorithm>
#include <cmath>
#include <fstream>

#include "renderer/image/exr.h"
#include "renderer/volume/vdb_child.h"
#include "renderer/volume/vdb_fit.h"
#include "tests/support/support.h"

// These tests read volumes themselves, too.
namespace pileus {
namespace {

namespace fs = std::filesystem;

fs::path write(const fs::path& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name, std::ios::binary) << text;
  return folder / name;
}

TEST(Fire, AStillOfFireAloneIsBrightAndFinite) {
  PILEUS_NEEDS_DATA();
  const fs::path folder = test::scratchFolder(),
                 file = *test::dataFolder() / "vdb" / "embergen_fire" / "embergen_fire_a_20.vdb";
  JobControl control;
  const auto fit = volume::fitVdb(file, control);
  ASSERT_TRUE(fit && fit->fire);
  const volume::FireRange& range = fit->fire->range;
  const std::string graph = fmt::format(
      R"({{ "pileus": 1, "settings": {{ "size": [96, 54] }}, "nodes": {{
    "File": {{ "type": "volume.vdb_file", "at": [0, 0], "params": {{ "file": "{}", "grid": "{}" }} }},
    "Fire": {{ "type": "volume.blackbody", "at": [0, 0],
              "params": {{ "input_max": {}, "coolest": {}, "hottest": {}, "strength": {} }} }},
    "Render": {{ "type": "render.volume", "at": [0, 0], "params": {{ "samples": 2 }} }},
    "View": {{ "type": "output.view", "at": [0, 0], "params": {{}} }} }},
  "links": [ "File.volume -> Fire.volume", "Fire.volume -> Render.volumes",
             "Render.image -> View.image" ] }})",
      file.string(), fit->fire->grid, range.highest, range.body.coolest, range.body.hottest,
      range.body.strength);
  const auto r = test::pileus({"render", write(folder, "fire.json", graph), "-o", folder / "fire.exr"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const auto picture = image::readExr(folder / "fire.exr");
  ASSERT_TRUE(picture) << picture.error().message;
  float most = 0;
  int bright = 0, white = 0;
  const std::vector<float>& p = picture->layers[0].pixels;
  for (std::size_t i = 0; i < p.size(); i += 4) {
    for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(p[i + std::size_t(c)]));
    EXPECT_GE(p[i], p[i + 1]) << "redder than white";
    EXPECT_GE(p[i + 1], p[i + 2]);
    most = std::max(most, p[i]);
    bright += p[i] > 0.5f, white += p[i + 1] > 16;
  }
  EXPECT_GT(most, 2);
  EXPECT_GT(bright, 96 * 54 / 50) << "a good part of the picture";
  EXPECT_LT(white, 96 * 54 / 50) << "and little of it blown out";
}

TEST(Fire, LayersOfAFileAddUp) {
  const fs::path folder = test::scratchFolder();
  const char* graph = R"({ "pileus": 1, "settings": { "size": [48, 27] }, "nodes": {
    "Smoke": { "type": "volume.box", "at": [0, 0], "params": { "density": 2 } },
    "Hot": { "type": "volume.sphere", "at": [0, 0], "params": { "center": [0.2, 0.1, 0.1], "radius": 0.6 } },
    "Fire": { "type": "volume.blackbody", "at": [0, 0], "params": { "strength": 2 } },
    "Sun": { "type": "light.sun", "at": [0, 0], "params": {} },
    "Map": { "type": "shadow.extinction", "at": [0, 0], "params": { "resolution": 64 } },
    "Render": { "type": "render.volume", "at": [0, 0], "params": { "samples": 2 } },
    "Out": { "type": "output.exr", "at": [0, 0],
             "params": { "type": "float", "lights": true, "depth": true } } },
  "links": [ "Hot.volume -> Fire.volume", "Smoke.volume -> Render.volumes", "Fire.volume -> Render.volumes",
             "Smoke.volume -> Map.volumes", "Fire.volume -> Map.volumes", "Sun.light -> Map.light",
             "Map.light -> Render.lights", "Render.image -> Out.image" ] })";
  const auto r = test::pileus({"render", write(folder, "a.json", graph), "-o", folder / "a.exr"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const auto picture = image::readExr(folder / "a.exr");
  ASSERT_TRUE(picture) << picture.error().message;
  const auto layer = [&](const std::string& name) -> const image::Layer* {
    for (const image::Layer& l : picture->layers)
      if (l.name == name) return &l;
    return nullptr;
  };
  const image::Layer *beauty = layer(""), *light = layer("Sun"), *glow = layer("emission");
  std::string names;
  for (const image::Layer& l : picture->layers) names += "[" + l.name + "]";
  ASSERT_TRUE(beauty && light && glow && layer("depth.Z")) << names;
  EXPECT_EQ(layer("light1"), nullptr);
  const auto channels = std::size_t(light->channels);
  float lit = 0, bright = 0;
  for (std::size_t i = 0; i < std::size_t(48 * 27); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const float a = light->pixels[i * channels + c], b = glow->pixels[i * std::size_t(glow->channels) + c];
      ASSERT_NEAR(beauty->pixels[i * std::size_t(beauty->channels) + c], a + b, 1e-5f + 1e-4f * (a + b));
      lit = std::max(lit, a), bright = std::max(bright, b);
    }
  EXPECT_GT(lit, 0.05f);
  EXPECT_GT(bright, 0.3f);
}

TEST(LightLayers, AreOneForEachLightNodeByItsName) {
  // A soft sun through a metric, within a group; a lamp through two shadows; two names that look alike.
  const fs::path folder = test::scratchFolder();
  const char* graph = R"({ "pileus": 2, "settings": { "size": [32, 18] }, "nodes": {
    "Smoke": { "type": "volume.box", "at": [0, 0] },
    "Sky": { "type": "group", "at": [0, 0], "graph": { "nodes": {
        "Soft Sun": { "type": "light.sun", "at": [0, 0], "params": { "angle": 4, "disc_samples": 3 } },
        "light": { "type": "group.output", "at": [0, 0] } },
      "links": ["Soft Sun.light -> light.in"] } },
    "Lamp": { "type": "light.point", "at": [0, 0], "params": { "position": [2, 1, 2] } },
    "Lamp?": { "type": "light.point", "at": [0, 0], "params": { "position": [-2, 1, 2] } },
    "Dot": { "type": "dot", "at": [0, 0] },
    "Metric": { "type": "shadow.pseudometric", "at": [0, 0], "params": { "resolution": 64 } },
    "Map": { "type": "shadow.extinction", "at": [0, 0] },
    "March": { "type": "shadow.ray_march", "at": [0, 0] },
    "Render": { "type": "render.volume", "at": [0, 0], "params": { "samples": 1 } },
    "Out": { "type": "output.exr", "at": [0, 0], "params": { "type": "float", "lights": true } } },
  "links": [ "Smoke.volume -> Metric.volumes", "Sky.light -> Metric.light", "Metric.metric -> Map.metric",
             "Smoke.volume -> March.volumes", "Lamp.light -> March.light",
             "Smoke.volume -> Render.volumes", "Lamp?.light -> Dot.in", "Map.light -> Render.lights",
             "Dot.out -> Render.lights", "March.light -> Render.lights", "Lamp.light -> Render.lights",
             "Render.image -> Out.image" ] })";
  const auto r = test::pileus({"render", write(folder, "a.json", graph), "-o", folder / "a.exr"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const auto picture = image::readExr(folder / "a.exr");
  ASSERT_TRUE(picture) << picture.error().message;
  std::string names;
  for (const image::Layer& l : picture->layers) names += "[" + l.name + "]";
  ASSERT_EQ(picture->layers.size(), 4u) << names;
  const image::Layer &beauty = picture->layers[0], *sun = picture->layer("Sky_Soft_Sun"),
                     *left = picture->layer("Lamp"), *right = picture->layer("Lamp_2");
  ASSERT_TRUE(sun && left && right) << names;
  float lit = 0;
  for (std::size_t i = 0; i < beauty.pixels.size(); ++i) {
    if (i % 4 == 3) {
      EXPECT_EQ(sun->pixels[i], beauty.pixels[i]);
      continue;
    }
    const float sum = sun->pixels[i] + left->pixels[i] + right->pixels[i];
    ASSERT_NEAR(beauty.pixels[i], sum, 1e-5f + 1e-4f * sum);
    lit = std::max(lit, std::min({sun->pixels[i], left->pixels[i], right->pixels[i]}));
  }
  EXPECT_GT(lit, 0.001f);
}

}  // namespace
}  // namespace pileus
