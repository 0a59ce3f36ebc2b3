// Voxels on the GPU against OpenVDB's data: every float grid of the data folder, through the brick pool and
// the shader's own sampler.
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>

#include <random>

#include "renderer/volume/brick_builder.h"
#include "tests/support/grid_samples.h"

namespace pileus {
namespace {

/// Bricks of any float grid as it is: level sets and backgrounds too, inside the active bounds.
Result<volume::GridPtr> bricksOf(const openvdb::FloatGrid& grid) {
  const openvdb::CoordBBox b = grid.evalActiveVoxelBoundingBox();
  volume::VoxelSource source;
  source.name = grid.getName();
  source.activeMin = ivec3(b.min().x(), b.min().y(), b.min().z());
  source.activeMax = ivec3(b.max().x(), b.max().y(), b.max().z());
  source.fill = [&](ivec3 lo, float* out) {
    auto accessor = grid.getConstAccessor();
    for (int z = 0; z < volume::kStoredSize; ++z)
      for (int y = 0; y < volume::kStoredSize; ++y)
        for (int x = 0; x < volume::kStoredSize; ++x)
          *out++ = accessor.getValue({lo.x + x, lo.y + y, lo.z + z});
    return volume::Fill::Voxels;
  };
  JobControl control;
  PILEUS_TRY(volume::BuildResult built, volume::buildBricks(source, control));
  return built.grid;
}

std::vector<float> sampleOnGpu(const volume::GridPtr& grid, const std::vector<vec4>& positions) {
  volume::Instance instance;
  instance.shape = volume::Shape::Grid;
  instance.grid = grid;
  return test::sampledOnGpu(instance, positions);
}

void check(const std::string& name, const openvdb::FloatGrid& grid) {
  const auto bricks = bricksOf(grid);
  ASSERT_TRUE(bricks) << name << ": " << bricks.error().message;
  const volume::BrickGrid& g = **bricks;
  if (g.empty()) return;
  const auto quantum = [&](const dvec3& index) {
    const ivec3 b = ivec3(glm::floor((index - dvec3(g.origin)) / double(volume::kBrickSize)));
    return glm::all(glm::greaterThanEqual(b, ivec3(0))) && glm::all(glm::lessThan(b, g.levels[0].bricks))
               ? double(g.levels[0].at(b).scale) / 255
               : 0.0;
  };
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  std::mt19937_64 rng(11);
  std::uniform_real_distribution<double> u(0, 1);
  auto accessor = grid.getConstAccessor();
  constexpr int kVoxels = 100000, kPoints = 10000;
  std::vector<vec4> positions;
  std::vector<dvec3> index;
  for (int i = 0; i < kVoxels + kPoints; ++i) {
    // Trilinear points stay where all eight voxels are inside the active bounds: beyond them a grid counts as
    // 0.
    dvec3 p;
    for (int a = 0; a < 3; ++a) {
      const double lo = box.min()[a], hi = box.max()[a];
      p[a] = i < kVoxels ? std::floor(lo + u(rng) * (hi - lo + 1)) : lo + u(rng) * (hi - lo);
    }
    index.push_back(p);
    positions.push_back(vec4(vec3(p - dvec3(g.origin)), 0));
  }
  const auto values = sampleOnGpu(*bricks, positions);
  int bad = 0;
  for (int i = 0; i < kVoxels + kPoints && bad < 5; ++i) {
    const dvec3 p = index[std::size_t(i)];
    double expected, tolerance;
    if (i < kVoxels) {
      expected = accessor.getValue(openvdb::Coord(int(p.x), int(p.y), int(p.z)));
      tolerance = 0.5 * quantum(p);
    } else {
      expected = openvdb::tools::BoxSampler::sample(accessor, openvdb::Vec3d(p.x, p.y, p.z));
      const dvec3 f = glm::floor(p);
      float lo = 1e30f, hi = -1e30f;
      for (int c = 0; c < 8; ++c) {
        const float v = accessor.getValue(
            openvdb::Coord(int(f.x) + (c & 1), int(f.y) + (c >> 1 & 1), int(f.z) + (c >> 2)));
        lo = std::min(lo, v), hi = std::max(hi, v);
      }
      tolerance = 0.5 * quantum(p) + double(hi - lo) / 256;
    }
    tolerance += 2e-6 * std::max(1.0, std::abs(expected));  // float arithmetic
    const bool ok = std::abs(double(values[std::size_t(i)]) - expected) <= tolerance;
    EXPECT_TRUE(ok) << name << (i < kVoxels ? " voxel " : " point ") << p.x << " " << p.y << " " << p.z
                    << ": GPU " << values[std::size_t(i)] << ", OpenVDB " << expected << ", tolerance "
                    << tolerance;
    bad += !ok;
  }
}

TEST(GridSampling, EveryFloatGridMatchesOpenVdb) {
  PILEUS_NEEDS_DATA();
  openvdb::initialize();
  int grids = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*test::dataFolder() / "vdb")) {
    if (entry.path().extension() != ".vdb") continue;
    openvdb::io::File file(entry.path().string());
    file.open();
    const openvdb::GridPtrVecPtr all = file.getGrids();
    for (const auto& base : *all)
      if (const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(base);
          grid && grid->activeVoxelCount() > 0) {
        check(entry.path().filename().string() + ":" + grid->getName(), *grid);
        ++grids;
      }
  }
  EXPECT_GE(grids, 100);
}

TEST(GridSampling, MipsConserveTheSum) {
  volume::VoxelSource source;
  source.name = "noise";
  source.activeMin = ivec3(0);
  source.activeMax = ivec3(63);
  source.fill = [](ivec3 lo, float* out) {
    for (int z = 0; z < volume::kStoredSize; ++z)
      for (int y = 0; y < volume::kStoredSize; ++y)
        for (int x = 0; x < volume::kStoredSize; ++x) {
          const ivec3 p = lo + ivec3(x, y, z);
          *out++ = float((p.x * 7 + p.y * 13 + p.z * 29) % 31) / 31.0f;
        }
    return volume::Fill::Voxels;
  };
  JobControl control;
  auto built = volume::buildBricks(source, control);
  ASSERT_TRUE(built);
  ASSERT_GE(built->grid->levels.size(), 3u);
  double sums[3] = {};
  for (int level = 0; level < 3; ++level) {
    std::vector<vec4> positions;
    const int n = (66 >> level) + 2;
    const float scale = float(1 << level);
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
          positions.push_back(vec4((vec3(x, y, z) + 0.5f) * scale - 0.5f, float(level)));
    for (const float v : sampleOnGpu(built->grid, positions)) sums[level] += double(v) * std::pow(8.0, level);
  }
  EXPECT_NEAR(sums[1], sums[0], 2e-3 * sums[0]);
  EXPECT_NEAR(sums[2], sums[0], 4e-3 * sums[0]);
}

}  // namespace
}  // namespace pileus
