#include "renderer/volume/autofit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "renderer/volume/brick_builder.h"
#include "renderer/volume/vdb_fit.h"
#include "tests/support/support.h"

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

/// A ball of 30 voxels about the origin, and single voxels of density 1 elsewhere.
GridPtr withStrays(const std::vector<ivec3>& strays) {
  constexpr double kRadius = 30;
  VoxelSource s;
  s.name = "density";
  s.activeMin = ivec3(-30);
  s.activeMax = ivec3(30);
  for (const ivec3& p : strays)
    s.activeMin = glm::min(s.activeMin, p), s.activeMax = glm::max(s.activeMax, p);
  const auto near = [=](ivec3 lo) {
    if (glm::length(dvec3(lo)) < kRadius + 2 * kStoredSize) return true;
    for (const ivec3& p : strays)
      if (glm::all(glm::greaterThanEqual(p, lo)) && glm::all(glm::lessThan(p, lo + kStoredSize))) return true;
    return false;
  };
  s.touches = near;
  s.fill = [=](ivec3 lo, float* out) {
    for (int i = 0; i < kStoredVoxels; ++i) {
      const ivec3 p =
          lo + ivec3(i % kStoredSize, i / kStoredSize % kStoredSize, i / kStoredSize / kStoredSize);
      const bool stray = std::find(strays.begin(), strays.end(), p) != strays.end();
      out[i] = stray || glm::length(dvec3(p)) <= kRadius ? 1.0f : 0.0f;
    }
    return Fill::Voxels;
  };
  JobControl control;
  auto built = buildBricks(s, control);
  EXPECT_TRUE(built) << built.error().message;
  return built->grid;
}

TEST(Bulk, LeavesStraysOut) {
  const double alone = autofit(*withStrays({})).extinction;
  EXPECT_EQ(bulkBounds(*withStrays({})).max, dvec3(31));
  for (const std::vector<ivec3>& strays : {std::vector<ivec3>{{20000, 0, 0}},
                                           {{-20000, 0, 0}},
                                           {{900, 1000, -1100}},
                                           {{0, 600, 0}},
                                           {{20000, 0, 0}, {-3000, 10, 0}, {0, 0, 40}}}) {
    SCOPED_TRACE(strays[0].x);
    const GridPtr grid = withStrays(strays);
    const Box3 bulk = bulkBounds(*grid);
    // All of the ball, and little more.
    for (int a = 0; a < 3; ++a) {
      EXPECT_LE(bulk.min[a], -31);
      EXPECT_GE(bulk.max[a], 31);
      EXPECT_LE(bulk.size()[a], 130);
    }
    EXPECT_NEAR(autofit(*grid).extinction, alone, 0.12 * alone);
    dvec3 furthest(31);
    for (const ivec3& p : strays) furthest = glm::max(furthest, dvec3(p) + 1.0);
    EXPECT_EQ(grid->indexBounds.max, furthest) << "they are drawn";
  }
}

TEST(Bulk, IsAllOfWhatHangsTogetherOrHasWeight) {
  // A trail of single voxels: thin, but no stray.
  std::vector<ivec3> trail;
  for (int x = 30; x < 900; x += 40) trail.push_back({x, 0, 0});
  const GridPtr tailed = withStrays(trail);
  EXPECT_EQ(bulkBounds(*tailed).max, tailed->indexBounds.max);
  // A second ball as large as the first would be: not a thousandth, a part.
  std::vector<ivec3> other;
  for (int i = 0; i < 1000; ++i) other.push_back({700 + i % 10, i / 10 % 10, i / 100});
  const GridPtr two = withStrays(other);
  EXPECT_EQ(bulkBounds(*two).max, two->indexBounds.max);
  EXPECT_TRUE(bulkBounds(*emptyGrid("none")).empty());
  Instance ball;
  ball.shape = Shape::Ball;
  EXPECT_EQ(worldBulkBounds(ball).max, worldBounds(ball).max);
}

TEST(Autofit, EmptyGridsGiveOne) {
  EXPECT_EQ(autofit(*emptyGrid("none")).extinction, 1);
  EXPECT_EQ(autofit(*emptyGrid("none")).opticalDepth, 0);
}

GridInfo grid(const std::string& name, const std::string& gridClass, const std::string& type = "float") {
  GridInfo g;
  g.name = name;
  g.gridClass = gridClass;
  g.valueType = type;
  g.scalar = g.drawable = type != "vec3s" && gridClass != "level set";
  if (!g.drawable) g.reason = "is not drawn";
  return g;
}

