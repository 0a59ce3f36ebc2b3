#include "renderer/volume/remap.h"

#include <algorithm>
#include <cmath>

namespace pileus::volume {

dvec4 DensityRemap::at(double density) const {
  const double place =
      std::clamp((density - lowest) / (highest - lowest) * (kRemapEntries - 1), 0.0, kRemapEntries - 1.0);
  const auto i = std::min(static_cast<std::size_t>(place), std::size_t(kRemapEntries - 2));
  return glm::mix(dvec4(entries[i]), dvec4(entries[i + 1]), place - static_cast<double>(i));
}

double DensityRemap::largest(double from, double to) const {
  double most = std::max(density(from), density(to));
  for (int i = 0; i < kRemapEntries; ++i) {
    const double d = lowest + (highest - lowest) * i / (kRemapEntries - 1);
    if (d > from && d < to)
      most = std::max(most, static_cast<double>(entries[static_cast<std::size_t>(i)].a));
  }
  return most;
}

namespace {

double emptyUpTo(double lowest, double highest, const std::vector<vec4>& entries) {
  const auto first = std::find_if(entries.begin(), entries.end(), [](const vec4& e) { return e.a > 0; });
  if (first == entries.end()) return std::numeric_limits<double>::infinity();
  if (first == entries.begin()) return -std::numeric_limits<double>::infinity();
  const auto zeros = static_cast<double>(first - entries.begin());
  return lowest + (highest - lowest) * (zeros - 1) / (kRemapEntries - 1);
}

}  // namespace

RemapPtr makeRemap(double lowest, double highest, std::vector<vec4> of) {
  const double empty = emptyUpTo(lowest, highest, of);
  DensityRemap remap{lowest, highest, std::move(of), empty, {}};
  Hasher h;
  h.add(lowest).add(highest);
  for (const vec4& e : remap.entries) h.add(e.r).add(e.g).add(e.b).add(e.a);
  remap.content = h.key();
  return std::make_shared<const DensityRemap>(std::move(remap));
}

RemapPtr composed(const RemapPtr& first, const RemapPtr& then) {
  if (!first || !then) return first ? first : then;
  std::vector<vec4> entries;
  for (const vec4& e : first->entries) {
    const vec4 next(then->at(static_cast<double>(e.a)));
    entries.emplace_back(vec3(e) * vec3(next), next.a);
  }
  return makeRemap(first->lowest, first->highest, std::move(entries));
}

}  // namespace pileus::volume
