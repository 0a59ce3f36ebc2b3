#include "renderer/transport/mixing.h"

#include <algorithm>
#include <cmath>

namespace pileus::transport {
namespace {

double dot(const Vector& a, const Vector& b, const Vector& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(weights[i]) * double(a[i]) * double(b[i]);
  return sum;
}

}  // namespace

void Mixing::next(Vector& x, const Vector& g, const Vector& weights) {
  Vector change(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) change[i] = g[i] - x[i];
  if (!lastChange_.empty()) {
    const std::size_t slot = std::size_t(steps_++ % kHistory);
    if (changes_.size() <= slot) changes_.emplace_back(), results_.emplace_back();
    changes_[slot] = change, results_[slot] = g;
    for (std::size_t i = 0; i < x.size(); ++i)
      changes_[slot][i] -= lastChange_[i], results_[slot][i] -= lastResult_[i];
  }
  lastChange_ = change, lastResult_ = g;
  const std::array<double, kHistory> by = least(change, weights);
  x = g;
  for (std::size_t j = 0; j < changes_.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= float(by[j]) * results_[j][i];
}

/// Least squares by normal equations, a hair regularised.
std::array<double, Mixing::kHistory> Mixing::least(const Vector& change, const Vector& weights) const {
  const std::size_t n = changes_.size();
  double a[kHistory][kHistory + 1] = {};
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = r; c < n; ++c) a[r][c] = a[c][r] = dot(changes_[r], changes_[c], weights);
    a[r][kHistory] = dot(changes_[r], change, weights);
  }
  for (std::size_t r = 0; r < n; ++r) a[r][r] *= 1 + 1e-8;
  std::array<double, kHistory> out{};
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t best = p;
    for (std::size_t r = p; r < n; ++r)
      if (std::abs(a[r][p]) > std::abs(a[best][p])) best = r;
    std::swap_ranges(a[p], a[p] + kHistory + 1, a[best]);
    if (std::abs(a[p][p]) < 1e-300) return {};
    for (std::size_t r = p + 1; r < n; ++r) {
      const double by = a[r][p] / a[p][p];
      for (std::size_t c = p; c <= kHistory; ++c) a[r][c] -= by * a[p][c];
    }
  }
  for (std::size_t p = n; p-- > 0;) {
    double sum = a[p][kHistory];
    for (std::size_t c = p + 1; c < n; ++c) sum -= a[p][c] * out[c];
    out[p] = sum / a[p][p];
  }
  return out;
}

}  // namespace pileus::transport
