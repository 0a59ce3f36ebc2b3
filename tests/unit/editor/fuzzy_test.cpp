#include "editor/graph_view/search/fuzzy.h"

#include <gtest/gtest.h>

#include "editor/graph_view/search/node_search.h"

namespace pileus::editor {
namespace {

TEST(Fuzzy, FindsLettersInOrder) {
  EXPECT_TRUE(fuzzyScore("blr", "Blur"));
  EXPECT_TRUE(fuzzyScore("BLUR", "Blur"));
  EXPECT_TRUE(fuzzyScore("em", "Extinction Map"));
  EXPECT_FALSE(fuzzyScore("rlb", "Blur"));
  EXPECT_FALSE(fuzzyScore("blurr", "Blur"));
  EXPECT_FALSE(fuzzyScore("a", ""));
  EXPECT_EQ(fuzzyScore("", "anything"), 0);
}

TEST(Fuzzy, PrefersBeginningsRunsAndShortNames) {
  EXPECT_GT(*fuzzyScore("su", "Sun"), *fuzzyScore("su", "Result"));
  EXPECT_GT(*fuzzyScore("ext", "Extinction Map"), *fuzzyScore("ext", "Text Export"));
  EXPECT_GT(*fuzzyScore("em", "Extinction Map"), *fuzzyScore("em", "Element"));
  EXPECT_GT(*fuzzyScore("box", "Box"), *fuzzyScore("box", "Box of many things"));
}

std::vector<std::string> labels(const std::vector<SearchItem>& items, std::string_view query,
                                const std::vector<std::string>& recent) {
  std::vector<std::string> out;
  for (const int i : rankItems(items, query, recent)) out.push_back(items[static_cast<std::size_t>(i)].label);
  return out;
}

TEST(NodeSearch, ListsEveryTypeAndRanksByName) {
  const std::vector<SearchItem> items = searchItems({});
  ASSERT_EQ(items.size(), nodes::allNodeTypes().size());
  EXPECT_EQ(labels(items, "", {}).size(), items.size());
  ASSERT_FALSE(labels(items, "sun", {}).empty());
  EXPECT_EQ(labels(items, "sun", {}).front(), nodes::findNodeType("light.sun")->label);
  EXPECT_EQ(labels(items, "extmap", {}).front(), nodes::findNodeType("shadow.extinction")->label);
  EXPECT_TRUE(labels(items, "zzqx", {}).empty());
}

TEST(NodeSearch, RecentTypesComeFirstWhenNothingIsTyped) {
  const std::vector<SearchItem> items = searchItems({});
  const std::vector<std::string> first = labels(items, "", {"output.view", "light.sun"});
  EXPECT_EQ(first[0], nodes::findNodeType("output.view")->label);
  EXPECT_EQ(first[1], nodes::findNodeType("light.sun")->label);
}

TEST(NodeSearch, AFilterLeavesOnlyWhatFits) {
  for (const bool fromOutput : {true, false})
    for (const nodes::SocketType type :
         {nodes::SocketType::Light, nodes::SocketType::Image, nodes::SocketType::Volume}) {
      const std::vector<SearchItem> items = searchItems(LinkFilter{fromOutput, type});
      EXPECT_FALSE(items.empty());
      std::size_t expected = 0;
      for (const nodes::NodeType& t : nodes::allNodeTypes())
        for (const nodes::SocketSpec& s : fromOutput ? t.inputs : t.outputs)
          expected += s.type == type ? 1u : 0u;
      EXPECT_EQ(items.size(), expected) << "no parameter takes these types";
      for (const SearchItem& item : items) {
        const int index =
            fromOutput ? item.type->inputIndex(item.socket) : item.type->outputIndex(item.socket);
        ASSERT_GE(index, 0) << item.label;
        const auto& sockets = fromOutput ? item.type->inputs : item.type->outputs;
        EXPECT_EQ(sockets[static_cast<std::size_t>(index)].type, type) << item.label;
      }
    }
}

}  // namespace
}  // namespace pileus::editor
