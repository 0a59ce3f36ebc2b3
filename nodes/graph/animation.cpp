#include "nodes/graph/animation.h"

#include <algorithm>
#include <cmath>

namespace pileus::nodes {

ParamValue valueAt(const Animation& animation, double frame) {
  const auto& keys = animation.keys;
  const auto next = std::upper_bound(keys.begin(), keys.end(), frame,
                                     [](double f, const AnimationKey& key) { return f < key.frame; });
  if (next == keys.begin()) return keys.front().value;
  const AnimationKey& a = *(next - 1);
  if (next == keys.end() || a.interpolation == Interpolation::Constant ||
      a.value.index() != next->value.index())
    return a.value;
  double t = (frame - a.frame) / (next->frame - a.frame);
  if (a.interpolation == Interpolation::Smooth) t = t * t * (3.0 - 2.0 * t);
  if (const auto* v = std::get_if<double>(&a.value)) return *v + t * (std::get<double>(next->value) - *v);
  if (const auto* v = std::get_if<dvec3>(&a.value)) return *v + t * (std::get<dvec3>(next->value) - *v);
  if (const auto* v = std::get_if<int>(&a.value)) {
    const double from = *v, to = std::get<int>(next->value);
    return static_cast<int>(std::lround(from + t * (to - from)));
  }
  return a.value;
}

}  // namespace pileus::nodes
