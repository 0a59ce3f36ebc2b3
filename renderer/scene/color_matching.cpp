#include "renderer/scene/color_matching.h"

#include <cmath>

namespace pileus::scene {
namespace {

/// A bell with a width of its own on each side.
double lobe(double nm, double center, double left, double right) {
  const double t = (nm - center) / (nm < center ? left : right);
  return std::exp(-0.5 * t * t);
}

}  // namespace

dvec3 colorMatching(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

}  // namespace pileus::scene
