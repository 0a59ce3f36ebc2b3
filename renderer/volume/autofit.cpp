#include "renderer/volume/autofit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pileus::volume {
namespace {

/// Integral of the density [unit x m] along the line through `center` (index coordinates) in a world
/// direction.
double integral(const BrickGrid& grid, const dmat4& indexFromWorld, const dvec3& center,
                const dvec3& direction, int level) {
  const dvec3 d = dvec3(indexFromWorld * dvec4(direction, 0.0));
  const auto inside = intersectBox(center, d, grid.indexBounds.min, grid.indexBounds.max);
  if (!inside) return 0;
  const double length = inside->y - inside->x;  // metres: the direction has length 1 in the world
  const int steps = std::clamp(static_cast<int>(2 * length * glm::length(d) / std::exp2(level)), 16, 4096);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    sum += std::max(0.0, sampleTrilinear(grid, center + d * (inside->x + length * (i + 0.5) / steps), level));
  return sum * length / steps;
}

}  // namespace

int levelToMeasure(const BrickGrid& grid) {
  const auto longest = [](const Level& l) { return std::max({l.bricks.x, l.bricks.y, l.bricks.z}); };
  int level = 0;
  while (level + 1 < static_cast<int>(grid.levels.size()) && longest(grid.levels[std::size_t(level)]) > 8)
    ++level;
  return level;
}

Autofit autofit(const BrickGrid& grid, double target) {
  if (grid.empty()) return {};
  const int level = levelToMeasure(grid);
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
      if (const double t = integral(grid, indexFromWorld, center, d, level); t > 0 && std::isfinite(t))
        depths.push_back(t);
    if (depths.empty()) return 0.0;
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
  };
  double depth = median(grid.indexBounds.center());
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
