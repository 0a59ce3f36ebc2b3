#include "renderer/shadow/metric.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/math.h"

namespace pileus::shadow {

double metricFace(Metric metric, int i, double t) {
  if (i == 0) return metric == Metric::Fourier ? 2 * t : t;
  if (metric == Metric::Cosine) return 2 * std::sin(i * kPi * t) / (i * kPi);
  const double k = (i + 1) / 2, w = 2 * kPi * k * t;
  return (i % 2 == 1 ? std::sin(w) : 1 - std::cos(w)) / (kPi * k);
}

double metricU(Metric metric, std::span<const double> m, double x, std::span<const double> weights) {
  double g = 0, whole = 0;
  switch (metric) {
    case Metric::None:
      return x;
    case Metric::Interval:
      for (std::size_t j = 0; j + 1 < m.size(); j += 2) {
        const double w = weights.empty() ? 1 : weights[j / 2];
        g += w * std::clamp(x - m[j], 0.0, m[j + 1] - m[j]);
        whole += w * (m[j + 1] - m[j]);
      }
      break;
    case Metric::Cosine:
      whole = m[0];
      g = whole * x;
      for (std::size_t k = 1; k < m.size(); ++k)
        g += m[k] * std::sin(kPi * double(k) * x) / (kPi * double(k));
      break;
    case Metric::Fourier:
      whole = 0.5 * m[0];
      g = whole * x;
      for (std::size_t i = 1; i < m.size(); ++i) {
        const double w = 2 * kPi * double((i + 1) / 2);
        g += m[i] * (i % 2 == 1 ? std::sin(w * x) : 1 - std::cos(w * x)) / w;
      }
      break;
  }
  return whole > (metric == Metric::Interval ? 1e-14 : 1e-6) ? std::clamp(g / whole, 0.0, 1.0) : 0.0;
}

Piece pieceOf(std::span<const double> m, double x) {
  Piece p{0, 0, 0};
  for (std::size_t j = 0; j + 1 < m.size(); j += 2) {
    if (!(m[j + 1] > m[j])) continue;
    ++p.count;
    if (j == 0 || m[j] <= x) p.index = int(j / 2);
  }
  const auto j = std::size_t(2 * p.index);
  p.count = std::max(p.count, 1);
  p.v = j + 1 < m.size() ? std::clamp((x - m[j]) / std::max(m[j + 1] - m[j], 1e-9), 0.0, 1.0) : 0;
  return p;
}

}  // namespace pileus::shadow
