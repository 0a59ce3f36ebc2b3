#include "renderer/view/march_cost.h"

#include <algorithm>
#include <cmath>

#include "renderer/shaders/shared/resume.h"

namespace pileus::view {
namespace {

// Iterations of one lookup in a stored shadow: four texels, and of a deep map a binary search in each.
constexpr double kLookup = 8, kDeepLookup = 64;

/// The longest way through a volume, metres.
double longestWay(const volume::Instance& i) {
  const Box3 local = volume::localBounds(i);
  const dvec3 size = local.max - local.min;
  double longest = 0;
  for (const double y : {-1.0, 1.0})
    for (const double z : {-1.0, 1.0})
      longest = std::max(longest, glm::length(dvec3(i.worldFromLocal * dvec4(size * dvec3(1, y, z), 0))));
  return longest;
}

/// Camera steps in volume i.
double cameraSteps(const RenderOptions& o, const volume::Instance& i) {
  const double way = longestWay(i);
  const dvec3 centre(i.worldFromLocal * dvec4(volume::localBounds(i).center(), 1));
  const double nearest = std::max(glm::length(centre - o.camera.eye) - 0.5 * way, 0.0);
  const double footprint =
      i.shape == volume::Shape::Grid ? 2 * std::tan(glm::radians(o.camera.fov) / 2) / o.size.y * nearest : 0;
  return 1 + way / (std::max(volume::detailSize(i), footprint) * o.stepScale);
}

double shadowCost(const shadow::ShadowMap& shadow) {
  using Kind = shadow::ShadowMap::Kind;
  if (shadow.kind != Kind::RayMarch) return shadow.kind == Kind::Deep ? kDeepLookup : kLookup;
  double sum = 0;
  for (const volume::Instance& i : shadow.volumes) {
    if (i.emission) continue;
    const double steps =
        i.shape == volume::Shape::Grid ? longestWay(i) / (volume::detailSize(i) * shadow.stepScale) : 1;
    sum += 2 + std::clamp(steps, 1.0, double(MARCH_MOST_STEPS)) / MARCH_UNROLL;
  }
  return sum;
}

/// Of asking all of these lights once, iterations.
struct LightsCost {
  double fixed = 0, marched = 0;  ///< of lookups and solids, and of shadow marches
  double local = 0;               ///< number of those that are no suns
};

LightsCost costOf(std::span<const shadow::ShadowedLight> lights) {
  LightsCost out;
  for (const shadow::ShadowedLight& l : lights) {
    out.fixed += 2;
    if (l.light.kind != scene::LightKind::Sun) out.local += 1;
    if (!l.shadow) continue;
    out.fixed += double(l.shadow->solids.size());
    (l.shadow->kind == shadow::ShadowMap::Kind::RayMarch ? out.marched : out.fixed) += shadowCost(*l.shadow);
  }
  return out;
}

/// The largest sum over the volumes of one tile.
double mostInTile(ivec2 size, std::span<const residency::PixelBounds> bounds,
                  const std::vector<double>& values) {
  constexpr int kTile = residency::TileLists::kTile;
  const ivec2 grid = (size + kTile - 1) / kTile;
  std::vector<double> tiles(std::size_t(grid.x) * std::size_t(grid.y), 0.0);
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const ivec2 lo = glm::max(bounds[i].min, ivec2(0)), hi = glm::min(bounds[i].max, size);
    if (lo.x >= hi.x || lo.y >= hi.y) continue;
    for (int y = lo.y / kTile; y <= (hi.y - 1) / kTile; ++y)
      for (int x = lo.x / kTile; x <= (hi.x - 1) / kTile; ++x)
        tiles[std::size_t(y * grid.x + x)] += values[i];
  }
  return tiles.empty() ? 0 : *std::max_element(tiles.begin(), tiles.end());
}

}  // namespace

residency::MarchCost marchCost(const RenderOptions& o, std::span<const volume::Instance> volumes,
                               std::span<const residency::PixelBounds> bounds, int longest,
                               const LightSet& lights) {
  std::vector<double> steps;
  for (const volume::Instance& i : volumes) steps.push_back(cameraSteps(o, i));
  const double stretches = 2.0 * longest + 1;
  // Where steps are cut for what is dense they are looked at up to three times; all the optical depth that
  // matters takes a few dozen of them, and each run of steps begins with a sample more.
  constexpr double kDenseSteps = 64, kDense = 0.7;
  const bool dense = std::any_of(volumes.begin(), volumes.end(), [&](const volume::Instance& i) {
    return volume::majorant(i) * volume::detailSize(i) * std::max(o.stepScale, 2.0) > kDense;
  });
  const double most = kDenseSteps + (dense ? 3 : 1) * std::min(mostInTile(o.size, bounds, steps) + stretches,
                                                               STRETCH_MOST_STEPS * stretches);
  const auto [lookups, shadows, local] = costOf(lights.selected());
  double fixed = 2 + lookups;
  const double overflow = longest > residency::kInRegisters ? longest : 0;
  fixed += overflow * double(lights.selected().size());
  residency::MarchCost cost;
  cost.stretch = longest + 2;
  // A near light's place is looked at before each step, and the phase function at some angles towards it.
  constexpr double kAngles = 32;
  if (local > 0) fixed += double(lights.selected().size());
  cost.step = int(overflow + (local > 0 ? double(lights.selected().size()) : 0)) + 1;
  cost.sample = int(fixed) + int(lights.drawnSolids());
  cost.pixel = stretches * cost.stretch + (most + 1) * (cost.step + cost.sample + shadows) +
               stretches * kAngles * local;
  return cost;
}

residency::MarchCost gatherCost(const LightSet& lights) {
  const LightsCost all = costOf(lights.lights());
  const double fixed = 2 + double(lights.drawnVolumes()) + all.fixed;
  residency::MarchCost cost;
  cost.sample = int(fixed);
  cost.pixel = fixed + all.marched;
  return cost;
}

}  // namespace pileus::view
