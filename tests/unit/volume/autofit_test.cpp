#include "renderer/volume/autofit.h"

#include <gtest/gtest.h>

#include "renderer/volume/brick_builder.h"

namespace pileus::volume {
namespace {

GridPtr ball(double radius, double density, double voxel, double hollow = 0) {
  VoxelSource s;
  s.name = "ball";
  s.worldFromIndex = glm::scale(dmat4(1), dvec3(voxel));
  s.activeMin = ivec3(static_cast<int>(-radius) - 1);
  s.activeMax = -s.activeMin;
  s.fill = [=](ivec3 lo, float* out) {
    for (int z = 0; z < kStoredSize; ++z)
      for (int y = 0; y < kStoredSize; ++y)
        for (int x = 0; x < kStoredSize; ++x) {
          const double r = glm::length(dvec3(lo + ivec3(x, y, z)));
          *out++ = r <= radius && r >= hollow ? static_cast<float>(density) : 0.0f;
        }
    return Fill::Voxels;
  };
  JobControl control;
  return buildBricks(s, control)->grid;
}

TEST(Autofit, GivesTheWantedDepthThroughAUniformBall) {
  // The chord through the middle is 2 r: extinction * density * 2 r * voxel = 6.
  EXPECT_NEAR(autofit(*ball(40, 2.5, 0.5)).extinction, 6 / (2.5 * 80 * 0.5), 0.03 * 6 / 100.0);
  EXPECT_NEAR(autofit(*ball(90, 0.1, 3)).extinction, 6 / (0.1 * 180 * 3), 0.03 * 6 / 54.0);
  EXPECT_EQ(autofit(*ball(20, 1, 1)).opticalDepth, 6);
}

TEST(Autofit, EmptyGridsGiveOne) {
  EXPECT_EQ(autofit(*emptyGrid("none")).extinction, 1);
  EXPECT_EQ(autofit(*emptyGrid("none")).opticalDepth, 0);
}

}  // namespace
}  // namespace pileus::volume
