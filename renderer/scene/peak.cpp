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
  const std::size_t terms = moments.size();
  std::vector<double> weights(terms * std::size_t(depths));  // of each term, depth by depth
  for (int j = 0; j < depths; ++j) {
    const double s = double(j) / depths, t = kPeakDepth * s / (1 - s);
    for (std::size_t l = 0; l < terms; ++l)
      weights[l * std::size_t(depths) + std::size_t(j)] =
          forward * (2 * double(l) + 1) / (4 * kPi) * std::exp(-t) *
          (t > 0 ? std::expm1(t * moments[l]) / t : moments[l]);
  }
  std::vector<double> sums(static_cast<std::size_t>(depths));
  for (int i = 0; i < angles; ++i) {
    const double a = double(i) / (angles - 1), half = a * a, c = 1 - 2 * half * half;
    std::fill(sums.begin(), sums.end(), 0.0);
    // Legendre's polynomials, one after the other.
    double before = 0, now = 1;
    for (std::size_t l = 0; l < terms; ++l) {
      for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += weights[l * sums.size() + j] * now;
      const double next = ((2 * double(l) + 1) * c * now - double(l) * before) / (double(l) + 1);
      before = now, now = next;
    }
    for (std::size_t j = 0; j < sums.size(); ++j)
      out[j * std::size_t(angles) + std::size_t(i)] = float(sums[j]);
  }
  return out;
}

}  // namespace pileus::scene
