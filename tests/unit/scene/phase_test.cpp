// Phase functions against what is known of them: norm, mean cosine, moments, and samples drawn from them.
#include "renderer/scene/phase.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pileus::scene {
namespace {

struct Named {
  std::string name;
  Phase phase;
};

std::vector<Named> all() {
  std::vector<Named> out;
  for (const double g : {-0.9, -0.3, 0.0, 1e-4, 0.6, 0.99})
    out.push_back({fmt::format("hg {}", g), henyeyGreenstein(g)});
  out.push_back({"double hg", doubleHenyeyGreenstein(0.8, -0.4, 0.3)});
  out.push_back({"rayleigh", rayleigh()});
  for (const double g : {-0.5, 0.0, 0.7})
    for (const double alpha : {0.5, 1.0, 30.0})
      out.push_back({fmt::format("draine {} {}", g, alpha), draine(g, alpha)});
  for (const double d : {0.0, 0.05, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0})
    out.push_back({fmt::format("droplets {}", d), droplets(d)});
  return out;
}

/// Integral over directions of p f(cosine). In the angle's logarithm next to both ends, where sharp lobes
/// are.
template <class F>
double integral(const Phase& p, F&& f) {
  constexpr int kSteps = 40000;
  const double lo = std::log(1e-6), hi = std::log(kPi / 2);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = std::exp(lo + (i + 0.5) / kSteps * (hi - lo)), width = angle * (hi - lo) / kSteps;
    const double c = std::cos(angle), ring = 2 * kPi * std::sin(angle) * width;
    sum += ring * (phaseValue(p, c) * f(c) + phaseValue(p, -c) * f(-c));
  }
  return sum;
}

double legendre(int l, double x) {
  double before = 1, now = x;
  if (l == 0) return 1;
  for (int n = 1; n < l; ++n) before = std::exchange(now, ((2 * n + 1) * x * now - n * before) / (n + 1));
  return now;
}

TEST(Phase, IntegralsOverAllDirections) {
  for (const Named& n : all()) {
    SCOPED_TRACE(n.name);
    EXPECT_NEAR(integral(n.phase, [](double) { return 1.0; }), 1, 1e-4);
    EXPECT_NEAR(integral(n.phase, [](double c) { return c; }), meanCosine(n.phase), 1e-4);
    const std::vector<double> moments = legendreMoments(n.phase, 9);
    for (int l = 0; l < 9; ++l)
      EXPECT_NEAR(integral(n.phase, [&](double c) { return legendre(l, c); }), moments[std::size_t(l)], 1e-4)
          << l;
  }
}

/// Figures of the published fit.
TEST(Phase, OfDroplets) {
  const struct {
    double diameter, hg, draine, alpha, blend, mean;
  } known[] = {{2, 0.91808, 0.38749, 11.379, 0.41199, 0.76888},
               {5, 0.97068, 0.50834, 17.068, 0.44783, 0.84342},
               {10, 0.98818, 0.55567, 21.996, 0.48196, 0.86416},
               {20, 0.99461, 0.59379, 27.114, 0.49816, 0.87931}};
  for (const auto& k : known) {
    SCOPED_TRACE(k.diameter);
    const Phase p = droplets(k.diameter);
    EXPECT_NEAR(p.first.g, k.hg, 1e-5);
    EXPECT_NEAR(p.second.g, k.draine, 1e-5);
    EXPECT_NEAR(p.second.alpha, k.alpha, 1e-3);
    EXPECT_NEAR(p.blend, k.blend, 1e-5);
    EXPECT_NEAR(meanCosine(p), k.mean, 1e-5);
  }
  EXPECT_NEAR(meanCosine(droplets(50)), 0.89119, 1e-5);
  EXPECT_NEAR(phaseValue(droplets(10), 1), 587, 1);
  EXPECT_NEAR(phaseValue(droplets(10), -1), 0.0127, 1e-4);
}

TEST(Phase, EveryDropletIsAPhaseFunction) {
  for (double d = 0; d <= kLargestDroplet; d += d < 6 ? 0.01 : 0.5) {
    const Phase p = droplets(d);
    for (const double g : {p.first.g, p.second.g}) EXPECT_LT(std::abs(g), 1) << d;
    EXPECT_GE(p.blend, 0) << d;
    EXPECT_LE(p.blend, 1) << d;
    for (const double c : {-1.0, -0.5, 0.0, 0.5, 1.0}) EXPECT_GT(phaseValue(p, c), 0) << d;
  }
}

/// A million cosines in a hundred bins of the same probability; 1e-4 of all such tests are beyond this.
TEST(Phase, SamplesAreDistributedAsItSays) {
  constexpr int kBins = 100, kSamples = 1000000, kSteps = 100000;
  constexpr double kBeyond = 157.5;  // chi^2 of 99 degrees of freedom
  const std::vector<Named> phases = all();
  for (std::size_t j = 0; j < phases.size(); j += 3) {
    const Named& n = phases[j];
    SCOPED_TRACE(n.name);
    // The cumulative probability over cosines, finely where a lobe is.
    std::vector<double> cosines{-1}, below{0};
    const auto at = [&](int i) {
      const double angle = kPi * i / kSteps, s = std::sin(0.5 * angle);
      return 2 * s * s - 1;
    };
    for (int i = 1; i <= kSteps; ++i) {
      const double c = at(i), before = cosines.back();
      // Simpson's rule within a step.
      const double p = (phaseValue(n.phase, before) + 4 * phaseValue(n.phase, 0.5 * (before + c)) +
                        phaseValue(n.phase, c)) /
                       6;
      cosines.push_back(c);
      below.push_back(below.back() + 2 * kPi * p * (c - before));
    }
    std::mt19937_64 rng(17);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<int> counts(kBins, 0);
    for (int i = 0; i < kSamples; ++i) {
      const double c = sampleCosine(n.phase, [&] { return uniform(rng); });
      const auto next = std::upper_bound(cosines.begin() + 1, cosines.end() - 1, c);
      const std::size_t k = std::size_t(next - cosines.begin());
      const double part = (c - cosines[k - 1]) / (cosines[k] - cosines[k - 1]);
      const double u = (below[k - 1] + part * (below[k] - below[k - 1])) / below.back();
      ++counts[std::size_t(std::clamp(int(u * kBins), 0, kBins - 1))];
    }
    double chi = 0;
    const double expected = double(kSamples) / kBins;
    for (const int count : counts) chi += (count - expected) * (count - expected) / expected;
    EXPECT_LT(chi, kBeyond);
  }
}

TEST(Phase, SharperThanSharpestIsThat) {
  EXPECT_EQ(henyeyGreenstein(1), henyeyGreenstein(kSharpestPhase));
  EXPECT_EQ(draine(-1, 1).first.g, -kSharpestPhase);
  EXPECT_TRUE(std::isfinite(phaseValue(henyeyGreenstein(-1), -1)));
}

}  // namespace
}  // namespace pileus::scene
