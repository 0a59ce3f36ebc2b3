#include "renderer/volume/density_histogram.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pileus::volume {
namespace {

constexpr std::size_t kBins = 256, kMostBricks = 512;
constexpr double kBrickVoxels = double(kBrickSize) * kBrickSize * kBrickSize;

class Counter {
 public:
  explicit Counter(DensityHistogram& out) : out_(out) {}
  void add(double density, double voxels) {
    if (!(density > 0) || !(out_.highest > 0)) return;
    const double bin = std::min(density / out_.highest * kBins, kBins - 1.0);
    out_.counts[static_cast<std::size_t>(bin)] += voxels;
  }

 private:
  DensityHistogram& out_;
};

/// A brick's own voxels by their byte.
std::array<double, 256> byteCounts(std::span<const std::byte> payload) {
  std::array<double, 256> counts{};
  for (int z = 0; z < kBrickSize; ++z)
    for (int y = 0; y < kBrickSize; ++y) {
      const int row = ((z + kApron) * kStoredSize + y + kApron) * kStoredSize + kApron;
      for (int x = 0; x < kBrickSize; ++x)
        ++counts[std::to_integer<std::size_t>(payload[static_cast<std::size_t>(row + x)])];
    }
  return counts;
}

const Level& coarseEnough(const BrickGrid& grid, double& voxels) {
  std::size_t level = 0;
  const auto stored = [&] {
    return std::count_if(grid.levels[level].table.begin(), grid.levels[level].table.end(),
                         [](const Brick& b) { return b.payload != kConstantBrick; });
  };
  while (level + 1 < grid.levels.size() && static_cast<std::size_t>(stored()) > kMostBricks) ++level;
  voxels = std::pow(8.0, static_cast<double>(level));
  return grid.levels[level];
}

bool addGrid(const Instance& i, const JobControl& control, Counter& counter) {
  double voxels = 1;  // of level 0 for each of the level
  const auto density = [&](double d) { return i.remap ? i.remap->density(d) : d; };
  for (const Brick& b : coarseEnough(*i.grid, voxels).table) {
    if (control.cancelled()) return false;
    const double offset = static_cast<double>(b.offset), scale = static_cast<double>(b.scale);
    if (b.payload == kConstantBrick) {
      counter.add(density(offset), kBrickVoxels * voxels);
      continue;
    }
    const auto counts = byteCounts(i.grid->bytes(b));
    for (std::size_t v = 0; v < counts.size(); ++v)
      if (counts[v] > 0)
        counter.add(density(offset + scale * static_cast<double>(v) / 255), counts[v] * voxels);
  }
  return true;
}

}  // namespace

double DensityHistogram::between(double from, double to) const {
  if (!(highest > 0) || counts.empty()) return 0;
  const double perDensity = static_cast<double>(counts.size()) / highest;
  const double lo = std::max(from * perDensity, 0.0), hi = std::min(to * perDensity, double(counts.size()));
  double sum = 0;
  for (double at = lo; at < hi;) {
    const double end = std::min(std::floor(at) + 1, hi);
    sum += counts[static_cast<std::size_t>(at)] * (end - at);
    at = end;
  }
  return sum;
}

std::optional<DensityHistogram> densityHistogram(const InstanceList& instances, const JobControl& control) {
  DensityHistogram out;
  out.counts.assign(kBins, 0);
  for (const Instance& i : instances) out.highest = std::max(out.highest, largestDensity(i));
  Counter counter(out);
  for (const Instance& i : instances) {
    if (i.shape != Shape::Grid)
      counter.add(i.density, 64.0 * 64 * 64 * (i.shape == Shape::Ball ? kPi / 6 : 1));
    else if (i.grid && !i.grid->empty() && !addGrid(i, control, counter))
      return std::nullopt;
  }
  return out;
}

}  // namespace pileus::volume