TEST(GridGuess, NamesBeforeClassesBeforeAnything) {
  const std::vector<GridInfo> usual = {grid("heat", "unknown"), grid("Density", "fog volume"),
                                       grid("v", "staggered", "vec3s"), grid("noise", "fog volume")};
  GridGuess g = guessGrid(usual);
  EXPECT_EQ(g.grid, "Density");
  EXPECT_EQ(g.confidence, Confidence::Sure);
  ASSERT_EQ(g.notes.size(), 3u);
  EXPECT_NE(g.notes[0].find("'heat' looks like temperature: a Black Body"), std::string::npos);
  EXPECT_NE(g.notes[1].find("velocity"), std::string::npos);
  EXPECT_EQ(g.notes[2], "Not used: noise");

  const std::vector<GridInfo> plain = {grid("temperature", "fog volume"), grid("puff", "fog volume"),
                                       grid("mask", "unknown")};
  g = guessGrid(plain);
  EXPECT_EQ(g.grid, "puff") << "the first fog volume that is no heat";
  EXPECT_NE(g.confidence, Confidence::Sure);

  const std::vector<GridInfo> fire = {grid("flames", "unknown", "half"),
                                      grid("temperature", "unknown", "half")};
  g = guessGrid(fire);
  EXPECT_EQ(g.grid, "flames") << "better something than nothing";
  EXPECT_EQ(g.confidence, Confidence::Guess);

  const std::vector<GridInfo> none = {grid("surface", "level set"), grid("Cd", "unknown", "vec3s")};
  g = guessGrid(none);
  EXPECT_TRUE(g.grid.empty());
  EXPECT_EQ(g.notes.size(), 2u);
  EXPECT_TRUE(guessGrid({}).grid.empty());
}

TEST(GridGuess, RolesOfNames) {
  EXPECT_EQ(roleOfGrid("SMOKE"), GridRole::Density);
  EXPECT_EQ(roleOfGrid("density[2]"), GridRole::Density);
  EXPECT_EQ(roleOfGrid("vel.x"), GridRole::Velocity);
  EXPECT_EQ(roleOfGrid("densityish"), GridRole::Unknown);
}

TEST(VdbFit, FindsFramesBesideAFile) {
  const std::filesystem::path folder = test::scratchFolder();
  for (const char* name : {"s_8.vdb", "s_9.vdb", "s_10.vdb", "t_1.vdb", "s_11.txt"})
    std::ofstream(folder / name) << "x";
  const FileFrames frames = framesBeside(folder / "s_9.vdb");
  EXPECT_EQ(frames.count, 3);
  EXPECT_EQ(frames.first, "s_8.vdb");
  EXPECT_EQ(frames.last, "s_10.vdb");
  EXPECT_EQ(framesBeside(folder / "t_1.vdb").count, 1);
}

TEST(VdbFit, FitsRealFiles) {
  PILEUS_NEEDS_DATA();
  JobControl control;
  const std::filesystem::path vdb = *test::dataFolder() / "vdb";
  const Result<VdbFit> smoke = fitVdb(vdb / "smoke1.vdb", control);
  ASSERT_TRUE(smoke) << smoke.error().message;
  EXPECT_EQ(smoke->guess.grid, "density");
  EXPECT_TRUE(smoke->byDefault);
  EXPECT_GT(smoke->fit.extinction, 0.001);
  EXPECT_EQ(smoke->fit.opticalDepth, 6);
  EXPECT_FALSE(smoke->bounds.empty());
  EXPECT_NEAR(smoke->voxelSize, 0.476, 0.01);

  const Result<VdbFit> heat = fitVdb(vdb / "usd_densityAndHeat.vdb", control);
  ASSERT_TRUE(heat) << heat.error().message;
  EXPECT_EQ(heat->guess.grid, "density");
  EXPECT_TRUE(heat->smoke);
  EXPECT_TRUE(heat->guess.notes.empty()) << "the other grid glows";
  ASSERT_TRUE(heat->fire);
  EXPECT_EQ(heat->fire->grid, "heat");
  EXPECT_FALSE(heat->fire->kelvins);
  EXPECT_GT(heat->fire->range.highest, 0.5);
  EXPECT_LE(heat->fire->range.highest, 0.76);
  EXPECT_GT(heat->bounds.max.z, 27) << "smoke and fire";

  const Result<VdbFit> none = fitVdb(vdb / "oiio_sphereCd.vdb", control);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("Cd"), std::string::npos) << none.error().message;
}

TEST(VdbFit, FitsFireAloneAndBesideSmoke) {
  PILEUS_NEEDS_DATA();
  JobControl control;
  const std::filesystem::path vdb = *test::dataFolder() / "vdb";
  const Result<VdbFit> fire = fitVdb(vdb / "embergen_fire" / "embergen_fire_a_20.vdb", control);
  ASSERT_TRUE(fire) << fire.error().message;
  EXPECT_FALSE(fire->smoke);
  ASSERT_TRUE(fire->fire);
  EXPECT_EQ(fire->guess.grid, fire->fire->grid);
  EXPECT_GT(fire->fire->range.body.strength, 0);
  EXPECT_GT(fire->fire->brightness, 1);
  EXPECT_FALSE(fire->bounds.empty());
  EXPECT_NEAR(fire->bounds.center().z, -98, 4);
  EXPECT_EQ(fire->frames.count, 40);
  // No voxel of frame 0 is active.
  const Result<VdbFit> none = fitVdb(vdb / "embergen_fire" / "embergen_fire_a_0.vdb", control);
  EXPECT_TRUE(!none || !none->fire);

  const Result<VdbFit> hot = fitVdb(vdb / "blender_adaptive_seq" / "fluid_data_0030.vdb", control);
  ASSERT_TRUE(hot) << hot.error().message;
  EXPECT_TRUE(hot->smoke);
  ASSERT_TRUE(hot->fire);
  EXPECT_EQ(hot->fire->grid, "temperature");
  EXPECT_EQ(hot->fire->confidence, Confidence::Guess);
  EXPECT_NE(hot->fire->why.find("flames are empty"), std::string::npos);
  EXPECT_EQ(hot->fit.opticalDepth, 6);
}

}  // namespace
}  // namespace pileus::volume
