#include "renderer/volume/brick_grid.h"

#include <algorithm>
#include <cmath>

namespace pileus::volume {
namespace {

/// Stored voxel of a brick; `local` in [-1, 16] along each axis.
double storedVoxel(const BrickGrid& grid, const Brick& brick, ivec3 local) {
  if (brick.payload == kConstantBrick) return static_cast<double>(brick.offset);
  const ivec3 s = local + kApron;
  const std::size_t at =
      (static_cast<std::size_t>(s.z) * kStoredSize + static_cast<std::size_t>(s.y)) * kStoredSize +
      static_cast<std::size_t>(s.x);
  const auto byte = std::to_integer<unsigned>(grid.bytes(brick)[at]);
  return static_cast<double>(brick.offset) + static_cast<double>(brick.scale) * byte / 255.0;
}

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

float voxelAt(const BrickGrid& grid, ivec3 index) {
  if (grid.empty()) return 0;
  const Level& level = grid.levels.front();
  ivec3 brick, local;
  for (int a = 0; a < 3; ++a) {
    const std::int64_t relative = std::int64_t(index[a]) - grid.origin[a];
    if (relative < 0 || relative >= std::int64_t(level.bricks[a]) * kBrickSize) return 0;
    brick[a] = static_cast<int>(relative) / kBrickSize;
    local[a] = static_cast<int>(relative) % kBrickSize;
  }
  return static_cast<float>(storedVoxel(grid, level.at(brick), local));
}

double sampleTrilinear(const BrickGrid& grid, const dvec3& index, int levelIndex) {
  if (grid.empty() || levelIndex < 0 || levelIndex >= static_cast<int>(grid.levels.size())) return 0;
  const Level& level = grid.levels[static_cast<std::size_t>(levelIndex)];
  const dvec3 p = (index - dvec3(grid.origin) + 0.5) * std::exp2(-levelIndex) - 0.5;
  ivec3 brick, local;
  dvec3 t;
  for (int a = 0; a < 3; ++a) {
    if (!(p[a] > -1.0 && p[a] < double(level.bricks[a]) * kBrickSize)) return 0;  // also NaN
    const int voxel = static_cast<int>(std::floor(p[a]));
    brick[a] = std::max(
        0,
        floorDiv(voxel, kBrickSize));  // the first brick also answers for (-1, 0): its near apron is stored
    local[a] = voxel - brick[a] * kBrickSize;
    t[a] = p[a] - voxel;
  }
  const Brick& b = level.at(brick);
  if (b.payload == kConstantBrick) return static_cast<double>(b.offset);
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const ivec3 o(c & 1, (c >> 1) & 1, c >> 2);
    const double w = (o.x ? t.x : 1 - t.x) * (o.y ? t.y : 1 - t.y) * (o.z ? t.z : 1 - t.z);
    if (w > 0) sum += w * storedVoxel(grid, b, local + o);
  }
  return sum;
}

}  // namespace pileus::volume
