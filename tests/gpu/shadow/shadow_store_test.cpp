// Where map layers lie: narrow maps beside each other in wide layers, and what is in them when they move.
#include "renderer/shadow/shadow_store.h"

#include "renderer/gl/texture.h"
#include "tests/support/gl_faults.h"
#include "tests/support/lit.h"

namespace pileus {
namespace {

using shadow::ShadowStore;
using shadow::Texels;
using BlockPtr = std::shared_ptr<const shadow::ShadowBlock>;

constexpr std::size_t kPlenty = std::size_t(4) << 30;

BlockPtr allocate(ShadowStore& store, int resolution, int layers, int faces = 1) {
  auto block = store.allocate(Texels::Float, resolution, layers, faces);
  EXPECT_TRUE(block) << (block ? "" : block.error().message);
  return block ? *block : nullptr;
}

/// One number in all texels of a layer of a block.
void fill(const BlockPtr& block, float value) {
  const gpu::BlockRecord r = block->record();
  for (int l = 0; l < block->layers() * block->faces(); ++l) {
    const vec4 v(value, static_cast<float>(l), 0, 1);
    glClearTexSubImage(block->texture(), 0, r.place.x, r.place.y, r.place.w + l, r.place.z, r.place.z, 1,
                       GL_RGBA, GL_FLOAT, &v.x);
  }
}

void expectFilled(const BlockPtr& block, float value) {
  const gpu::BlockRecord r = block->record();
  for (int l = 0; l < block->layers() * block->faces(); ++l)
    for (const ivec2 at : {ivec2(0), ivec2(block->resolution() - 1)}) {
      vec4 v(-1);
      glGetTextureSubImage(block->texture(), 0, r.place.x + at.x, r.place.y + at.y, r.place.w + l, 1, 1, 1,
                           GL_RGBA, GL_FLOAT, sizeof v, &v.x);
      EXPECT_EQ(v, vec4(value, static_cast<float>(l), 0, 1)) << "layer " << l;
    }
}

TEST(ShadowStore, OneWideMapDoesNotWidenTheLayersOfNarrowOnes) {
  test::renderer();
  ShadowStore store(kPlenty);
  std::vector<BlockPtr> narrow;
  std::size_t sum = 0;
  for (int i = 0; i < 16; ++i) {
    narrow.push_back(allocate(store, 128, 2));
    sum += narrow.back()->bytes();
    fill(narrow.back(), static_cast<float>(i));
  }
  EXPECT_EQ(store.bytes(), sum);
  const BlockPtr wide = allocate(store, 256, 2);
  fill(wide, 100);
  sum += wide->bytes();
  std::printf("32 layers of 128 x 128 and 2 of 256 x 256: %.1f MiB, the maps themselves %.1f MiB\n",
              double(store.bytes()) / (1 << 20), double(sum) / (1 << 20));
  EXPECT_LE(double(store.bytes()), 1.05 * double(sum));
  for (int i = 0; i < 16; ++i) expectFilled(narrow[std::size_t(i)], static_cast<float>(i));
  expectFilled(wide, 100);
}

TEST(ShadowStore, BlocksOfAnySizeKeepTheirTexelsAndNeverOverlap) {
  test::renderer();
  ShadowStore store(kPlenty);
  std::vector<std::pair<BlockPtr, float>> blocks;
  unsigned state = 7;
  const auto random = [&](int n) {
    state = state * 1664525u + 1013904223u;
    return int(state >> 8) % n;
  };
  float next = 1;
  for (int i = 0; i < 60; ++i) {
    if (!blocks.empty() && random(3) == 0) blocks.erase(blocks.begin() + random(int(blocks.size())));
    const int resolution = (8 << random(4)) - random(5), layers = 1 + random(4),
              faces = random(4) == 0 ? 6 : 1;
    blocks.emplace_back(allocate(store, resolution, layers, faces), next);
    fill(blocks.back().first, next++);
    if (i % 20 == 19)
      for (const auto& [block, value] : blocks) expectFilled(block, value);
  }
}

TEST(ShadowStore, TheRoomOfMapsThatWentIsUsedAgain) {
  test::renderer();
  ShadowStore store(kPlenty);
  std::vector<BlockPtr> all;
  for (int i = 0; i < 8; ++i) all.push_back(allocate(store, 128, 4));
  const BlockPtr wide = allocate(store, 256, 4);
  const std::size_t bytes = store.bytes();
  for (int round = 0; round < 3; ++round) {
    all.clear();
    for (int i = 0; i < 8; ++i) all.push_back(allocate(store, 128, 4));
    EXPECT_EQ(store.bytes(), bytes);
  }
}

TEST(ShadowStore, MapsThatMovedAreLookedUpWhereTheyAre) {
  const volume::InstanceList volumes{test::box({0, 0, 0}, {1, 1, 1}, 2)};
  const auto sun = test::sunFrom({0.2, 1, 0.1});
  const std::vector<vec3> at{{0, 0.3f, 0}, {0.1f, -0.2f, 0.2f}, {-0.3f, -0.45f, -0.1f}};
  const shadow::MetricOptions metric{shadow::Metric::Interval, 2, 4, 64};
  const shadow::ExtinctionOptions extinction{shadow::Basis::Cosine, 8, 64};
  const auto small = test::buildMap(volumes, sun, metric, extinction);
  const gpu::BlockRecord before = small->block->record();
  const std::vector<float> want = test::lookupTau(*small, sun, at);
  EXPECT_GT(want[2], 1);
  // Wider and wider, until all lies somewhere else.
  std::vector<BlockPtr> others;
  for (int edge = 128; edge <= 1024; edge *= 2)
    others.push_back(*test::renderer().shadows().allocate(Texels::Float, edge, 2));
  const gpu::BlockRecord after = small->block->record();
  EXPECT_TRUE(before.place != after.place);
  EXPECT_EQ(test::lookupTau(*small, sun, at), want);
}

TEST(ShadowStore, AStoreThatCannotGrowKeepsItsMaps) {
  test::renderer();
  ShadowStore store(kPlenty);
  const BlockPtr block = allocate(store, 64, 2);
  fill(block, 3);
  {
    const test::Faults scarce({}, std::size_t(1) << 20);
    const auto refused = store.allocate(Texels::Float, 256, 4);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message.find("shadow store float: out of GPU memory"), 0u)
        << refused.error().message;
    const auto deep = store.allocateDeep(1 << 20);
    ASSERT_FALSE(deep);
    EXPECT_EQ(deep.error().message.find("deep shadow maps: out of GPU memory"), 0u) << deep.error().message;
  }
  {
    const test::Faults claimed({{GL_MAX_ARRAY_TEXTURE_LAYERS, 8}}, test::Faults::kAny);
    const auto refused = store.allocate(Texels::Float, 64, 9);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("at most 8"), std::string::npos) << refused.error().message;
  }
  expectFilled(block, 3);
  EXPECT_TRUE(store.allocate(Texels::Float, 256, 4));
  EXPECT_TRUE(store.allocateDeep(1 << 20));
  expectFilled(block, 3);
}

