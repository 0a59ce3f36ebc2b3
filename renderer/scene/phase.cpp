#include "renderer/scene/phase.h"

#include <algorithm>
#include <cmath>

namespace pileus::scene {
namespace {

double clamped(double g) { return std::clamp(g, -kSharpestPhase, kSharpestPhase); }

/// What a lobe's factor 1 + a c^2 is on average.
double normOf(const PhaseLobe& l) { return 1 + l.alpha * (1 + 2 * l.g * l.g) / 3; }

/// 1 + g^2 - 2 g c as a sum of what cannot cancel, for g next to 1 or -1.
double lobeValue(const PhaseLobe& l, double cosine) {
  const double a = std::abs(l.g), off = l.g < 0 ? 1 + cosine : 1 - cosine;
  const double d = (1 - a) * (1 - a) + 2 * a * std::max(off, 0.0);
  return (1 - a) * (1 + a) / (4 * kPi * d * std::sqrt(d)) * (1 + l.alpha * cosine * cosine) / normOf(l);
}

double lobeMeanCosine(const PhaseLobe& l) {
  return l.g * (1 + l.alpha * (3 + 2 * l.g * l.g) / 5) / normOf(l);
}

/// Of Henyey and Greenstein's lobe the moments are g^l; c P_l is a blend of P_(l+1) and P_(l-1).
double lobeMoment(const PhaseLobe& l, int order) {
  const auto up = [](int n) { return (n + 1.0) / (2 * n + 1); };
  const auto down = [](int n) { return n / (2.0 * n + 1); };
  const double n = std::pow(l.g, order);
  double square = up(order) * (up(order + 1) * std::pow(l.g, order + 2) + down(order + 1) * n);
  if (order >= 1) square += down(order) * up(order - 1) * n;
  if (order >= 2) square += down(order) * down(order - 1) * std::pow(l.g, order - 2);
  return (n + l.alpha * square) / normOf(l);
}

}  // namespace

Phase henyeyGreenstein(double g) { return {{clamped(g), 0}, {}, 0}; }

Phase doubleHenyeyGreenstein(double forward, double back, double blend) {
  return {{clamped(forward), 0}, {clamped(back), 0}, std::clamp(blend, 0.0, 1.0)};
}

Phase rayleigh() { return {{0, 1}, {}, 0}; }

Phase draine(double g, double alpha) { return {{clamped(g), std::max(alpha, 0.0)}, {}, 0}; }

Phase droplets(double diameter) {
  const double d = std::clamp(diameter, 0.0, kLargestDroplet), ln = std::log(std::max(d, 1e-30));
  if (d >= 5)
    return {{std::exp(-0.0990567 / (d - 1.67154)), 0},
            {std::exp(-2.20679 / (d + 3.91029) - 0.428934), std::exp(3.62489 - 8.29288 / (d + 5.52825))},
            std::exp(-0.599085 / (d - 0.641583) - 0.665888)};
  if (d >= 1.5)
    return {{0.0604931 * std::log(ln) + 0.940256, 0},
            {0.500411 - 0.081287 / (-2 * ln + std::tan(ln) + 1.27551), 7.30354 * ln + 6.31675},
            0.026914 * (ln - std::cos(5.68947 * (std::log(ln) - 0.0292149))) + 0.3764};
  if (d > 0.1)
    return {{0.862 - 0.143 * ln * ln, 0},
            {0.379685 * std::cos(1.19692 *
                                     std::cos((ln - 0.238604) * (ln + 1.00667) / (0.507522 - 0.15677 * ln)) +
                                 1.37932 * ln + 0.0625835) +
                 0.344213,
             250},
            0.146209 * std::cos(3.38707 * ln + 2.11193) + 0.316072 + 0.0778917 * ln};
  return {{13.8 * d * d, 0},
          {1.1456 * d * std::sin(9.29044 * d), 250},
          std::max(0.252977 - 312.983 * std::pow(d, 4.3), 0.0)};
}

double phaseValue(const Phase& p, double cosine) {
  return (1 - p.blend) * lobeValue(p.first, cosine) + p.blend * lobeValue(p.second, cosine);
}

double meanCosine(const Phase& p) {
  return (1 - p.blend) * lobeMeanCosine(p.first) + p.blend * lobeMeanCosine(p.second);
}

std::vector<double> legendreMoments(const Phase& p, int count) {
  std::vector<double> out;
  for (int l = 0; l < count; ++l)
    out.push_back((1 - p.blend) * lobeMoment(p.first, l) + p.blend * lobeMoment(p.second, l));
  return out;
}

double henyeyGreensteinCosine(double g, double u) {
  const double q = 2 * u - 1;
  // (1 + g^2 - ((1 - g^2)/(1 + g q))^2)/(2 g), multiplied out: g = 0 is no other case.
  const double s = 1 + g * q, c = (q * (1 + g * g) * (2 + g * q) + g * (3 - g * g)) / (2 * s * s);
  return std::clamp(c, -1.0, 1.0);
}

ScaledPhase scaledPhase(const Phase& p) {
  const std::vector<double> moments = legendreMoments(p, 3);
  const double forward = std::clamp(moments[2], 0.0, 0.9999), rest = (moments[1] - forward) / (1 - forward);
  // What scatters back has no forward peak.
  if (rest < -1.0 / 3) return {0, moments[1]};
  return {forward, std::min(rest, 1.0)};
}

}  // namespace pileus::scene
