#include "editor/graph_view/layout/arrange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pileus::editor {
namespace {

struct Case {
  std::vector<Box> boxes;
  std::vector<BoxLink> links;
};

/// Random places, links only from lower to higher numbers.
Case randomCase(unsigned seed, int nodes, int links) {
  std::mt19937 random(seed);
  const auto number = [&](int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); };
  Case c;
  for (int i = 0; i < nodes; ++i)
    c.boxes.push_back({dvec2(number(-900, 900), number(-900, 900)), dvec2(188, number(60, 260))});
  for (int i = 0; i < links; ++i) {
    const int a = number(0, nodes - 2), b = number(a + 1, nodes - 1);
    c.links.push_back({a, b, static_cast<double>(number(20, 50)), static_cast<double>(number(20, 55))});
  }
  return c;
}

Case moved(Case c) {
  const std::vector<dvec2> at = arranged(c.boxes, c.links);
  for (std::size_t i = 0; i < at.size(); ++i) c.boxes[i].at = at[i];
  return c;
}

bool overlap(const Box& a, const Box& b) {
  return a.at.x < b.at.x + b.size.x && b.at.x < a.at.x + a.size.x && a.at.y < b.at.y + b.size.y &&
         b.at.y < a.at.y + a.size.y;
}

dvec2 middle(const std::vector<Box>& boxes) {
  dvec2 lo = boxes[0].at, hi = lo;
  for (const Box& b : boxes) lo = glm::min(lo, b.at), hi = glm::max(hi, b.at + b.size);
  return 0.5 * (lo + hi);
}

TEST(Arrange, NodesNeverOverlapAndLinksRunToTheRight) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Case c = moved(randomCase(seed, 4 + static_cast<int>(seed), static_cast<int>(2 * seed)));
    for (std::size_t i = 0; i < c.boxes.size(); ++i)
      for (std::size_t j = i + 1; j < c.boxes.size(); ++j)
        EXPECT_FALSE(overlap(c.boxes[i], c.boxes[j])) << seed << ": " << i << ", " << j;
    for (const BoxLink& l : c.links)
      EXPECT_LE(c.boxes[static_cast<std::size_t>(l.from)].at.x + 188 + kLayerGap,
                c.boxes[static_cast<std::size_t>(l.to)].at.x)
          << seed;
  }
}

TEST(Arrange, TwiceIsOnce) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Case once = moved(randomCase(seed, 14, 18));
    EXPECT_EQ(moved(once).boxes, once.boxes) << seed;
  }
}

TEST(Arrange, TheMiddleStays) {
  const Case before = randomCase(7, 20, 26);
  const dvec2 by = middle(moved(before).boxes) - middle(before.boxes);
  EXPECT_LE(std::abs(by.x), 1);
  EXPECT_LE(std::abs(by.y), 1);
}

TEST(Arrange, TreesAndLaddersHaveNoCrossings) {
  // A binary tree whose leaves lie in the worst order.
  Case tree;
  for (int i = 0; i < 15; ++i)
    tree.boxes.push_back({dvec2((i * 37) % 11 * 50, (i * 53) % 17 * 60), dvec2(188, 90)});
  for (int i = 1; i < 15; ++i) tree.links.push_back({i, (i - 1) / 2, 40, i % 2 == 1 ? 40.0 : 64.0});
  EXPECT_EQ(crossingsOf(moved(tree).boxes, tree.links), 0);
  // Three chains side by side that meet at the end.
  Case chains;
  for (int i = 0; i < 13; ++i) chains.boxes.push_back({dvec2(0, (i * 7) % 13 * 100), dvec2(188, 100)});
  for (int chain = 0; chain < 3; ++chain)
    for (int i = 0; i < 4; ++i)
      chains.links.push_back(
          {chain * 4 + i, i == 3 ? 12 : chain * 4 + i + 1, 40, i == 3 ? 40.0 + 24 * chain : 40.0});
  EXPECT_EQ(crossingsOf(moved(chains).boxes, chains.links), 0);
}

TEST(Arrange, FewCrossingsInADenseGraph) {
  const Case before = randomCase(3, 24, 34);
  EXPECT_LT(crossingsOf(moved(before).boxes, before.links), crossingsOf(before.boxes, before.links) / 2);
}

TEST(Arrange, AChainIsStraight) {
  Case c;
  for (int i = 0; i < 5; ++i) c.boxes.push_back({dvec2(i * 10, i * 200), dvec2(188, 100)});
  for (int i = 0; i < 4; ++i) c.links.push_back({i, i + 1, 40, 40});
  const Case after = moved(c);
  for (const Box& b : after.boxes) EXPECT_EQ(b.at.y, after.boxes[0].at.y);
}

TEST(Arrange, ASourceStandsNextToWhatItFeeds) {
  // 0 -> 1 -> 2, and 3 -> 2: 3 stands in the layer of 1, not of 0.
  Case c;
  for (int i = 0; i < 4; ++i) c.boxes.push_back({dvec2(i * 300, 0), dvec2(188, 100)});
  c.links = {{0, 1, 40, 40}, {1, 2, 40, 40}, {3, 2, 40, 64}};
  const Case after = moved(c);
  EXPECT_EQ(after.boxes[3].at.x, after.boxes[1].at.x);
  EXPECT_GT(after.boxes[3].at.y, after.boxes[1].at.y);
}

TEST(Arrange, CyclesAndEmptyGraphsEnd) {
  Case c;
  for (int i = 0; i < 3; ++i) c.boxes.push_back({dvec2(i * 20, 0), dvec2(188, 100)});
  c.links = {{0, 1, 40, 40}, {1, 2, 40, 40}, {2, 0, 40, 40}, {1, 1, 40, 40}};
  const Case after = moved(c);
  EXPECT_FALSE(overlap(after.boxes[0], after.boxes[1]));
  EXPECT_TRUE(arranged({}, {}).empty());
}

TEST(Align, SidesAndMiddles) {
  const std::vector<Box> boxes = {
      {dvec2(0, 10), dvec2(100, 50)}, {dvec2(40, 100), dvec2(60, 90)}, {dvec2(300, 40), dvec2(80, 20)}};
  EXPECT_EQ(aligned(boxes, Align::Left)[2], dvec2(0, 40));
  EXPECT_EQ(aligned(boxes, Align::Right)[1], dvec2(320, 100));
  EXPECT_EQ(aligned(boxes, Align::Top)[1], dvec2(40, 10));
  EXPECT_EQ(aligned(boxes, Align::Bottom)[0], dvec2(0, 140));
  EXPECT_EQ(aligned(boxes, Align::CenterX)[0], dvec2(140, 10));
  EXPECT_EQ(aligned(boxes, Align::CenterY)[2], dvec2(300, 90));
}

TEST(Align, DistributingMakesGapsEqualAndKeepsTheEnds) {
  const std::vector<Box> boxes = {
      {dvec2(0, 0), dvec2(100, 50)}, {dvec2(110, 5), dvec2(60, 50)}, {dvec2(400, 9), dvec2(100, 50)}};
  const std::vector<dvec2> at = distributed(boxes, true);
  EXPECT_EQ(at[0], boxes[0].at);
  EXPECT_EQ(at[2], boxes[2].at);
  EXPECT_EQ(at[1], dvec2(220, 5));  // 120 on both sides
  EXPECT_EQ(distributed({boxes[0], boxes[1]}, true)[1], boxes[1].at);
}

}  // namespace
}  // namespace pileus::editor