TEST(ShadowStore, MapsNobodyWaitsForMakeRoom) {
  test::renderer();
  constexpr std::size_t kOne = std::size_t(64) * 64 * 16 * 2;  // bytes of one of these maps
  ShadowStore store(3 * kOne);
  std::vector<BlockPtr> old;
  int asked = 0;
  store.setReclaim(&old, [&](std::size_t bytes) {
    EXPECT_EQ(bytes, kOne);
    ++asked;
    if (old.size() < 2) return false;
    old.erase(old.begin());
    return true;
  });
  for (int i = 0; i < 20; ++i) {
    BlockPtr block = allocate(store, 64, 2);
    ASSERT_TRUE(block) << i;
    fill(block, float(i));
    old.push_back(block);
    for (const BlockPtr& each : old)
      expectFilled(each, float(i) - float(old.size() - 1 - std::size_t(&each - old.data())));
  }
  EXPECT_EQ(old.size(), 3u);
  EXPECT_EQ(asked, 17);
  EXPECT_EQ(store.usedBytes(), 3 * kOne);
  EXPECT_LE(store.bytes(), 3 * kOne);
  const std::size_t before = old.size();
  EXPECT_FALSE(store.allocate(Texels::Float, 1024, 2));
  EXPECT_EQ(old.size(), before) << "what can never fit drives nothing out";
}

