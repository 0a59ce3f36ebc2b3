#include "renderer/volume/cloud/procedural.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "renderer/volume/brick_builder.h"
#include "renderer/volume/cloud/classic_cloud.h"
#include "renderer/volume/cloud/cloud_field.h"

namespace pileus::volume {
namespace {

constexpr std::size_t kVoxels = kBrickSize * kBrickSize * kBrickSize;

Result<void> check(const CloudParams& p) {
  const auto outside = [](const char* what, double value, double lo, double hi) {
    return fail(Code::Arguments, "cloud: {} is {}, but must lie in {} .. {}", what, value, lo, hi);
  };
  const auto in = [](double v, double lo, double hi) { return v >= lo && v <= hi; };
  if (!in(p.coverage, 0, 1)) return outside("coverage", p.coverage, 0, 1);
  if (!in(p.density, 0, 1e6)) return outside("density", p.density, 0, 1e6);
  if (!in(p.detail, 0, 1)) return outside("detail", p.detail, 0, 1);
  if (!in(p.billow, 0, 1)) return outside("billow", p.billow, 0, 1);
  if (!in(p.shear, -10, 10)) return outside("shear", p.shear, -10, 10);
  if (!in(p.base, 0, 1)) return outside("base", p.base, 0, 1);
  if (!in(p.top, 0, 1)) return outside("top", p.top, 0, 1);
  if (!in(p.breadth, 0.05, 100)) return outside("breadth", p.breadth, 0.05, 100);
  if (!in(p.wisp, 0, 1)) return outside("wisp", p.wisp, 0, 1);
  if (!in(p.anvil, 0, 2)) return outside("anvil", p.anvil, 0, 2);
  if (!in(p.age, 0, 1)) return outside("age", p.age, 0, 1);
  if (!in(p.wind, -200, 200)) return outside("wind", p.wind, -200, 200);
  if (!in(p.time, -1e6, 1e6)) return outside("time", p.time, -1e6, 1e6);
  if (!in(p.resolution, 16, 1024)) return outside("resolution", p.resolution, 16, 1024);
  for (int a = 0; a < 3; ++a) {
    if (!in(p.size[a], 1e-3, 1e7)) return outside("size", p.size[a], 1e-3, 1e7);
    if (!in(p.center[a], -1e9, 1e9)) return outside("center", p.center[a], -1e9, 1e9);
  }
  if (p.genus != Genus::Classic && p.top - p.base < 0.01)
    return fail(Code::Arguments, "top is {}, but must lie at least 0.01 above the base, which is {}", p.top,
                p.base);
  return {};
}

/// 16^3 floats per brick of the box, null where the field is 0.
struct Bake {
  ivec3 voxels, bricks;
  std::vector<std::unique_ptr<float[]>> data;
  const float* at(ivec3 b) const {
    if (glm::any(glm::lessThan(b, ivec3(0))) || glm::any(glm::greaterThanEqual(b, bricks))) return nullptr;
    return data[static_cast<std::size_t>((b.z * bricks.y + b.y) * bricks.x + b.x)].get();
  }
};

/// Calls `evaluate(brick, floats)` for all bricks of the box, in parallel.
template <class Evaluate>
void fillBricks(Bake& bake, JobControl& control, const Evaluate& evaluate) {
  const std::size_t count =
      std::size_t(bake.bricks.x) * std::size_t(bake.bricks.y) * std::size_t(bake.bricks.z);
  bake.data.resize(count);
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
    if (control.cancelled()) return;
    const int flat = static_cast<int>(i);
    std::array<float, kVoxels> voxels;
    if (evaluate(ivec3(flat % bake.bricks.x, flat / bake.bricks.x % bake.bricks.y,
                       flat / bake.bricks.x / bake.bricks.y),
                 voxels.data())) {
      bake.data[i] = std::make_unique<float[]>(kVoxels);
      std::copy(voxels.begin(), voxels.end(), bake.data[i].get());
    }
    control.progress(0.9 * double(++done) / double(count));
  });
}

/// Index bounds of the voxels that are not 0.
void tightBounds(const Bake& bake, ivec3& lowest, ivec3& highest) {
  lowest = ivec3(1 << 20);
  highest = ivec3(-1);
  for (int bz = 0; bz < bake.bricks.z; ++bz)
    for (int by = 0; by < bake.bricks.y; ++by)
      for (int bx = 0; bx < bake.bricks.x; ++bx) {
        const float* data = bake.at({bx, by, bz});
        if (!data) continue;
        for (int i = 0; i < kBrickSize * kBrickSize * kBrickSize; ++i) {
          if (data[i] == 0) continue;
          const ivec3 p = ivec3(bx, by, bz) * kBrickSize +
                          ivec3(i % kBrickSize, i / kBrickSize % kBrickSize, i / kBrickSize / kBrickSize);
          lowest = glm::min(lowest, p);
          highest = glm::max(highest, p);
        }
      }
}

Fill gatherBlock(const Bake& bake, ivec3 lo, float* out) {
  bool any = false;
  for (int z = 0; z < kStoredSize; ++z)
    for (int y = 0; y < kStoredSize; ++y)
      for (int x = 0; x < kStoredSize; ++x) {
        const ivec3 p = lo + ivec3(x, y, z);
        const float* data = glm::any(glm::lessThan(p, ivec3(0))) ? nullptr : bake.at(p / kBrickSize);
        const ivec3 l = p & (kBrickSize - 1);
        const float v = data ? data[(l.z * kBrickSize + l.y) * kBrickSize + l.x] : 0.0f;
        any |= v != 0;
        *out++ = v;
      }
  return any ? Fill::Voxels : Fill::Zero;
}

}  // namespace

Result<GridPtr> bakeCloud(const CloudParams& params, JobControl& control, Cores cores) {
  if (cores == Cores::LeaveOne) {
    tbb::task_arena arena(std::max(tbb::info::default_concurrency() - 1, 1));
    return arena.execute([&] { return bakeCloud(params, control, Cores::All); });
  }
  PILEUS_CHECK(check(params));
  const double longest = std::max({params.size.x, params.size.y, params.size.z});
  const double voxel = longest / params.resolution;
  const dvec3 lowest = params.center - 0.5 * params.size;
  VoxelSource source;
  source.name = "cloud";
  source.worldFromIndex = glm::scale(glm::translate(dmat4(1.0), lowest + 0.5 * voxel), dvec3(voxel));
  if (params.coverage == 0 || params.density == 0) return emptyGrid(source.name, source.worldFromIndex);

  Bake bake;
  bake.voxels = glm::max(ivec3(params.size / voxel + 0.5), ivec3(1));
  bake.bricks = (bake.voxels + (kBrickSize - 1)) / kBrickSize;
  const auto edge = static_cast<float>(voxel);
  if (params.genus == Genus::Classic) {
    const ClassicCloud cloud(params, edge, control);
    fillBricks(bake, control,
               [&](ivec3 brick, float* out) { return cloud.brick(brick, bake.voxels, out, control); });
  } else {
    const auto field = cloudField(params, control);
    fillBricks(bake, control, [&](ivec3 brick, float* out) {
      return field->brick((vec3(brick * kBrickSize) + 0.5f) * edge, edge, out);
    });
  }
  if (control.cancelled()) return fail(Code::Cancelled, "cancelled");
  tightBounds(bake, source.activeMin, source.activeMax);
  source.fill = [&](ivec3 lo, float* out) { return gatherBlock(bake, lo, out); };
  PILEUS_TRY(BuildResult built, buildBricks(source, control, 0.9));
  return built.grid;
}

}  // namespace pileus::volume
