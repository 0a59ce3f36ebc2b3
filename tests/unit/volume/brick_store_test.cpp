// The store: what is written comes back, and no damage crashes the reader or slips through.
#include "renderer/volume/brick_store.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <random>

#include "renderer/base/file.h"
#include "renderer/volume/brick_builder.h"
#include "tests/support/support.h"

namespace fs = std::filesystem;

namespace pileus::volume {
namespace {

GridPtr sampleGrid() {
  VoxelSource s;
  s.name = "store";
  s.worldFromIndex = composeTransform({1, 2, 3}, {10, 20, 30}, {0.5, -0.25, 2});
  s.activeMin = ivec3(-20, 3, 7);
  s.activeMax = ivec3(30, 40, 30);
  s.fill = [](ivec3 lo, float* out) {
    for (int i = 0; i < kStoredVoxels; ++i)
      out[i] = static_cast<float>((i * 7919 + lo.x * 31 + lo.y * 17 + lo.z) % 1000) * 0.01f;
    return Fill::Voxels;
  };
  JobControl control;
  return buildBricks(s, control)->grid;
}

TEST(BrickStore, RoundTripKeepsEverything) {
  const GridPtr g = sampleGrid();
  const fs::path path = test::scratchFolder() / "a.bricks";
  ASSERT_TRUE(writeStore(path, *g, {"first", "second"}));
  auto back = readStore(path);
  ASSERT_TRUE(back) << back.error().message;
  const BrickGrid& h = *back->grid;
  EXPECT_EQ(h.content, g->content);
  EXPECT_EQ(contentKeyOf(h), g->content);
  EXPECT_EQ(h.name, g->name);
  EXPECT_EQ(h.worldFromIndex, g->worldFromIndex);
  EXPECT_EQ(h.origin, g->origin);
  EXPECT_EQ(h.indexBounds.max, g->indexBounds.max);
  EXPECT_EQ(h.levels.size(), g->levels.size());
  EXPECT_EQ(h.payloadCount, g->payloadCount);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(h.payload.get()) % 4096, 0u);
  EXPECT_EQ(back->notes, (std::vector<std::string>{"first", "second"}));
  for (int i = 0; i < 1000; ++i) {
    const ivec3 p(i % 60 - 25, i * 7 % 50, i * 13 % 40);
    ASSERT_EQ(voxelAt(h, p), voxelAt(*g, p));
  }
}

TEST(BrickStore, EmptyGridRoundTrip) {
  const fs::path path = test::scratchFolder() / "e.bricks";
  ASSERT_TRUE(writeStore(path, *emptyGrid("nothing"), {"why"}));
  auto back = readStore(path);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->grid->empty());
  EXPECT_EQ(back->notes.size(), 1u);
}

TEST(BrickStore, MissingAndForeignFilesAreErrors) {
  const fs::path folder = test::scratchFolder();
  EXPECT_EQ(readStore(folder / "none").error().code, Code::Input);
  EXPECT_EQ(readStore(folder).error().code, Code::Input);
  ASSERT_TRUE(writeFileAtomic(folder / "text", std::string(5000, 'x')));
  auto r = readStore(folder / "text");
  ASSERT_FALSE(r);
  EXPECT_NE(r.error().message.find("not a brick store"), std::string::npos);
}

/// Without fsync: hundreds of small files.
void writePlain(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST(BrickStore, DamageIsNoticed) {
  const fs::path folder = test::scratchFolder();
  ASSERT_TRUE(writeStore(folder / "a", *sampleGrid(), {"note"}));
  const std::string whole = *readFile(folder / "a");
  std::mt19937_64 random(11);
  int padding = 0;
  for (int i = 0; i < 100; ++i) {
    std::string cut = whole.substr(0, i < 60 ? random() % 5000 : random() % whole.size());
    writePlain(folder / "b", cut);
    EXPECT_FALSE(readStore(folder / "b")) << "cut at " << cut.size();
  }
  const Key content = readStore(folder / "a")->grid->content;
  for (int i = 0; i < 200; ++i) {
    std::string flipped = whole;
    const std::size_t at = i < 100 ? random() % 2000 : random() % whole.size();
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (random() % 8)));
    writePlain(folder / "b", flipped);
    auto r = readStore(folder / "b");
    if (!r) continue;
    ++padding;  // only between the tables and the payload, where nothing is
    EXPECT_EQ(r->grid->content, content);
    EXPECT_EQ(contentKeyOf(*r->grid), content);
  }
  EXPECT_LT(padding, 100);
}

TEST(BrickStore, PruningDeletesTheLeastRecentlyUsed) {
  const fs::path folder = test::scratchFolder();
  for (int i = 0; i < 4; ++i) {
    const fs::path path = folder / std::to_string(i);
    ASSERT_TRUE(writeFileAtomic(path, std::string(1000, 'x')));
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(i == 0 ? 0 : 10 - i));
  }
  pruneStores(folder, 2500);
  EXPECT_TRUE(fs::exists(folder / "0"));
  EXPECT_FALSE(fs::exists(folder / "1"));
  EXPECT_FALSE(fs::exists(folder / "2"));
  EXPECT_TRUE(fs::exists(folder / "3"));
}

TEST(BrickStore, WhatWasBegunLongAgoIsSwept) {
  const fs::path folder = test::scratchFolder();
  const fs::path stale = folder / "a.bricks.tmp123-0", fresh = folder / "b.bricks.tmp124-0",
                 whole = folder / "c.bricks";
  for (const fs::path& path : {stale, fresh, whole}) std::ofstream(path) << std::string(1000, 'x');
  fs::last_write_time(stale, fs::file_time_type::clock::now() - std::chrono::hours(2));
  fs::last_write_time(whole, fs::file_time_type::clock::now() - std::chrono::hours(2));
  pruneStores(folder, 1500);  // what is being written does not count, and is not taken away
  EXPECT_FALSE(fs::exists(stale));
  EXPECT_TRUE(fs::exists(fresh));
  EXPECT_TRUE(fs::exists(whole));
}

TEST(BrickStore, OnlyTheKilledWritersFilesAreRemoved) {
  const fs::path folder = test::scratchFolder(), store = folder / "a.bricks";
  const fs::path its = folder / "a.bricks.tmp123-4", other = folder / "a.bricks.tmp1234-0",
                 another = folder / "b.bricks.tmp123-0";
  for (const fs::path& path : {its, other, another, store}) std::ofstream(path) << "x";
  removeTemporaries(store, 123);
  EXPECT_FALSE(fs::exists(its));
  for (const fs::path& path : {other, another, store}) EXPECT_TRUE(fs::exists(path)) << path;
}

}  // namespace
}  // namespace pileus::volume