TEST(ShadowStore, WhatLiesEmptyIsNoHindrance) {
  test::renderer();
  constexpr std::size_t kMiB = std::size_t(1) << 20;
  ShadowStore store(2 * kMiB);
  const BlockPtr small = allocate(store, 16, 1);
  fill(small, 5);
  { EXPECT_TRUE(store.allocate(Texels::Float, 256, 1)); }  // 1 MiB, given up at once
  {
    // Wide once, narrow now: six layers as wide would be 6 MiB.
    const auto narrow = store.allocate(Texels::Float, 64, 6);
    ASSERT_TRUE(narrow) << narrow.error().message;
    expectFilled(small, 5);
  }
  { EXPECT_TRUE(store.allocate(Texels::Float, 256, 1)); }
  { EXPECT_TRUE(store.allocateDeep(kMiB / 8)); }
  const auto half = store.allocate(Texels::Half, 256, 3);  // 1.5 MiB
  ASSERT_TRUE(half) << half.error().message;
  expectFilled(small, 5);
  EXPECT_LE(store.bytes(), 2 * kMiB);
}

TEST(ShadowStore, RefusalsAgreeWithThemselves) {
  test::renderer();
  ShadowStore store(16 * 16 * 16 - 1);  // a byte less than the least map
  const auto refused = store.allocate(Texels::Float, 16, 1);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("would need 0.1 MiB"), std::string::npos) << refused.error().message;
  EXPECT_NE(refused.error().message.find("0.0 MiB are set aside"), std::string::npos)
      << refused.error().message;
  const auto deep = store.allocateDeep(1 << 17);
  ASSERT_FALSE(deep);
  EXPECT_NE(deep.error().message.find("1.0 MiB"), std::string::npos) << deep.error().message;
}

TEST(ShadowStore, BarriersStandBehindEveryDispatchThatWritesMaps) {
  const shadow::Gpu shared = test::renderer().gpu();
  ShadowStore store(kPlenty);
  const shadow::Gpu gpu{shared.device, shared.shaders, shared.bricks, store};
  const volume::InstanceList volumes{test::box({0, 0, 0}, {1, 1, 1}, 2), test::ball({0.2, 0.3, 0}, 0.4, 1)};
  const auto sun = test::sunFrom({0.2, 1, 0.1});
  const test::BarrierWatch watch;
  std::vector<std::shared_ptr<const shadow::ShadowMap>> kept;
  const auto build = [&](const shadow::ShadowSpec& spec) {
    const auto map = shadow::buildShadow(gpu, spec, sun, volumes);
    ASSERT_TRUE(map) << map.error().message;
    kept.push_back(*map);
  };
  for (const int resolution : {32, 64}) {
    shadow::ShadowSpec spec;
    spec.metric = {shadow::Metric::Interval, 2, 4, resolution};
    spec.extinction = {shadow::Basis::Cosine, 8, resolution};
    spec.metric.horizon = 0;
    build(spec);
    spec.extinction.accumulation = shadow::Accumulation::Splat;
    build(spec);
    spec.metric = {shadow::Metric::Fourier, 2, 4, resolution};
    build(spec);
    spec.kind = shadow::ShadowSpec::Kind::Deep;
    spec.resolution = resolution;
    build(spec);
  }
  for (const char* call : {"copy image", "copy buffer", "read texels", "draw"})
    EXPECT_GT(watch.seen(call), 0) << call;
  for (const auto& [call, times] : watch.missing()) ADD_FAILURE() << call << ": " << times << " times";
}

}  // namespace
}  // namespace pileus
