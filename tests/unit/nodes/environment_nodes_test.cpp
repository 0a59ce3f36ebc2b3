// Light from everywhere as nodes give it: one light each, whose shadow is what its suns are to have; and the
// colours of its file.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "renderer/scene/environment_strata.h"
#include "renderer/shadow/shadow_map.h"
#include "tests/support/support.h"

namespace pileus::nodes {
namespace {

namespace fs = std::filesystem;

/// 0.5 everywhere.
fs::path grey() {
  image::Image image;
  image.size = {64, 32};
  image.layers = {{"", 3, std::vector<float>(64 * 32 * 3, 0.5f)}};
  const fs::path path = test::scratchFolder() / "grey.exr";
  EXPECT_TRUE(image::writeExr(path, image, {image::PixelType::Float, image::Compression::Zip}));
  return path;
}

/// Until the jobs are through.
std::vector<LightWithShadow> lights(Evaluator& evaluator, const Graph& graph, const std::string& node,
                                    const char* socket = "light",
                                    const fs::path& folder = test::scratchFolder()) {
  EvalSettings settings;
  settings.folder = folder;
  for (int i = 0; i < 2000; ++i) {
    const EvalReport report = evaluator.evaluate(graph, {node}, settings);
    if (report.complete) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(evaluator.status(node).error.message, "");
  const SocketValue* value = evaluator.output(node, socket);
  return value ? std::get<LightValue>(*value).items : std::vector<LightWithShadow>();
}

Graph graphOf(const std::string& nodes, const std::string& links = "", const std::string& more = "") {
  const auto loaded =
      parseGraph(R"({"pileus": 1, "nodes": {)" + nodes + R"(}, "links": [)" + links + "]" + more + "}");
  EXPECT_TRUE(loaded && loaded->faults.empty());
  return loaded->graph;
}

TEST(EnvironmentNodes, GiveOneLight) {
  Evaluator evaluator{nullptr};
  const Graph graph = graphOf(R"("E": {"type": "light.environment", "params": {"file": ")" + grey().string() +
                                  R"(", "rotation": 20, "exposure": 1}},
                                 "B": {"type": "volume.box"}, "M": {"type": "shadow.ray_march"})",
                              R"("E.light -> M.light", "B.volume -> M.volumes")");
  const auto bare = lights(evaluator, graph, "E");
  ASSERT_EQ(bare.size(), 1u);
  EXPECT_EQ(bare[0].light.kind, scene::LightKind::Environment);
  ASSERT_TRUE(bare[0].light.environment);
  EXPECT_EQ(bare[0].light.environment->rotation, 20);
  EXPECT_EQ(bare[0].light.environment->scale, vec3(2));
  ASSERT_TRUE(bare[0].light.environment->strata);
  EXPECT_EQ(bare[0].light.environment->strata->strata().size(), 16u);
  const auto shadowed = lights(evaluator, graph, "M");
  ASSERT_EQ(shadowed.size(), 1u);
  EXPECT_EQ(shadowed[0].light, bare[0].light);
  ASSERT_TRUE(shadowed[0].shadow);
  EXPECT_EQ(shadowed[0].shadow->volumes.size(), 1u);
}

TEST(EnvironmentNodes, SkiesGiveTheSunAsWell) {
  Evaluator evaluator{nullptr};
  const Graph graph = graphOf(R"("S": {"type": "light.sky", "params": {"elevation": 2, "altitude": 100}})");
  const auto both = lights(evaluator, graph, "S");
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].light.kind, scene::LightKind::Sun);
  ASSERT_TRUE(both[0].light.air);
  EXPECT_EQ(both[0].light.air->altitude, 100);
  EXPECT_EQ(both[1].light.kind, scene::LightKind::Environment);
  EXPECT_EQ(lights(evaluator, graph, "S", "sun").size(), 1u);
  EXPECT_EQ(lights(evaluator, graph, "S", "sky").size(), 1u);
  // Once it has set for the whole of the air there is no sun.
  const Graph night = graphOf(R"("S": {"type": "light.sky", "params": {"elevation": -15}})");
  EXPECT_EQ(lights(evaluator, night, "S").size(), 1u);
}

// A file's colour space is one of the document's configuration, which may lie beside it.
TEST(EnvironmentNodes, ColourSpacesAreTheDocuments) {
  const fs::path config = test::scratchFolder() / "twice.ocio";
  const auto write = [&](double factor) {
    ASSERT_TRUE(writeFileAtomic(config, fmt::format(R"(ocio_profile_version: 2
roles:
  default: ACEScg
  scene_linear: ACEScg
displays:
  sRGB:
    - !<View> {{name: Raw, colorspace: ACEScg}}
colorspaces:
  - !<ColorSpace>
    name: ACEScg
  - !<ColorSpace>
    name: Scaled
    to_scene_reference: !<MatrixTransform> {{matrix: [{0}, 0, 0, 0, 0, {0}, 0, 0, 0, 0, {0}, 0, 0, 0, 0, 1]}}
)",
                                                    factor)));
  };
  write(2);
  const std::string node =
      R"("E": {"type": "light.environment", "params": {"file": ")" + grey().string() + "\"";
  const std::string settings = R"(, "settings": {"ocio": "twice.ocio"})";
  const Graph graph = graphOf(node + R"(, "colorspace": "Scaled"}})", "", settings);
  Evaluator evaluator{nullptr};
  const auto first = lights(evaluator, graph, "E", "light", config.parent_path());
  ASSERT_EQ(first.size(), 1u);
  EXPECT_NEAR(first[0].light.environment->map->at(5, 5).g, 1.0f, 1e-5f);
  write(8);  // another size of file: another stamp, whatever the clock says
  write(16.5);
  const auto second = lights(evaluator, graph, "E", "light", config.parent_path());
  ASSERT_EQ(second.size(), 1u);
  EXPECT_NEAR(second[0].light.environment->map->at(5, 5).g, 8.25f, 1e-4f);
  // Without a name nothing is looked up in it.
  const Graph plain = graphOf(node + "}}", "", settings);
  const auto third = lights(evaluator, plain, "E", "light", config.parent_path());
  ASSERT_EQ(third.size(), 1u);
  EXPECT_NEAR(third[0].light.environment->map->at(5, 5).g, 0.5f, 1e-4f);
}

}  // namespace
}  // namespace pileus::nodes
