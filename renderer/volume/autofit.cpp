#include "renderer/volume/autofit.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace pileus::volume {
namespace {

/// A voxel of a brick by its place in it.
double ownVoxel(const BrickGrid& grid, const Brick& brick, ivec3 at) {
  if (brick.payload == kConstantBrick) return double(brick.offset);
  const ivec3 s = at + kApron;
  const auto i = (std::size_t(s.z) * kStoredSize + std::size_t(s.y)) * kStoredSize + std::size_t(s.x);
  return double(brick.offset) + double(brick.scale) * std::to_integer<unsigned>(grid.bytes(brick)[i]) / 255;
}

/// About how much lies in a brick: every eighth voxel stands for those next to it, and one that is hardly
/// anything still counts as its largest.
double weightOf(const BrickGrid& grid, const Brick& brick) {
  double sum = 0;
  for (int k = 0; k < kBrickSize; ++k)
    for (int j = k % 2; j < kBrickSize; j += 2)
      for (int i = (j / 2 + k) % 4; i < kBrickSize; i += 4)
        sum += std::max(0.0, ownVoxel(grid, brick, {i, j, k}));
  return std::max(8 * sum, double(brick.maximum));
}

/// How much lies in each slab of the finest bricks, along the three axes. Coarser levels would not do: beside
/// what is dense they round single voxels to nothing.
std::array<std::vector<double>, 3> slabs(const BrickGrid& grid) {
  const Level& level = grid.levels.front();
  std::array<std::vector<double>, 3> sums;
  for (int a = 0; a < 3; ++a) sums[std::size_t(a)].resize(std::size_t(level.bricks[a]));
  for (int z = 0; z < level.bricks.z; ++z)
    for (int y = 0; y < level.bricks.y; ++y)
      for (int x = 0; x < level.bricks.x; ++x) {
        const Brick& brick = level.at({x, y, z});
        if (!(brick.maximum > 0)) continue;
        const double weight = weightOf(grid, brick);
        const ivec3 at(x, y, z);
        for (int a = 0; a < 3; ++a) sums[std::size_t(a)][std::size_t(at[a])] += weight;
      }
  return sums;
}

/// The stretch about the heaviest slab, up to where a gap is wider than it and next to nothing lies behind.
ivec2 withoutStrays(const std::vector<double>& sums) {
  constexpr double kStray = 1e-3;
  double total = 0;
  for (const double v : sums) total += v;
  const int last = static_cast<int>(sums.size()) - 1;
  const int heaviest = static_cast<int>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  ivec2 kept(heaviest);
  // To each side in turn, until neither goes on: what one side gains makes gaps of the other narrow.
  for (bool grown = true; grown;) {
    grown = false;
    for (const int step : {-1, 1}) {
      int& end = step < 0 ? kept.x : kept.y;
      for (int at = end + step; at >= 0 && at <= last; at += step) {
        if (sums[std::size_t(at)] <= 0) continue;
        double behind = 0;
        for (int i = at; i >= 0 && i <= last; i += step) behind += sums[std::size_t(i)];
        if (std::abs(at - end) - 1 > kept.y - kept.x + 1 && behind <= kStray * total) break;
        end = at;
        grown = true;
      }
    }
  }
  return kept;
}

/// Integral of the density [unit x m] along the line through `center` (index coordinates) in a world
/// direction.
double integral(const BrickGrid& grid, const dmat4& indexFromWorld, const dvec3& center,
                const dvec3& direction, int level, const Box3& bulk) {
  const dvec3 d = dvec3(indexFromWorld * dvec4(direction, 0.0));
  const auto inside = intersectBox(center, d, bulk.min, bulk.max);
  if (!inside) return 0;
  const double length = inside->y - inside->x;  // metres: the direction has length 1 in the world
  const int steps = std::clamp(static_cast<int>(2 * length * glm::length(d) / std::exp2(level)), 16, 4096);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    sum += std::max(0.0, sampleTrilinear(grid, center + d * (inside->x + length * (i + 0.5) / steps), level));
  return sum * length / steps;
}

Box3 measuredBulk(const BrickGrid& grid) {
  const auto sums = slabs(grid);
  Box3 box = grid.indexBounds;
  for (int a = 0; a < 3; ++a) {
    const std::vector<double>& along = sums[std::size_t(a)];
    if (*std::max_element(along.begin(), along.end()) <= 0) return grid.indexBounds;  // nothing above 0
    const ivec2 kept = withoutStrays(along);
    const auto holds = [](double v) { return v > 0; };
    // A voxel's value reaches one further.
    if (std::any_of(along.begin(), along.begin() + kept.x, holds))
      box.min[a] = std::max(box.min[a], double(grid.origin[a] + kept.x * kBrickSize) - 1);
    if (std::any_of(along.begin() + kept.y + 1, along.end(), holds))
      box.max[a] = std::min(box.max[a], double(grid.origin[a] + (kept.y + 1) * kBrickSize));
  }
  return box;
}

}  // namespace

