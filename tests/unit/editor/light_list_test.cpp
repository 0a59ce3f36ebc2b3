// Lights of a graph by groups, and a mix written into them.
#include <gtest/gtest.h>

#include "editor/picture/light_mixer.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

nodes::Graph lights() {
  nodes::Graph g = *nodes::addNode({}, "light.sun", {0, 0}, "Key");
  g = *nodes::addNode(g, "light.point", {0, 0}, "Lamp");
  g = *nodes::addNode(g, "light.sky", {0, 0}, "Sky");
  g = *nodes::addNode(g, "light.environment", {0, 0}, "Dome");
  g = *nodes::addNode(g, "light.spot", {0, 0}, "Spot");
  g = *nodes::setParam(g, "Key", "group", std::string("Warm"));
  g = *nodes::setParam(g, "Lamp", "group", std::string("Warm"));
  return *nodes::groupNodes(g, {"Spot"});
}

double number(const nodes::Graph& g, const std::string& path, const char* id, double frame = 1) {
  const nodes::Node* node = nodes::findNodeAt(g, path);
  return std::get<double>(nodes::paramValue(*node, *nodes::findNodeType(node->type)->param(id), frame));
}
dvec3 color(const nodes::Graph& g, const std::string& path, const char* id) {
  const nodes::Node* node = nodes::findNodeAt(g, path);
  return std::get<dvec3>(nodes::paramValue(*node, *nodes::findNodeType(node->type)->param(id)));
}

TEST(LightList, AllLightsByTheirPaths) {
  const nodes::Graph g = lights();
  std::vector<std::string> paths, channels;
  for (const LightAt& light : lightsOf(g)) paths.push_back(light.path), channels.push_back(light.channel);
  EXPECT_EQ(paths, (std::vector<std::string>{"Dome", "Group/Spot", "Key", "Lamp", "Sky"}));
  EXPECT_EQ(channels, (std::vector<std::string>{"Dome", "Group/Spot", "Warm", "Warm", "Sky"}));
  EXPECT_TRUE(lightsOf({}).empty());
}

TEST(LightList, AMixIsWrittenIntoStrengthAndColour) {
  nodes::Graph g = *nodes::setKey(lights(), "Lamp", "intensity", 1, 10.0);
  g = *nodes::setKey(g, "Lamp", "intensity", 9, 30.0);
  std::vector<std::string> left;
  const auto mixed = withMix(g,
                             {{"Warm", {.exposure = 1, .color = {1, 0.5, 0.25}}},
                              {"Group/Spot", {.exposure = -1}},
                              {"Dome", {.exposure = 2, .color = {0.5, 0.5, 0.5}}},
                              {"Sky", {.exposure = 3, .color = {1, 2, 3}}},
                              {"Gone", {.exposure = 3}}},
                             left);
  ASSERT_TRUE(mixed) << mixed.error().message;
  EXPECT_EQ(number(*mixed, "Key", "irradiance"), 20);
  EXPECT_EQ(color(*mixed, "Key", "color"), dvec3(1, 0.5, 0.25));
  EXPECT_EQ(number(*mixed, "Lamp", "intensity", 1), 20);
  EXPECT_EQ(number(*mixed, "Lamp", "intensity", 9), 60);
  EXPECT_EQ(number(*mixed, "Group/Spot", "intensity"), 50);
  EXPECT_EQ(number(*mixed, "Dome", "exposure"), 2);
  EXPECT_EQ(color(*mixed, "Dome", "tint"), dvec3(0.5));
  EXPECT_EQ(number(*mixed, "Sky", "exposure"), 3);
  EXPECT_EQ(left, (std::vector<std::string>{"Sky (no colour)"}));
}

TEST(LightList, WhatIsLinkedIsLeftAndSaid) {
  nodes::Graph g = *nodes::addNode(lights(), "value.number", {0, 0}, "N");
  const auto linked =
      nodes::connect(g, {"N", nodes::findNodeType("value.number")->outputs[0].id, "Key", "irradiance"});
  ASSERT_TRUE(linked) << linked.error().message;
  std::vector<std::string> left;
  const auto mixed = withMix(*linked, {{"Warm", {.exposure = 1}}}, left);
  ASSERT_TRUE(mixed);
  EXPECT_EQ(left, (std::vector<std::string>{"Key.irradiance"}));
  EXPECT_EQ(number(*mixed, "Lamp", "intensity"), 200);
  // Out of range: all or nothing.
  EXPECT_FALSE(withMix(g, {{"Sky", {.exposure = 41}}}, left));
}

TEST(LightList, MuteAndSolo) {
  LightMixer mixer;
  EXPECT_TRUE(mixer.neutral());
  mixer.channels["A"] = {.exposure = 1};
  EXPECT_EQ(mixer.gain("A"), vec3(2.0f));
  EXPECT_EQ(mixer.gain("B"), vec3(1.0f));
  mixer.channels["B"].solo = true;
  EXPECT_EQ(mixer.gain("A"), vec3(0.0f));
  EXPECT_EQ(mixer.gain("C"), vec3(0.0f));
  mixer.channels["B"].muted = true;
  EXPECT_EQ(mixer.gain("B"), vec3(0.0f));
  LightSwitches switches;
  toggle(switches.muted, "A");
  EXPECT_TRUE(switches.off("A"));
  EXPECT_FALSE(switches.off("B"));
  toggle(switches.solo, "B");
  EXPECT_TRUE(switches.off("C"));
  toggle(switches.muted, "A");
  toggle(switches.solo, "B");
  EXPECT_FALSE(switches.any());
}

}  // namespace
}  // namespace pileus::editor
