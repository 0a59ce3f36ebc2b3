// The lattices that light is solved for on: around what, and how fine.
#include <gtest/gtest.h>

#include "renderer/view/scatter_gather.h"

namespace pileus::view {
namespace {

volume::Instance box(const dvec3& center, double edge, double sigma) {
  volume::Instance i;
  i.worldFromLocal = composeTransform(center, dvec3(0), dvec3(edge));
  i.medium.extinction = sigma;
  return i;
}

bool holds(const transport::Lattice& lattice, const Box3& b) {
  const dvec3 max = lattice.min + lattice.cell * dvec3(lattice.cells);
  return glm::all(glm::lessThanEqual(lattice.min, b.min)) && glm::all(glm::lessThanEqual(b.max, max));
}

const ScatterOptions kGrid{Scattering::Grid, 64, 1e-4};

TEST(ScatterLattices, NoneWhereNothingScatters) {
  EXPECT_TRUE(scatterLattices({}, {}, kGrid).empty());
  volume::Instance black = box(dvec3(0), 1, 5);
  black.medium.albedo = vec3(0);
  EXPECT_TRUE(scatterLattices({black}, {}, kGrid).empty());
}

TEST(ScatterLattices, AreAsFineAsTheMediaAskFor) {
  EXPECT_EQ(scatterLattices({box(dvec3(0), 1, 0.1)}, {}, kGrid)[0].cells, ivec3(32));
  EXPECT_EQ(scatterLattices({box(dvec3(0), 1, 6)}, {}, kGrid)[0].cells, ivec3(48));
  EXPECT_EQ(scatterLattices({box(dvec3(0), 1, 1e4)}, {}, kGrid)[0].cells, ivec3(64));
}

TEST(ScatterLattices, WhatIsDenseAndSmallHasItsOwn) {
  const volume::Instance haze = box(dvec3(0), 1000, 1e-3), cloud = box({100, 0, 0}, 100, 0.1),
                         other = box({-300, 0, 0}, 60, 0.2), beside = box({160, 0, 0}, 40, 0.1);
  const auto all = scatterLattices({haze, cloud, other, beside}, {}, kGrid);
  ASSERT_EQ(all.size(), 3u) << "around all, around the two clouds that touch, around the third";
  EXPECT_TRUE(holds(all[0], volume::worldBounds(haze)));
  EXPECT_TRUE(holds(all[1], volume::worldBounds({cloud, beside})));
  EXPECT_TRUE(holds(all[2], volume::worldBounds(other)));
}

TEST(ScatterLattices, MakeRoomForSolidsNearBy) {
  const scene::SolidList ground{
      {scene::SolidShape::Plane, composeTransform({0, -0.6, 0}, dvec3(0), {1e4, 1, 1e4})}};
  const volume::Instance cloud = box(dvec3(0), 1, 5);
  const auto all = scatterLattices({cloud}, ground, kGrid);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(holds(all[0], {dvec3(-1.4, -0.6, -1.4), dvec3(1.4, 0.5, 1.4)}));
  EXPECT_LT(all[0].cell * all[0].cells.x, 3.2) << "but not for all of it";
  EXPECT_TRUE(holds(all[1], volume::worldBounds(cloud)));
  const scene::SolidList far{{scene::SolidShape::Box, composeTransform({0, -50, 0}, dvec3(0), dvec3(1))}};
  EXPECT_EQ(scatterLattices({cloud}, far, kGrid), scatterLattices({cloud}, {}, kGrid));
}

TEST(ScatterLattices, AThousandVolumesAreSoonSorted) {
  volume::InstanceList many;
  for (int i = 0; i < 1000; ++i) many.push_back(box({2.0 * (i % 32), 0, 1.999 * (i / 32)}, 2, 50));
  EXPECT_EQ(scatterLattices(many, {}, kGrid).size(), 1u) << "all touch: one around all serves";
  for (int i = 0; i < 1000; ++i) many[std::size_t(i)] = box({5.0 * (i % 32), 0, 5.0 * (i / 32)}, 2, 50);
  EXPECT_EQ(scatterLattices(many, {}, kGrid).size(), 5u) << "as many as there may be";
}

}  // namespace
}  // namespace pileus::view
