// The light and solid nodes: what their parameters mean.
#include <gtest/gtest.h>

#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/file/serialize.h"

namespace pileus::nodes {
namespace {

struct Evaluated {
  Evaluator evaluator{nullptr};
  Evaluated(const std::string& nodes, const std::set<std::string>& wanted) {
    const auto loaded = parseGraph(R"({"pileus": 1, "nodes": {)" + nodes + "}}");
    EXPECT_TRUE(loaded && loaded->faults.empty());
    evaluator.evaluate(loaded->graph, {wanted.begin(), wanted.end()}, {});
  }
  scene::SolidList solids(const std::string& node) const {
    return std::get<SolidValue>(*evaluator.output(node, "solid")).items;
  }
  std::vector<LightWithShadow> lights(const std::string& node) const {
    return std::get<LightValue>(*evaluator.output(node, "light")).items;
  }
};

TEST(LightNodes, ASunWithAnAngleIsAsManySunsAsAskedFor) {
  const Evaluated e(R"("Hard": {"type": "light.sun"}, "Soft": {"type": "light.sun", "params": {"angle": 5}},
                       "Softer": {"type": "light.sun", "params": {"angle": 5, "disc_samples": 32, "irradiance": 16}})",
                    {"Hard", "Soft", "Softer"});
  EXPECT_EQ(e.lights("Hard").size(), 1u);
  EXPECT_EQ(e.lights("Soft").size(), 8u);
  const auto parts = e.lights("Softer");
  ASSERT_EQ(parts.size(), 32u);
  for (const auto& part : parts) {
    EXPECT_EQ(part.light.emitted, vec3(0.5f));
    EXPECT_EQ(part.shadow, nullptr);
    EXPECT_GE(glm::dot(part.light.towards, scene::sunDirection(30, 40)), std::cos(glm::radians(2.5)));
  }
}

TEST(LightNodes, PointAndSpotMeanWhatTheyDeclare) {
  const Evaluated e(
      R"("Lamp": {"type": "light.point", "params": {"position": [1, 2, 3], "intensity": 8, "color": [1, 0.5, 0.25], "radius": 0.5}},
                       "Spot": {"type": "light.spot", "params": {"position": [0, 0, 4], "target": [3, 0, 0], "cone": 30, "softness": 0.1}},
                       "Bad": {"type": "light.spot", "params": {"position": [1, 1, 1], "target": [1, 1, 1]}})",
      {"Lamp", "Spot", "Bad"});
  const scene::Light lamp = e.lights("Lamp").at(0).light, spot = e.lights("Spot").at(0).light;
  EXPECT_EQ(lamp.kind, scene::LightKind::Point);
  EXPECT_EQ(lamp.position, dvec3(1, 2, 3));
  EXPECT_EQ(lamp.emitted, vec3(8, 4, 2));
  EXPECT_EQ(lamp.radius, 0.5);
  EXPECT_EQ(spot.kind, scene::LightKind::Spot);
  EXPECT_EQ(spot.position, dvec3(0, 0, 4));
  EXPECT_NEAR(glm::length(spot.towards - dvec3(-0.6, 0, 0.8)), 0, 1e-12);
  EXPECT_EQ(spot.cone, 30);
  EXPECT_EQ(spot.softness, 0.1);
  EXPECT_EQ(spot.emitted, vec3(100));
  EXPECT_EQ(e.evaluator.status("Bad").error.message, "Bad.target: is where the light is; move one of them");
}

TEST(SolidNodes, PlaneAndBoxArePlacedAsDeclared) {
  const Evaluated e(
      R"("Ground": {"type": "solid.plane", "params": {"center": [0, -1, 0], "size": [4, 7, 6], "rotate": [0, 30, 0], "albedo": [0.1, 0.2, 0.3]}},
                       "Block": {"type": "solid.box", "params": {"center": [1, 2, 3], "size": [2, 3, 4]}})",
      {"Ground", "Block"});
  const scene::Solid ground = e.solids("Ground").at(0), block = e.solids("Block").at(0);
  EXPECT_EQ(ground.shape, scene::SolidShape::Plane);
  EXPECT_EQ(ground.worldFromLocal, composeTransform({0, -1, 0}, {0, 30, 0}, {4, 1, 6}));  // y is not used
  EXPECT_EQ(ground.albedo, vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(block.shape, scene::SolidShape::Box);
  EXPECT_EQ(block.worldFromLocal, composeTransform({1, 2, 3}, {0, 0, 0}, {2, 3, 4}));
  EXPECT_EQ(block.albedo, vec3(0.5f));
}

}  // namespace
}  // namespace pileus::nodes
