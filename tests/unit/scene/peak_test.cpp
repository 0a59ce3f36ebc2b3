// What is scattered within peaks alone: its limits, and how much of it there is in all directions.
#include "renderer/scene/peak.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pileus::scene {
namespace {

constexpr int kAngles = 64, kDepths = 24;

double depthOf(int j) {
  const double s = double(j) / kDepths;
  return kPeakDepth * s / (1 - s);
}
double cosineOf(int i) { return 1 - 2 * std::pow(double(i) / (kAngles - 1), 4); }

/// Over all directions, linear in between as it is looked up.
double integral(const std::vector<float>& table, int j) {
  constexpr int kSteps = 200000;
  double sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    // Evenly in the table's angle, in which dcos = 8 a^3 da.
    const double a = (k + 0.5) / kSteps, at = a * (kAngles - 1);
    const int i = std::min(int(at), kAngles - 2);
    const std::size_t e = std::size_t(j * kAngles + i);
    const double v = double(table[e]) + (at - i) * (double(table[e + 1]) - double(table[e]));
    sum += v * 8 * a * a * a / kSteps;
  }
  return 2 * kPi * sum;
}

TEST(ScatteredPeaks, HoldAllThatPeaksScatter) {
  for (const Phase& p : {henyeyGreenstein(0.3), henyeyGreenstein(0.6), henyeyGreenstein(0.85),
                         doubleHenyeyGreenstein(0.8, -0.3, 0.2), rayleigh(), draine(0.5, 1)}) {
    const std::vector<float> table = scatteredPeaks(p, kAngles, kDepths);
    for (const int j : {0, 5, 12, 20}) {
      const double t = depthOf(j), right = scaledPhase(p).forward * (t > 0 ? (1 - std::exp(-t)) / t : 1);
      EXPECT_NEAR(integral(table, j) / right, 1, 0.01) << meanCosine(p) << " " << t;
    }
  }
}

TEST(ScatteredPeaks, AreWhatThePhaseFunctionHasWhereNothingWasPassed) {
  const Phase p = henyeyGreenstein(0.7);
  const ScaledPhase s = scaledPhase(p);
  const std::vector<float> table = scatteredPeaks(p, kAngles, kDepths);  // none at first
  for (int i = 0; i < kAngles; ++i) {
    const double c = cosineOf(i), smooth = (1 - s.forward) * (1 + 3 * s.cosine * c) / (4 * kPi);
    EXPECT_NEAR(double(table[std::size_t(i)]), phaseValue(p, c) - smooth, 2e-3 * phaseValue(p, 1)) << c;
  }
}

TEST(ScatteredPeaks, NoneWhereNothingGoesStraightOn) {
  for (const float v : scatteredPeaks(henyeyGreenstein(0), kAngles, kDepths)) EXPECT_EQ(v, 0);
}

TEST(ScatteredPeaks, NoneOfWhatIsScatteredBack) {
  for (const double g : {-0.5, -0.9, -0.99}) {
    EXPECT_EQ(scaledPhase(henyeyGreenstein(g)).forward, 0);
    EXPECT_NEAR(scaledPhase(henyeyGreenstein(g)).cosine, g, 1e-12);
  }
  EXPECT_NEAR(scaledPhase(henyeyGreenstein(0.6)).forward, 0.36, 1e-12);
  EXPECT_NEAR(scaledPhase(henyeyGreenstein(0.6)).cosine, 0.375, 1e-12);
}

TEST(ScatteredPeaks, AreFiniteForTheSharpestLobes) {
  for (const Phase& p : {henyeyGreenstein(kSharpestPhase), henyeyGreenstein(-0.99), droplets(10)})
    for (const float v : scatteredPeaks(p, kAngles, kDepths)) ASSERT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace pileus::scene
