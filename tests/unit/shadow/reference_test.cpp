// The reference against closed forms and symmetries.
#include "renderer/shadow/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/support/support.h"
#include "tests/unit/shadow/reference_scenes.h"

namespace pileus::shadow {
namespace {

/// All crossings of integer planes, sorted, and three Gauss points between each two: exact too, and built
/// from point samples. Only inside the bounds: random bytes are not 0 in the near apron, where a built grid
/// is.
double byCrossings(const Instance& i, const dvec3& from, const dvec3& to) {
  const dmat4 local = glm::inverse(i.worldFromLocal);
  const dvec3 o(local * dvec4(from, 1)), e(local * dvec4(to, 1));
  const Box3 bounds = volume::localBounds(i);
  const auto hit = intersectBox(o, e - o, bounds.min, bounds.max);
  if (!hit) return 0;
  std::vector<double> t{std::clamp(hit->x, 0.0, 1.0), std::clamp(hit->y, 0.0, 1.0)};
  for (int a = 0; a < 3; ++a)
    for (double p = bounds.min[a]; p <= bounds.max[a] && o[a] != e[a]; ++p)
      t.push_back(std::clamp((p - o[a]) / (e[a] - o[a]), t[0], t[1]));
  std::sort(t.begin(), t.end());
  double tau = 0;
  for (std::size_t k = 1; k < t.size(); ++k) {
    const double m = 0.5 * (t[k] + t[k - 1]), h = 0.5 * (t[k] - t[k - 1]), g = std::sqrt(0.6) * h;
    const auto sigma = [&](double at) { return volume::sigmaAt(i, from + (to - from) * at); };
    if (h > 1e-12)
      tau += h / 9 * (5 * sigma(m - g) + 8 * sigma(m) + 5 * sigma(m + g)) * glm::length(to - from);
  }
  return tau;
}

TEST(Reference, ChordsOfBoxAndBallAreExact) {
  Random random{std::mt19937_64(1)};
  const dvec3 size(2, 3, 5), centre(1, -2, 4);
  const Instance box = shape(Shape::Box, composeTransform(centre, dvec3(0), size), 0.7);
  const Instance ball = shape(Shape::Ball, composeTransform(centre, dvec3(0), dvec3(2.5)), 0.7);
  int hits = 0;
  for (int k = 0; k < 2000; ++k) {
    const dvec3 a = random.point(centre - 8.0, centre + 8.0), b = random.point(centre - 8.0, centre + 8.0);
    // Test 7 of a sphere: tau = 2 sigma sqrt(r^2 - rho^2) for the line; clipped to the segment here.
    const dvec3 d = glm::normalize(b - a);
    const double along = glm::dot(centre - a, d), rho2 = glm::dot(centre - a, centre - a) - along * along;
    const double half = std::sqrt(std::max(0.0, 6.25 - rho2)), length = glm::length(b - a);
    const double chord = std::max(0.0, std::min(length, along + half) - std::max(0.0, along - half));
    ASSERT_NEAR(opticalDepth({ball}, a, b), 0.7 * chord, 1e-12);
    const auto hit = intersectBox(a, d, centre - size / 2.0, centre + size / 2.0);
    const double inside = hit ? std::max(0.0, std::min(hit->y, length) - std::max(hit->x, 0.0)) : 0.0;
    ASSERT_NEAR(opticalDepth({box}, a, b), 0.7 * inside, 1e-12);
    hits += chord > 0 && inside > 0;
  }
  EXPECT_GT(hits, 200);
  EXPECT_EQ(opticalDepth({}, dvec3(0), dvec3(1)), 0);
  EXPECT_EQ(opticalDepth({box, ball}, centre, centre), 0);
  EXPECT_EQ(opticalDepth({shape(Shape::Box, glm::scale(dmat4(1), dvec3(1, 0, 1)), 1)}, dvec3(-1), dvec3(1)),
            0)
      << "flat";
  // Along an axis, starting inside.
  EXPECT_NEAR(opticalDepth({box}, centre, centre + dvec3(0, 0, 9)), 0.7 * 2.5, 1e-15);
}

TEST(Reference, LinearRampIsExact) {
  // sigma = a x, in bytes without rounding: brick b holds a (16 b - 1 + byte).
  const double a = 1.0 / 64;
  const GridPtr grid = gridOfBytes(
      ivec3(4, 2, 2),
      [&](ivec3 b) {
        volume::Brick brick;
        brick.offset = float(a * (16 * b.x - 1));
        brick.scale = float(255 * a);
        return brick;
      },
      [](ivec3, ivec3 local) { return unsigned(local.x + 1); });
  const InstanceList list{placed(grid, dmat4(1.0))};
  for (const double x : {0.25, 1.0, 15.5, 16.0, 33.3, 64.0})
    EXPECT_NEAR(opticalDepth(list, dvec3(0, 7.3, 5.1), dvec3(x, 7.3, 5.1)), a * x * x / 2,
                1e-12 * (1 + x * x));
  Random random{std::mt19937_64(2)};
  for (int k = 0; k < 1000; ++k) {
    const dvec3 p = random.point(dvec3(0), dvec3(64, 32, 32)), q = random.point(dvec3(0), dvec3(64, 32, 32));
    ASSERT_NEAR(opticalDepth(list, p, q), a * 0.5 * (p.x + q.x) * glm::length(q - p), 1e-11);
  }
}

TEST(Reference, RandomBricksMatchAnExactIntegralOfPointSamples) {
  const GridPtr grid = randomGrid(ivec3(3, 4, 2), 5);
  const Instance i = placed(grid, kTilted, 0.8);
  const Box3 bounds = volume::worldBounds(i);
  Random random{std::mt19937_64(6)};
  double largest = 0;
  for (int k = 0; k < 300; ++k) {
    const dvec3 margin = 0.1 * bounds.size();
    const dvec3 a = random.point(bounds.min - margin, bounds.max + margin),
                b = random.point(bounds.min - margin, bounds.max + margin);
    const double want = byCrossings(i, a, b), have = opticalDepth({i}, a, b);
    ASSERT_NEAR(have, want, 1e-10 * (1 + want)) << k;
    largest = std::max(largest, want);
  }
  EXPECT_GT(largest, 10);
  // Along lattice lines, edges and faces, both ways, from outside to outside.
  const Instance plain = placed(grid, dmat4(1.0));
  for (int axis = 0; axis < 3; ++axis)
    for (const double offset : {0.5, 3.0, 16.0, 31.999}) {
      dvec3 a(offset), b(offset);
      a[axis] = -5;
      b[axis] = 70;
      const double want = byCrossings(plain, a, b);
      EXPECT_NEAR(opticalDepth({plain}, a, b), want, 1e-9 * (1 + want)) << axis << " " << offset;
      EXPECT_NEAR(opticalDepth({plain}, b, a), want, 1e-9 * (1 + want)) << axis << " " << offset;
    }
}

TEST(Reference, GaussianBlobIsWithinQuantisation) {
  const double amplitude = 0.2, w = 10;
  const GridPtr grid = gridOf(ivec3(-55), ivec3(55), [&](const dvec3& p) {
    return amplitude * std::exp(-glm::dot(p, p) / (2 * w * w));
  });
  const InstanceList list{placed(grid, dmat4(1.0))};
  double worst = 0;
  for (const double d : {0.0, 5.0, 10.0, 20.0})
    for (const double p : {-60.0, -20.0, 0.0, 7.0, 15.0}) {
      // Linear between voxel centres on the ray: trapezoids, whose error is that of the end, f'(p) / 12.
      const double envelope = amplitude * std::exp(-d * d / (2 * w * w));
      const double want = envelope * w * std::sqrt(kPi / 2) * std::erfc(p / (w * std::sqrt(2.0)));
      const double end = envelope * std::abs(p) / (w * w) * std::exp(-p * p / (2 * w * w)) / 12;
      double quantum = 0;
      for (double x = p; x <= 55; ++x) {
        const ivec3 b = (ivec3(int(x), int(d), 0) - grid->origin) / kBrickSize;
        if (x >= -56) quantum += static_cast<double>(grid->levels[0].at(b).scale) / 510;
      }
      const double have = opticalDepth(list, dvec3(p, d, 0), dvec3(200, d, 0));
      // Half a quantum each would be the limit if all errors had one sign; they are far from it.
      EXPECT_NEAR(have, want, 0.3 * quantum + 1.1 * end + 1e-5) << d << " " << p;
      worst = std::max(worst, std::abs(have - want) / (amplitude * w * std::sqrt(2 * kPi)));
    }
  std::printf("Gaussian blob: largest error %.1e of the whole depth\n", worst);
  EXPECT_LT(worst, 5e-4);
}

TEST(Reference, ExponentialFogFollowsItsClosedForm) {
  const double s0 = 0.5, k = 0.03;
  const GridPtr grid = gridOf(ivec3(0), ivec3(100), [&](const dvec3& p) { return s0 * std::exp(-k * p.y); });
  const InstanceList list{placed(grid, dmat4(1.0))};
  Random random{std::mt19937_64(3)};
  double worst = 0;
  for (int n = 0; n < 500; ++n) {
    const dvec3 a = random.point(dvec3(0), dvec3(100));
    dvec3 b = random.point(dvec3(0), dvec3(100));
    if (n % 5 == 0) b.y = a.y;  // the limit of a level ray
    const double dy = b.y - a.y, length = glm::length(b - a);
    const double want = dy == 0 ? s0 * std::exp(-k * a.y) * length
                                : s0 * length / (k * dy) * (std::exp(-k * a.y) - std::exp(-k * b.y));
    worst = std::max(worst, std::abs(opticalDepth(list, a, b) / want - 1));
  }
  std::printf("exponential fog: largest relative error %.1e\n", worst);
  // A quantum of the lowest brick against the density high in it: 1.0 / 510 * exp(16 k) at most, and (k h)^2
  // / 12.
  EXPECT_LT(worst, 1.0 / 510 * std::exp(16 * k) + k * k / 12);
}

TEST(Reference, PlacementsScaleDepthByLengthAlone) {
  const GridPtr grid = randomGrid(ivec3(2, 2, 3), 8);
  const Instance plain = placed(grid, dmat4(1.0));
  Random random{std::mt19937_64(9)};
  for (int n = 0; n < 200; ++n) {
    const dvec3 a = random.point(dvec3(-5), dvec3(50)), b = random.point(dvec3(-5), dvec3(50));
    const double perMetre = opticalDepth({plain}, a, b) / glm::length(b - a);
    for (const dmat4& m : {composeTransform({9, 8, 7}, {10, 20, 30}, dvec3(1)),
                           composeTransform(dvec3(0), dvec3(0), {-1, 1, 1}),
                           composeTransform(dvec3(0), dvec3(0), dvec3(3)), kTilted}) {
      const dvec3 p(m * dvec4(a, 1)), q(m * dvec4(b, 1));
      ASSERT_NEAR(opticalDepth({placed(grid, m)}, p, q), perMetre * glm::length(q - p),
                  1e-9 * (1 + glm::length(q - p)));
    }
  }
}

TEST(Reference, OverlapsAddUpAndReversalChangesNothing) {
  const InstanceList list = crowd();
  Random random{std::mt19937_64(12)};
  for (int n = 0; n < 300; ++n) {
    const dvec3 a = random.point(dvec3(-3), dvec3(5)), b = random.point(dvec3(-3), dvec3(5));
    const double all = opticalDepth(list, a, b);
    double sum = 0;
    for (const Instance& i : list) sum += opticalDepth({i}, a, b);
    ASSERT_NEAR(all, sum, 1e-13 * (1 + sum));
    ASSERT_NEAR(all, opticalDepth(list, b, a), 1e-10 * (1 + all));
    const dvec3 middle = a + (b - a) * random.unit();
    ASSERT_NEAR(all, opticalDepth(list, a, middle) + opticalDepth(list, middle, b), 1e-10 * (1 + all));
  }
}

TEST(Reference, CumulativeDepthsAreThoseOfTheParts) {
  const InstanceList list = crowd();
  Random random{std::mt19937_64(13)};
  for (int n = 0; n < 100; ++n) {
    const dvec3 a = random.point(dvec3(-3), dvec3(5)), b = random.point(dvec3(-3), dvec3(5));
    std::vector<double> at{0, 0, 1, 1};
    for (int k = 0; k < 40; ++k) at.push_back(random.unit());
    at.push_back(at.back());
    std::sort(at.begin(), at.end());
    const std::vector<double> tau = cumulativeOpticalDepth(list, a, b, at);
    ASSERT_EQ(tau.size(), at.size());
    EXPECT_EQ(tau.front(), 0);
    EXPECT_NEAR(tau.back(), opticalDepth(list, a, b), 1e-12);
    for (std::size_t k = 0; k < at.size(); ++k)
      ASSERT_NEAR(tau[k], opticalDepth(list, a, a + (b - a) * at[k]), 1e-10) << at[k];
  }
  EXPECT_TRUE(cumulativeOpticalDepth(list, dvec3(-3), dvec3(3), {}).empty());
}

TEST(Reference, LightsAreReachedFromInsideAndOutside) {
  const InstanceList list = crowd();
  scene::Light sun, lamp;
  sun.towards = glm::normalize(dvec3(1, 2, -0.5));
  lamp.kind = scene::LightKind::Point;
  lamp.position = dvec3(0.2, 0.1, 0.3);
  Random random{std::mt19937_64(14)};
  for (int n = 0; n < 100; ++n) {
    const dvec3 p = random.point(dvec3(-6), dvec3(6));
    const double tau = opticalDepthToLight(list, sun, p);
    ASSERT_NEAR(tau, opticalDepth(list, p, p + sun.towards * 100.0), 1e-9);
    for (const auto kind : {scene::LightKind::Point, scene::LightKind::Spot}) {
      lamp.kind = kind;
      ASSERT_EQ(opticalDepthToLight(list, lamp, p), opticalDepth(list, p, lamp.position));
    }
  }
  EXPECT_EQ(opticalDepthToLight({}, sun, dvec3(0)), 0);
  EXPECT_EQ(opticalDepthToLight(list, sun, sun.towards * 100.0), 0);
}

}  // namespace
}  // namespace pileus::shadow
