#include "renderer/scene/peak.h"

#include <algorithm>
#include <cmath>

namespace pileus::scene {

std::vector<float> scatteredPeaks(const Phase& p, int angles, int depths) {
  // So many moments as count: sharper lobes than those of 3000 are not told apart by so few angles.
  constexpr int kMost = 3000;
  constexpr double kSmall = 1e-5;
  int count = 64;
  std::vector<double> moments = legendreMoments(p, count);
  while (count < kMost && std::abs(moments.back()) > kSmall)
    moments = legendreMoments(p, count = std::min(2 * count, kMost));
  const double forward = scaledPhase(p).forward;
  std::vector<float> out(std::size_t(angles) * std::size_t(depths), 0.0f);
  if (forward <= 0) return out;
  for (std::size_t l = 0; l < moments.size(); ++l) moments[l] = l < 2 ? 1 : moments[l] / forward;
  std::vector<double> weights(moments.size());
  for (int j = 0; j < depths; ++j) {
    const double s = (j + 0.5) / depths, t = kPeakDepth * s / (1 - s);
    for (std::size_t l = 0; l < moments.size(); ++l)
      weights[l] =
          forward / t * (2 * double(l) + 1) / (4 * kPi) * (std::exp(t * (moments[l] - 1)) - std::exp(-t));
    for (int i = 0; i < angles; ++i) {
      const double a = double(i) / (angles - 1), half = a * a, c = 1 - 2 * half * half;
      // Legendre's polynomials, one after the other.
      double before = 1, now = c, sum = weights[0] + weights[1] * c;
      for (std::size_t l = 2; l < weights.size(); ++l) {
        const double next = ((2 * double(l) - 1) * c * now - (double(l) - 1) * before) / double(l);
        before = now, now = next;
        sum += weights[l] * now;
      }
      out[std::size_t(j) * std::size_t(angles) + std::size_t(i)] = float(sum);
    }
  }
  return out;
}

}  // namespace pileus::scene