int levelToMeasure(const BrickGrid& grid) {
  const auto longest = [](const Level& l) { return std::max({l.bricks.x, l.bricks.y, l.bricks.z}); };
  int level = 0;
  while (level + 1 < static_cast<int>(grid.levels.size()) && longest(grid.levels[std::size_t(level)]) > 8)
    ++level;
  return level;
}

Box3 bulkBounds(const BrickGrid& grid) {
  constexpr double kSmall = 512;  // voxels: what is there is looked at closely enough
  if (grid.empty()) return {};
  const dvec3 size = grid.indexBounds.size();
  if (std::max({size.x, size.y, size.z}) < kSmall) return grid.indexBounds;
  // Asked for whenever a light is fitted, and voxels never change.
  static std::mutex mutex;
  static std::map<Key, Box3> known;
  constexpr std::size_t kMost = 4096;
  {
    const std::lock_guard lock(mutex);
    if (const auto it = known.find(grid.content); it != known.end()) return it->second;
  }
  const Box3 bulk = measuredBulk(grid);
  const std::lock_guard lock(mutex);
  if (known.size() >= kMost) known.clear();
  known[grid.content] = bulk;
  return bulk;
}

Box3 bulkBounds(const Instance& i) {
  return i.shape == Shape::Grid && i.grid ? bulkBounds(*i.grid) : localBounds(i);
}
Box3 worldBulkBounds(const Instance& i) { return transformed(bulkBounds(i), i.worldFromLocal); }
Box3 worldBulkBounds(const InstanceList& instances) {
  Box3 box;
  for (const Instance& i : instances) box.extend(worldBulkBounds(i));
  return box;
}

Autofit autofit(const BrickGrid& grid, double target) {
  if (grid.empty()) return {};
  const Box3 bulk = bulkBounds(grid);
  const double span = std::max({bulk.size().x, bulk.size().y, bulk.size().z});
  int level = levelToMeasure(grid);  // finer, where strays have made the grid large
  while (level > 0 && std::exp2(level) * 60 > span) --level;
  std::vector<dvec3> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr int kSpread = 60;  // a spiral on the upper half sphere
  for (int i = 0; i < kSpread; ++i) {
    const double y = (i + 0.5) / kSpread, r = std::sqrt(1 - y * y), phi = i * kPi * (3 - std::sqrt(5.0));
    directions.emplace_back(r * std::cos(phi), y, r * std::sin(phi));
  }
  const dmat4 indexFromWorld = glm::inverse(grid.worldFromIndex);
  const auto median = [&](const dvec3& center) {
    std::vector<double> depths;
    for (const dvec3& d : directions)
      if (const double t = integral(grid, indexFromWorld, center, d, level, bulk); t > 0 && std::isfinite(t))
        depths.push_back(t);
    if (depths.empty()) return 0.0;
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
  };
  double depth = median(bulk.center());
  if (depth == 0) {  // hollow in the middle: through the brick with the largest values
    const Level& l = grid.levels.front();
    const auto most = std::max_element(l.table.begin(), l.table.end(),
                                       [](const Brick& a, const Brick& b) { return a.maximum < b.maximum; });
    const auto i = static_cast<int>(most - l.table.begin());
    const ivec3 brick(i % l.bricks.x, i / l.bricks.x % l.bricks.y, i / l.bricks.x / l.bricks.y);
    depth = median(dvec3(grid.origin) + (dvec3(brick) + 0.5) * double(kBrickSize));
  }
  if (!(depth > 0)) return {};
  return {target / depth, target};
}

double threeDigits(double v) { return v > 0 ? std::stod(fmt::format("{:.3g}", v)) : 0; }

}  // namespace pileus::volume
