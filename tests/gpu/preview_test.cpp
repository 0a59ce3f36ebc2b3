// What the viewport shows while a picture is made: what is old never stands beside what is new.
#include "editor/picture/preview.h"

#include <gtest/gtest.h>

#include <algorithm>

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

struct Shown {
  float least = 0, most = 0;
};

Shown levels(const view::Picture& picture) {
  const image::Image pixels = view::readBack(picture).value();
  Shown out{1e30f, 0};
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
  const Shown bright = levels(*old);
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
    const Shown now = levels(*preview.picture());
    if (preview.picture() == old) continue;
    ++seen;
    ASSERT_LT(now.most, 0.01f * bright.least) << "a part of the old picture, step " << i;
    EXPECT_TRUE(preview.draft() || preview.refining() || preview.settled());
  }
  EXPECT_GT(seen, 10);
}

}  // namespace
}  // namespace pileus::editor
