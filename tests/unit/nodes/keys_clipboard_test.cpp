// Keys of animated parameters as text, and back at another frame or on another node.
#include <gtest/gtest.h>

#include "nodes/file/serialize.h"

namespace pileus::nodes {
namespace {

/// Two boxes; the density of the first has keys at 1, 5 and 9.5, its size at 5.
Graph animated() {
  Graph graph = *addNode(*addNode({}, "volume.box", {}, "A"), "volume.box", {}, "B");
  graph = *setKey(graph, "A", "density", 1, 1.0, Interpolation::Linear);
  graph = *setKey(graph, "A", "density", 5, 2.0, Interpolation::Constant);
  graph = *setKey(graph, "A", "density", 9.5, 3.0);
  return *setKey(graph, "A", "size", 5, dvec3(1, 2, 3));
}

TEST(KeysClipboard, KeepsDistancesValuesAndInterpolation) {
  const Graph graph = animated();
  const std::string text = copyKeysText(graph, {{"A", "density", 1}, {"A", "density", 5}, {"A", "size", 5}});
  std::set<KeyAt> pasted;
  const auto result = pasteKeysText(graph, text, 21, {}, &pasted);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(pasted, (std::set<KeyAt>{{"A", "density", 21}, {"A", "density", 25}, {"A", "size", 25}}));
  EXPECT_EQ(*findKey(*result, {"A", "density", 21}), (AnimationKey{21, 1.0, Interpolation::Linear}));
  EXPECT_EQ(*findKey(*result, {"A", "density", 25}), (AnimationKey{25, 2.0, Interpolation::Constant}));
  EXPECT_EQ(*findKey(*result, {"A", "size", 25}), (AnimationKey{25, dvec3(1, 2, 3)}));
  EXPECT_EQ(findNode(*result, "A")->animated.at("density").keys.size(), 5u) << "the others stay";
}

TEST(KeysClipboard, ReplacesKeysThatAreThere) {
  const Graph graph = animated();
  const auto result = pasteKeysText(graph, copyKeysText(graph, {{"A", "density", 9.5}}), 5);
  ASSERT_TRUE(result);
  EXPECT_EQ(*findKey(*result, {"A", "density", 5}), (AnimationKey{5, 3.0}));
  EXPECT_EQ(findNode(*result, "A")->animated.at("density").keys.size(), 3u);
}

TEST(KeysClipboard, GoesToAnotherNodeWhereThatHasTheParameter) {
  Graph graph = *addNode(animated(), "light.sun", {}, "Sun");
  const std::string text = copyKeysText(graph, {{"A", "density", 1}, {"A", "density", 5}});
  const auto onB = pasteKeysText(graph, text, 1, "B");
  ASSERT_TRUE(onB);
  EXPECT_EQ(findNode(*onB, "B")->animated.at("density").keys.size(), 2u);
  const auto onSun = pasteKeysText(graph, text, 1, "Sun");
  ASSERT_FALSE(onSun);
  EXPECT_NE(onSun.error().message.find("density"), std::string::npos) << onSun.error().message;
  EXPECT_FALSE(pasteKeysText(removeNodes(graph, {"A"}), text, 1)) << "their node is gone";
}

TEST(KeysClipboard, RefusesOtherText) {
  const Graph graph = animated();
  for (const std::string& text :
       {std::string(), std::string("12"), std::string("{}"), copyText(graph, {"A"})})
    EXPECT_FALSE(pasteKeysText(graph, text, 1)) << text;
  std::string damaged = copyKeysText(graph, {{"A", "density", 1}});
  damaged.replace(damaged.find("\"linear\""), 8, "\"bouncy\"");
  const auto result = pasteKeysText(graph, damaged, 1);
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("A.density"), std::string::npos) << result.error().message;
  const auto asNodes = pasteText(graph, copyKeysText(graph, {{"A", "density", 1}}), {0, 0});
  ASSERT_FALSE(asNodes);
  EXPECT_NE(asNodes.error().message.find("timeline"), std::string::npos) << asNodes.error().message;
}

}  // namespace
}  // namespace pileus::nodes
