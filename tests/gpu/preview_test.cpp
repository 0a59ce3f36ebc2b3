// What the viewport shows while a picture is made: what is old never stands beside what is new, and what one
// waits for goes first.
#include "editor/picture/preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "editor/exchange/messages.h"
#include "editor/picture/compare_mode.h"
#include "editor/picture/shown.h"
#include "nodes/file/serialize.h"
#include "renderer/view/picture.h"
#include "tests/support/gpu.h"

namespace pileus::editor {
namespace {

/// A bright wall; `more` stands before it.
nodes::Graph wall(int samples, const std::string& more, const std::string& links) {
  const std::string text = fmt::format(R"({{ "pileus": 2, "nodes": {{
    "Wall": {{ "type": "solid.box", "params": {{ "center": [0, 0, -3], "size": [40, 40, 1] }} }},
    "Sun": {{ "type": "light.sun", "params": {{ "azimuth": 0, "elevation": 20 }} }},
    "Camera": {{ "type": "camera.perspective" }}, {}
    "Render": {{ "type": "render.volume", "params": {{ "samples": {}, "step_scale": 0.05 }} }},
    "View": {{ "type": "output.view" }} }},
    "links": [ {} "Wall.solid -> Render.solids", "Sun.light -> Render.lights",
      "Camera.camera -> Render.camera", "Render.image -> View.image" ] }})",
                                       more, samples, links);
  return nodes::parseGraph(text).value().graph;
}

struct Levels {
  float least = 0, most = 0;
};

Levels levels(const view::Picture& picture) {
  const image::Image pixels = view::readBack(picture).value();
  Levels out{1e30f, 0};
  const std::vector<float>& p = pixels.layers[0].pixels;
  for (std::size_t i = 0; i + 3 < p.size(); i += 4)
    out.least = std::min(out.least, p[i]), out.most = std::max(out.most, p[i]);
  return out;
}

TEST(Preview, WhatIsOldIsNeverMixedWithWhatIsNew) {
  Preview preview(&test::renderer());
  PreviewRequest request;
  request.view = "View";
  request.size = {384, 216};
  const auto settle = [&] {
    for (int i = 0; i < 4000 && (i == 0 || !preview.settled()); ++i) preview.step(request);
    ASSERT_TRUE(preview.settled());
    ASSERT_EQ(preview.error(), "");
  };
  // A picture that takes no time at all: no drafts are made of it any more.
  for (int samples : {1, 2, 1, 2, 1}) {
    request.graph = wall(samples, "", "");
    ++request.revision;
    settle();
  }
  const auto old = preview.picture();
  const Levels bright = levels(*old);
  ASSERT_GT(bright.least, 0.1f);

  // Then one that takes long, and is black all over.
  request.graph = wall(64,
                       R"("Soot": { "type": "volume.box", "params": { "size": [30, 30, 2] } },
    "Black": { "type": "volume.medium", "params": { "extinction": 8, "albedo": [0, 0, 0] } },)",
                       R"("Soot.volume -> Black.volume", "Black.volume -> Render.volumes",)");
  ++request.revision;
  int seen = 0;
  for (int i = 0; i < 60 && (i == 0 || !preview.settled()); ++i) {
    preview.step(request);
    const Levels now = levels(*preview.picture());
    if (preview.picture() == old) continue;
    ++seen;
    ASSERT_LT(now.most, 0.01f * bright.least) << "a part of the old picture, step " << i;
    EXPECT_TRUE(preview.draft() || preview.refining() || preview.settled());
  }
  EXPECT_GT(seen, 10);
}

