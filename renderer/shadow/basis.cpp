#include "renderer/shadow/basis.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/math.h"

namespace pileus::shadow {
namespace {

double sinc(double x) { return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x; }

}  // namespace

void projectStep(Basis basis, std::span<double> c, double m, double u0, double u1) {
  const double mid = 0.5 * (u0 + u1), half = 0.5 * (u1 - u0);
  const auto n = c.size();
  switch (basis) {
    case Basis::Piecewise:  // over a single interval
    case Basis::Cosine:
      c[0] += m;
      for (std::size_t k = 1; k < n; ++k)
        c[k] += 2 * m * std::cos(kPi * double(k) * mid) * sinc(kPi * double(k) * half);
      break;
    case Basis::Fourier:
      c[0] += 2 * m;
      for (std::size_t i = 1; i < n; ++i) {
        const double w = 2 * kPi * double((i + 1) / 2);
        c[i] += 2 * m * (i % 2 == 1 ? std::cos(w * mid) : std::sin(w * mid)) * sinc(w * half);
      }
      break;
    case Basis::Slab: {
      const double lo = std::clamp(u0, 0.0, 1.0) * double(n), hi = std::clamp(u1, 0.0, 1.0) * double(n);
      if (hi - lo < 1e-6) {
        c[std::min(std::size_t(lo), n - 1)] += m;
      } else {
        for (std::size_t j = 0; j < n; ++j)
          c[j] += m * std::max(std::min(hi, double(j + 1)) - std::max(lo, double(j)), 0.0) / (hi - lo);
      }
    }
  }
}

double basisTotal(Basis basis, std::span<const double> c) {
  if (basis == Basis::Cosine || basis == Basis::Piecewise) return c[0];
  if (basis == Basis::Fourier) return 0.5 * c[0];
  double sum = 0;
  for (const double h : c) sum += h;
  return sum;
}

double basisValue(Basis basis, std::span<const double> c, double u) {
  const auto n = c.size();
  double value = 0;
  switch (basis) {
    case Basis::Piecewise:  // over a single interval
    case Basis::Cosine:
      for (std::size_t k = 0; k < n; ++k) value += c[k] * std::cos(kPi * double(k) * u);
      break;
    case Basis::Fourier:
      value = 0.5 * c[0];
      for (std::size_t i = 1; i < n; ++i) {
        const double w = 2 * kPi * double((i + 1) / 2) * u;
        value += c[i] * (i % 2 == 1 ? std::cos(w) : std::sin(w));
      }
      break;
    case Basis::Slab:
      value = c[std::min(std::size_t(std::max(u, 0.0) * double(n)), n - 1)] * double(n);
      break;
  }
  return value;
}

double basisTau(Basis basis, std::span<const double> c, double u) {
  const auto n = c.size();
  double tau = 0;
  switch (basis) {
    case Basis::Piecewise:  // over a single interval
    case Basis::Cosine:
      tau = c[0] * u;
      for (std::size_t k = 1; k < n; ++k) tau += c[k] * std::sin(kPi * double(k) * u) / (kPi * double(k));
      break;
    case Basis::Fourier:
      tau = 0.5 * c[0] * u;
      for (std::size_t i = 1; i < n; ++i) {
        const double w = 2 * kPi * double((i + 1) / 2);
        tau += c[i] * (i % 2 == 1 ? std::sin(w * u) : 1 - std::cos(w * u)) / w;
      }
      break;
    case Basis::Slab:
      for (std::size_t j = 0; j < n; ++j)
        tau += c[j] * std::clamp(std::clamp(u, 0.0, 1.0) * double(n) - double(j), 0.0, 1.0);
      return tau;
  }
  return std::clamp(tau, 0.0, std::max(basisTotal(basis, c), 0.0));
}

void projectPiece(std::span<double> c, double m, int count, int j, double v0, double v1) {
  const double mid = 0.5 * (v0 + v1), half = 0.5 * (v1 - v0);
  for (std::size_t i = std::size_t(j); i < c.size(); i += std::size_t(count)) {
    const double k = double(i / std::size_t(count));
    c[i] += k == 0 ? m : 2 * m * std::cos(kPi * k * mid) * sinc(kPi * k * half);
  }
}

double pieceTau(std::span<const double> c, int count, int j, double v) {
  double before = 0, within = 0;
  for (std::size_t i = 0; i < std::min(std::size_t(j), c.size()); ++i) before += c[i];
  for (std::size_t i = std::size_t(j); i < c.size(); i += std::size_t(count)) {
    const double k = double(i / std::size_t(count));
    within += k == 0 ? c[i] * v : c[i] * std::sin(kPi * k * v) / (kPi * k);
  }
  return before + std::clamp(within, 0.0, std::size_t(j) < c.size() ? std::max(c[std::size_t(j)], 0.0) : 0.0);
}

}  // namespace pileus::shadow
