#pragma once
// Volumes that the reference is tested with: shapes, grids of chosen bytes and values, and a crowd of them.
#include <functional>
#include <random>

#include "renderer/volume/brick_builder.h"
#include "renderer/volume/instance.h"

namespace pileus::shadow {

using volume::BrickGrid;
using volume::GridPtr;
using volume::Instance;
using volume::InstanceList;
using volume::kBrickSize;
using volume::kStoredSize;
using volume::Shape;

struct Random {
  std::mt19937_64 rng;
  double unit() { return std::uniform_real_distribution<double>(0, 1)(rng); }
  dvec3 point(const dvec3& lo, const dvec3& hi) { return lo + dvec3(unit(), unit(), unit()) * (hi - lo); }
};

inline Instance shape(Shape kind, const dmat4& worldFromLocal, double sigma) {
  Instance i;
  i.shape = kind;
  i.worldFromLocal = worldFromLocal;
  i.density = 0.5;
  i.medium.extinction = 2 * sigma;
  return i;
}

inline Instance placed(const GridPtr& grid, const dmat4& worldFromLocal, double extinction = 1) {
  Instance i;
  i.shape = Shape::Grid;
  i.grid = grid;
  i.worldFromLocal = worldFromLocal;
  i.medium.extinction = extinction;
  return i;
}

/// A grid whose every stored byte is chosen: byte(index coordinates of the voxel), from the brick `b`.
inline GridPtr gridOfBytes(ivec3 bricks, const std::function<volume::Brick(ivec3 b)>& brick,
                           const std::function<unsigned(ivec3 b, ivec3 local)>& byte) {
  auto g = std::make_shared<BrickGrid>();
  g->name = "bytes";
  g->indexBounds = {dvec3(0.0), dvec3(bricks * kBrickSize)};
  g->levels.push_back({bricks, {}});
  auto bytes = std::make_shared<std::vector<std::byte>>();
  for (int z = 0; z < bricks.z; ++z)
    for (int y = 0; y < bricks.y; ++y)
      for (int x = 0; x < bricks.x; ++x) {
        volume::Brick b = brick({x, y, z});
        g->maximum = std::max({g->maximum, b.offset, b.offset + b.scale});
        if (b.scale != 0) {
          b.payload = g->payloadCount++;
          for (int k = -1; k <= kBrickSize; ++k)
            for (int j = -1; j <= kBrickSize; ++j)
              for (int i = -1; i <= kBrickSize; ++i) bytes->push_back(std::byte(byte({x, y, z}, {i, j, k})));
        }
        g->levels[0].table.push_back(b);
      }
  g->payload = std::shared_ptr<const std::byte>(bytes, bytes->data());
  return g;
}

/// Bricks of random bytes with ranges of their own; some are constant, some empty.
inline GridPtr randomGrid(ivec3 bricks, std::uint64_t seed) {
  auto r = std::make_shared<Random>(Random{std::mt19937_64(seed)});
  return gridOfBytes(
      bricks,
      [r](ivec3) {
        volume::Brick b;
        const double kind = r->unit();
        if (kind < 0.2) return b;
        b.offset = float(r->unit());
        if (kind > 0.4) b.scale = float(0.1 + r->unit());
        return b;
      },
      [r](ivec3, ivec3) { return unsigned(r->rng() & 255); });
}

template <class F>
GridPtr gridOf(ivec3 lo, ivec3 hi, const F& f) {
  volume::VoxelSource s;
  s.name = "test";
  s.activeMin = lo;
  s.activeMax = hi;
  s.fill = [&f](ivec3 from, float* out) {
    for (int z = 0; z < kStoredSize; ++z)
      for (int y = 0; y < kStoredSize; ++y)
        for (int x = 0; x < kStoredSize; ++x) *out++ = static_cast<float>(f(dvec3(from + ivec3(x, y, z))));
    return volume::Fill::Voxels;
  };
  JobControl control;
  return volume::buildBricks(s, control)->grid;
}

inline double midpoint(const InstanceList& list, const dvec3& from, const dvec3& to, int samples) {
  double sum = 0;
  for (int k = 0; k < samples; ++k)
    for (const Instance& i : list) sum += volume::sigmaAt(i, from + (to - from) * ((k + 0.5) / samples));
  return sum * glm::length(to - from) / samples;
}

inline const dmat4 kTilted = composeTransform({3, -2, 5}, {20, 130, -50}, {-0.7, 1.9, 0.4});

inline InstanceList crowd() {
  return {placed(randomGrid(ivec3(2), 10), composeTransform(dvec3(-1), dvec3(10, 0, 30), dvec3(0.1)), 0.3),
          placed(randomGrid(ivec3(2, 1, 1), 11), composeTransform({0, 0.5, 0}, {0, 45, 0}, {0.1, -0.1, 0.2}),
                 0.4),
          shape(Shape::Box, composeTransform({0.5, 0, 0}, {0, 0, 20}, {2, 1, 3}), 0.3),
          shape(Shape::Ball, composeTransform({1, 1, 1}, dvec3(0), {1, 2, 1}), 0.5)};
}

}  // namespace pileus::shadow
