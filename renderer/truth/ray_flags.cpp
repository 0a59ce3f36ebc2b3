// What is wrong with a light ray, in words (ray_probe.h).
#include <algorithm>
#include <cmath>

#include "renderer/truth/ray_probe.h"

namespace pileus::truth {
namespace {

using Weight = RayFlag::Weight;
using shadow::ShadowMap;

/// Four digits, never an exponent.
std::string metres(double m) {
  return fmt::format("{:.{}f} m", m,
                     std::abs(m) >= 1000  ? 0
                     : std::abs(m) >= 100 ? 1
                     : std::abs(m) >= 10  ? 2
                                          : 3);
}

constexpr double kVisible = 2e-3;  // of T: half a code value of 8 bits

/// The largest rise of T from a place to a later one between which it never falls by more than what can be
/// seen.
std::optional<RayFlag> rise(const RayProbe& p) {
  double best = 0, from = 0, to = 0, low = 2, lowX = 0;
  for (std::size_t i = 0; i < p.mapped.size(); ++i) {
    const double t = p.mapped[i];
    if (t < low) low = t, lowX = p.x[i];
    if (t - low > best) best = t - low, from = lowX, to = p.x[i];
  }
  if (best < kVisible) return std::nullopt;
  return RayFlag{Weight::Warning, fmt::format("Transmittance rises by {:.2g} between {} and {}.", best,
                                              metres(p.metres(from)), metres(p.metres(to)))};
}

std::optional<RayFlag> negative(const RayProbe& p) {
  const ExtinctionOverU e = extinctionOverU(p);
  if (e.mapped.empty()) return std::nullopt;
  const auto count = std::count_if(e.mapped.begin(), e.mapped.end(), [](double v) { return v < -1e-6; });
  const double share = double(count) / double(e.mapped.size());
  if (share < 0.005) return std::nullopt;
  return RayFlag{Weight::Warning,
                 fmt::format("Extinction is negative on {:.0f} % of g.", std::max(100 * share, 1.0))};
}

int intervalsOf(const shadow::MapTap& tap) {
  int count = 0;
  for (std::size_t j = 0; j + 1 < tap.metric.size(); j += 2)
    count += tap.metric[j + 1] > tap.metric[j] ? 1 : 0;
  return count;
}

bool intervals(const ShadowMap& map) {
  return map.metric && map.metric->block && map.metric->options.metric == shadow::Metric::Interval;
}

std::optional<RayFlag> merged(const RayProbe& p) {
  if (!intervals(*p.map) || p.taps.taps.empty()) return std::nullopt;
  const int kept = intervalsOf(p.taps.taps.front()), there = int(p.covered.size());
  if (there <= kept || kept < p.map->metric->options.intervals) return std::nullopt;
  return RayFlag{Weight::Note, fmt::format("{} intervals are merged into {}.", there, kept)};
}

std::optional<RayFlag> horizon(const RayProbe& p) {
  if (!intervals(*p.map) || !(p.map->metric->options.horizon > 0) || p.taps.taps.empty()) return std::nullopt;
  const std::vector<double>& m = p.taps.taps.front().metric;
  double end = 0;
  for (std::size_t j = 0; j + 1 < m.size(); j += 2)
    if (m[j + 1] > m[j]) end = std::max(end, m[j + 1]);
  const std::size_t at = std::size_t(std::lower_bound(p.x.begin(), p.x.end(), end) - p.x.begin());
  if (at + 1 >= p.x.size()) return std::nullopt;
  const double hidden = std::log(std::max(p.exact[at], 1e-300) / std::max(p.exact.back(), 1e-300));
  if (hidden < 0.01) return std::nullopt;
  return RayFlag{Weight::Note, fmt::format("The horizon hides an optical depth of {:.3g} behind {}.", hidden,
                                           metres(p.metres(end)))};
}

}  // namespace

std::vector<RayFlag> rayFlags(const RayProbe& p) {
  std::vector<RayFlag> out;
  const auto add = [&](std::optional<RayFlag> flag) {
    if (flag) out.push_back(std::move(*flag));
  };
  if (p.parts.empty()) add(RayFlag{Weight::Note, "No medium on this ray."});
  if (p.blocked) add(RayFlag{Weight::Note, "A solid blocks the light here."});
  if (p.map->kind == ShadowMap::Kind::RayMarch) {
    add(RayFlag{Weight::Note,
                fmt::format("Marched in steps of {:.3g} voxels: nothing is approximated but the step.",
                            p.map->stepScale)});
    return out;
  }
  add(rise(p));
  add(negative(p));
  add(merged(p));
  add(horizon(p));
  if (p.taps.taps.size() > 1)
    add(RayFlag{Weight::Note, "At a silhouette: four texels are evaluated each for itself."});
  if (p.map->kind == ShadowMap::Kind::Deep)
    add(RayFlag{Weight::Note, fmt::format("{} vertices keep V within {:.3g}.", p.taps.vertices.size(),
                                          p.map->spec.errorBound)});
  if (out.empty()) add(RayFlag{Weight::Note, "Nothing to remark."});
  return out;
}

}  // namespace pileus::truth
