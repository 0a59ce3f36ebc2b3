#include "renderer/volume/fire_fit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "renderer/scene/acescg.h"
#include "renderer/volume/autofit.h"
#include "renderer/volume/density_histogram.h"

namespace pileus::volume {
namespace {

constexpr double kCoolest = 1000, kHottest = 2200;  // K, for values without a unit
constexpr int kRays = 48;                           // across each side of the bounds

double luminance(const vec4& rgb) { return scene::acescgLuminance(dvec3(rgb)); }

/// The value below which all but the hottest thousandth of the voxels lie: a few specks of a simulation must
/// not leave the rest dark.
double robustMaximum(const Instance& instance, const JobControl& control) {
  const auto histogram = densityHistogram({instance}, control);
  if (!histogram || histogram->counts.empty()) return 0;
  double all = 0, above = 0;
  for (const double c : histogram->counts) all += c;
  std::size_t bin = histogram->counts.size();
  while (bin > 1 && above + histogram->counts[bin - 1] <= 0.001 * all) above += histogram->counts[--bin];
  return histogram->highest * static_cast<double>(bin) / static_cast<double>(histogram->counts.size());
}

/// A grid, its placement and the mip that is measured.
struct Sampled {
  const BrickGrid& grid;
  dmat4 indexFromWorld = glm::inverse(grid.worldFromIndex);
  int level = levelToMeasure(grid);
  double at(const dvec3& world) const {
    return sampleTrilinear(grid, dvec3(indexFromWorld * dvec4(world, 1)), level);
  }
};

/// Luminance that each of many parallel rays along a world axis gathers, seen from both ends.
void gather(const Sampled& fire, const DensityRemap& emission, const Instance* smoke, int axis,
            std::vector<double>& out) {
  const Box3 bounds = transformed(fire.grid.indexBounds, fire.grid.worldFromIndex);
  Box3 all = bounds;
  if (smoke) all.extend(worldBounds(*smoke));
  std::optional<Sampled> density;
  if (smoke) density.emplace(Sampled{*smoke->grid});
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double length = all.size()[axis], voxel = fire.grid.voxelSize * std::exp2(fire.level);
  const int steps = std::clamp(static_cast<int>(std::ceil(length / voxel)), 16, 512);
  const double ds = length / steps;
  for (int k = 0; k < kRays * kRays; ++k) {
    dvec3 p = all.min;
    p[u] = bounds.min[u] + bounds.size()[u] * (k % kRays + 0.5) / kRays;
    p[v] = bounds.min[v] + bounds.size()[v] * (k / kRays + 0.5) / kRays;
    double front = 0, back = 0, before = 1;
    for (int i = 0; i < steps; ++i) {
      p[axis] = all.min[axis] + (i + 0.5) * ds;
      const double sigma = density ? std::max(density->at(p) * smoke->medium.extinction, 0.0) : 0.0;
      const double j = luminance(vec4(emission.at(fire.at(p)))), step = std::exp(-sigma * ds);
      const double own = j * (sigma * ds > 1e-6 ? (1 - step) / sigma : ds);
      front += before * own;
      back = back * step + own;
      before *= step;
    }
    out.insert(out.end(), {front, back});
  }
}

/// Of the rays that see fire at all, what the brightest twentieth exceeds.
double brighterParts(const BrickGrid& grid, const DensityRemap& emission, const Instance* smoke) {
  std::vector<double> seen;
  for (int axis = 0; axis < 3; ++axis) gather({grid}, emission, smoke, axis, seen);
  const double most = *std::max_element(seen.begin(), seen.end());
  std::erase_if(seen, [&](double s) { return !(s > 0.01 * most); });
  if (seen.empty()) return 0;
  const auto at = seen.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(seen.size() - 1));
  std::nth_element(seen.begin(), at, seen.end());
  return *at;
}

int rank(const GridInfo& g) {
  if (!g.drawable || !(g.maximum > 0)) return 9;
  const GridRole role = roleOfGrid(g.name);
  if (role == GridRole::Temperature) return g.maximum > kLeastKelvins ? 0 : 2;
  return role == GridRole::Flame ? 1 : 9;
}

}  // namespace

const GridInfo* fireGrid(std::span<const GridInfo> grids) {
  const auto best = std::min_element(grids.begin(), grids.end(),
                                     [](const GridInfo& a, const GridInfo& b) { return rank(a) < rank(b); });
  return best == grids.end() || rank(*best) == 9 ? nullptr : &*best;
}

FireFit fitFire(const GridPtr& grid, const JobControl& control, const Instance* smoke, double target) {
  FireFit fit;
  if (!grid || grid->empty()) return fit;
  Instance instance;
  instance.shape = Shape::Grid;
  instance.grid = grid;
  instance.worldFromLocal = grid->worldFromIndex;
  const double most = static_cast<double>(grid->maximum);
  fit.kelvins = most > kLeastKelvins;
  BlackBody& body = fit.range.body;
  if (fit.kelvins) {
    body.hottest = std::clamp(threeDigits(robustMaximum(instance, control)), 600.0, 20000.0);
    body.coolest = 500;
    fit.range.lowest = body.coolest, fit.range.highest = body.hottest;
  } else {
    body.coolest = kCoolest, body.hottest = kHottest;
    fit.range.highest = threeDigits(robustMaximum(instance, control));
  }
  if (!(fit.range.highest > fit.range.lowest)) return fit;
  body.strength = 1;
  const auto straight = [](double part) { return part; };
  const RemapPtr unit = makeEmission(fit.range.lowest, fit.range.highest, straight, body);
  const double seen = brighterParts(*grid, *unit, smoke);
  if (!(seen > 0) || !std::isfinite(seen)) return fit;
  // Smoke may hide it nearly whole: it is not made so strong that its edges blaze through.
  const double bare = smoke ? brighterParts(*grid, *unit, nullptr) : seen;
  body.strength = std::clamp(threeDigits(std::min(target / seen, 10 * target / bare)), 1e-6, 1e6);
  fit.brightness = seen * body.strength;
  return fit;
}

std::string fireNote(const FireRange& range, double most) {
  const bool same = range.lowest == range.body.coolest && range.highest == range.body.hottest;
  if (most > kLeastKelvins && same)
    return fmt::format("The values, up to {:.4g}, are taken as kelvins (likely)", most);
  std::string text = fmt::format("Values {:.3g} to {:.3g} become {:.4g} to {:.4g} K", range.lowest,
                                 range.highest, range.body.coolest, range.body.hottest);
  if (most > kLeastKelvins)
    text +=
        "; they look like kelvins: for those give input_min and coolest, and input_max and hottest, "
        "the same numbers";
  return text;
}

}  // namespace pileus::volume