// Not even where there was nothing before: what is not drawn yet would look like a place without light.
TEST(Preview, ADraftIsShownOnceItIsWhole) {
  Preview preview(&test::renderer());
  PreviewRequest request;
  request.view = "View";
  request.size = {1280, 720};
  request.graph = nodes::parseGraph(R"({ "pileus": 2, "nodes": {
    "Wall": { "type": "solid.box", "params": { "center": [0, 0, -3], "size": [40, 40, 1] } },
    "Fog": { "type": "volume.box", "params": { "size": [30, 30, 4], "density": 0.01 } },
    "Sky": { "type": "light.sky" }, "Camera": { "type": "camera.perspective" },
    "Render": { "type": "render.volume", "params": { "samples": 4, "step_scale": 0.05, "scattering": "single" } },
    "View": { "type": "output.view" } },
    "links": [ "Wall.solid -> Render.solids", "Fog.volume -> Render.volumes", "Sky.light -> Render.lights",
      "Camera.camera -> Render.camera", "Render.image -> View.image" ] })")
                      .value()
                      .graph;
  int drafts = 0, before = 0;
  for (int i = 0; i < 4000 && (i == 0 || !preview.refining()); ++i) {
    preview.step(request);
    if (preview.waiting()) std::this_thread::sleep_for(std::chrono::milliseconds(5));  // for the sky
    before += !preview.picture();
    if (!preview.picture() || !preview.draft()) continue;
    ++drafts;
    ASSERT_GE(preview.picture()->samples, 1) << "step " << i;
    ASSERT_GT(levels(*preview.picture()).least, 0) << "the wall fills the picture";
  }
  EXPECT_EQ(preview.error(), "");
  EXPECT_GT(before, 1) << "it took more than one step";
  EXPECT_GT(drafts, 0);
}

// One waits for the draft of the truth: the refinement rests for it, and for nothing else.
TEST(Preview, RestsUntilADraftOfTheTruthIsThere) {
  const auto box = [](double density) {
    return nodes::parseGraph(fmt::format(R"({{ "pileus": 2, "nodes": {{
      "Box": {{ "type": "volume.box", "params": {{ "density": {} }} }}, "Sun": {{ "type": "light.sun" }},
      "Map": {{ "type": "shadow.extinction", "params": {{ "resolution": 64 }} }},
      "Camera": {{ "type": "camera.perspective" }},
      "Render": {{ "type": "render.volume", "params": {{ "samples": 4096 }} }}, "View": {{ "type": "output.view" }} }},
      "links": [ "Box.volume -> Map.volumes", "Sun.light -> Map.light", "Box.volume -> Render.volumes",
        "Map.light -> Render.lights", "Camera.camera -> Render.camera", "Render.image -> View.image" ] }})",
                                         density))
        .value()
        .graph;
  };
  Messages messages;
  Shown shown(test::renderer());
  Preview& preview = shown.preview;
  PreviewRequest request;
  request.view = "View";
  request.size = {384, 216};
  request.graph = box(2);
  for (int i = 0; i < 4000 && (preview.draft() || !preview.refining() || !preview.picture()); ++i)
    preview.step(request);
  ASSERT_TRUE(preview.refining() && !preview.draft()) << preview.error();

  toggleCompare(messages, shown);
  followPicture(shown);
  EXPECT_TRUE(compareGoesFirst(shown));
  preview.hold(true);
  const double fraction = preview.picture()->fraction;
  for (int i = 0; i < 5; ++i) preview.step(request);
  EXPECT_EQ(preview.picture()->fraction, fraction);
  // Then the small comparison runs beside the refinement.
  for (int i = 0; i < 400 && !shown.compare.shownTruth(); ++i) stepCompare(messages, shown, 20);
  ASSERT_TRUE(shown.compare.shownTruth()) << shown.compare.error;
  EXPECT_FALSE(compareGoesFirst(shown));
  EXPECT_TRUE(compareWantsFrame(shown));

  // What changes is drawn although the final picture rests.
  const std::uint64_t answered = preview.answered();
  request.graph = box(3);
  ++request.revision;
  for (int i = 0; i < 400 && preview.answered() == answered; ++i) preview.step(request);
  EXPECT_GT(preview.answered(), answered);
  EXPECT_TRUE(preview.draft());
  preview.hold(false);
  for (int i = 0; i < 400 && (preview.draft() || preview.picture()->fraction == 0); ++i)
    preview.step(request);
  EXPECT_GT(preview.picture()->fraction, 0);
}

}  // namespace
}  // namespace pileus::editor
