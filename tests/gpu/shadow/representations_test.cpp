// Every shadow representation through its own GPU pass and the one lookup: closed forms, gathering against
// splatting, silhouettes.
#include "renderer/shadow/basis.h"
#include "renderer/shadow/metric.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using namespace test;
using shadow::Basis;
using shadow::Metric;
using shadow::ShadowSpec;

TEST(Representations, EndOfTheRayIsExactForEachOfThem) {
  const auto light = test::sunFrom({0.3, 1, 0.2});
  const volume::InstanceList volumes{box({0, 2, 0}, {1, 0.5, 1}, 1.1),
                                     box({0.1, 0, 0}, {1, 0.7, 1}, 2.6, {0, 30, 10}),
                                     test::ball({0, -2, 0}, 0.6, 5)};
  ShadowSpec deepest = deep(1e-4), damped = fourier(7);
  damped.damping = true;
  for (const ShadowSpec& spec :
       {fourier(3), fourier(7), fourier(15), fourier(31), fourier(7, 128, true), damped, improved(4, 8, 128),
        improved(8, 16, 128), improved(1, 1, 128), deepest}) {
    const auto map = build(spec, volumes, light);
    std::vector<vec3> at;
    for (int y = 8; y < 128; y += 16)
      for (int x = 8; x < 128; x += 16)
        at.push_back(vec3(shadow::mapSegment(map->frustum, 0, dvec2(x + 0.5, y + 0.5) / 128.0, 128).to));
    EXPECT_LT(worstAgainstReference(*map, volumes, at), 1e-3) << shadow::describe(spec);
  }
}

TEST(Representations, CosinesPerIntervalAreExactBehindEveryMedium) {
  const auto light = test::sunFrom(kUp);
  const volume::InstanceList volumes{box({0, 3, 0}, {1, 0.4, 1}, 1), box({0, 1, 0}, {1, 0.1, 1}, 20),
                                     box({0, -1, 0}, {1, 1, 1}, 0.5)};
  for (const int coefficients : {4, 7, 16}) {
    ShadowSpec spec = improved(4, coefficients, 128, false);
    spec.extinction.basis = Basis::Piecewise;
    const auto map = build(spec, volumes, light);
    // Uniform media: linear inside, level in the gaps.
    EXPECT_LT(worstAgainstReference(*map, volumes,
                                    {{0.1f, 2.0f, 0.1f},
                                     {0.1f, 1.0f, 0.1f},
                                     {0.1f, 0.5f, 0.1f},
                                     {0.1f, -1.1f, 0.1f},
                                     {0.1f, -1.5f, 0.1f}}),
              1e-4)
        << coefficients;
  }
  ShadowSpec few = improved(4, 3, 128, false);
  few.extinction.basis = Basis::Piecewise;
  const auto refused = shadow::buildShadow(test::renderer().gpu(), few, light, volumes);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("coefficients: 3 are too few"), std::string::npos)
      << refused.error().message;
}

TEST(Representations, FourierOpacityOfASlabHasItsSeries) {
  const double S = 3, d1 = 0.2, d2 = 0.55;
  const volume::InstanceList volumes{box({0, 0.5 - (d1 + d2) / 2, 0}, {1, d2 - d1, 1}, S)};
  const auto map = buildIn(fourier(7), volumes, narrow());
  const auto c = test::texel(*map->block, {64, 64});
  EXPECT_NEAR(c[0], 2 * S * (d2 - d1), 1e-5);
  for (int k = 1; k <= 3; ++k) {
    const double w = 2 * kPi * k;
    EXPECT_NEAR(c[std::size_t(2 * k - 1)], S * (std::sin(w * d2) - std::sin(w * d1)) / (kPi * k), 2e-5) << k;
    EXPECT_NEAR(c[std::size_t(2 * k)], S * (std::cos(w * d1) - std::cos(w * d2)) / (kPi * k), 2e-5) << k;
  }
}

TEST(Representations, SineSquaredIsExactForFourier) {
  const volume::Instance grid = profile(1024, [](double d) { return 4 * std::pow(std::sin(kPi * d), 2); });
  const auto map = buildIn(fourier(7), {grid}, narrow());
  // 8-bit voxels and the half voxel at the ends leave a few 1e-4.
  EXPECT_LT(worstAgainstReference(*map, {grid}, downTheRay(200)), 5e-4);
  const auto tau = test::lookupTau(*map, map->light, downTheRay(200));
  for (int i = 0; i < 200; ++i) {
    const double d = (i + 0.5) / 200;
    EXPECT_NEAR(T(double(tau[std::size_t(i)])), T(4 * (d / 2 - std::sin(2 * kPi * d) / (4 * kPi))), 2e-3);
  }
}

TEST(Representations, CosinesOfTheBasisAreExact) {
  for (const int n : {1, 3, 7}) {
    const volume::Instance grid = profile(1024, [n](double d) { return 1.5 * (1 + std::cos(kPi * n * d)); });
    const auto map = buildIn(improved(1, 8, 128, false), {grid}, narrow());
    EXPECT_LT(worstAgainstReference(*map, {grid}, downTheRay(200)), 2e-3) << n;
  }
}

TEST(Representations, ThinSheetOvershootsByTheDirichletIntegral) {
  // Everything at u0: tau(u) is the integrated Dirichlet kernel, which overshoots by 8.95 % of tau0 as the
  // order grows.
  const double tau0 = 1, at = 0.5, width = 1e-3;
  const volume::InstanceList volumes{box({0, 0.5 - at, 0}, {1, width, 1}, tau0 / width)};
  ShadowSpec spec;
  spec.metric.metric = Metric::None;
  spec.extinction = {Basis::Cosine, 32, 128, shadow::Storage::Float};
  const auto map = buildIn(spec, volumes, narrow());
  const auto c = test::texel(*map->block, {64, 64});
  const std::vector<double> series(c.begin(), c.begin() + 32);
  double largest = 0, smallest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double u = i / 4000.0;
    double tau = series[0] * u;
    for (int k = 1; k < 32; ++k) tau += series[std::size_t(k)] * std::sin(kPi * k * u) / (kPi * k);
    largest = std::max(largest, tau), smallest = std::min(smallest, tau);
  }
  EXPECT_NEAR(largest - 1, 0.0895, 0.004);
  EXPECT_NEAR(-smallest, 0.0895, 0.004);
}

TEST(Representations, GaussianBlobAndHeightFog) {
  const double A = 6, w = 0.12;
  const volume::Instance blob =
      profile(1024, [&](double d) { return A * std::exp(-std::pow((d - 0.4) / w, 2) / 2); });
  const volume::Instance fog = profile(1024, [&](double d) { return A * std::exp(-4 * (1 - d)); });
  const ShadowSpec spec = improved(1, 16, 128, false);
  const auto b = buildIn(spec, {blob}, narrow()), f = buildIn(spec, {fog}, narrow());
  const auto at = downTheRay(100);
  const auto tb = test::lookupTau(*b, b->light, at), tf = test::lookupTau(*f, f->light, at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double d = (double(i) + 0.5) / 100, half = A * w * std::sqrt(kPi / 2);
    EXPECT_NEAR(T(double(tb[i])),
                T(half * (std::erf((d - 0.4) / (w * std::sqrt(2.0))) + std::erf(0.4 / (w * std::sqrt(2.0))))),
                8e-3)
        << d;
    EXPECT_NEAR(T(double(tf[i])), T(A / 4 * (std::exp(-4 * (1 - d)) - std::exp(-4.0))), 8e-3) << d;
  }
}

TEST(Representations, TransmittanceFunctionIsTheSeriesOfT) {
  const double S = 4, d1 = 0.25, d2 = 0.7;
  const volume::InstanceList volumes{box({0, 0.5 - (d1 + d2) / 2, 0}, {1, d2 - d1, 1}, S)};
  const auto truth = [&](double d) { return T(S * std::clamp(d - d1, 0.0, d2 - d1)); };
  for (const Basis basis : {Basis::Fourier, Basis::Cosine}) {
    const int n = 7;
    const auto map = buildIn(transmittance(n, basis), volumes, narrow());
    const auto c = test::texel(*map->block, {64, 64});
    // The series by numeric integration.
    std::vector<double> expected(std::size_t(n), 0.0);
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i)
      shadow::projectStep(basis, expected, truth((i + 0.5) / kSteps) / kSteps, double(i) / kSteps,
                          double(i + 1) / kSteps);
    for (int k = 0; k < n; ++k)
      EXPECT_NEAR(c[std::size_t(k)], expected[std::size_t(k)], 2e-4) << enumId(basis) << " " << k;
    const auto at = downTheRay(50);
    const auto tau = test::lookupTau(*map, map->light, at);
    for (std::size_t i = 0; i < at.size(); ++i)
      EXPECT_NEAR(T(double(tau[i])),
                  std::clamp(shadow::basisValue(basis, expected, (double(i) + 0.5) / 50), 0.0, 1.0), 1e-3)
          << enumId(basis) << " " << i;
  }
}

TEST(Representations, SplattingIsGathering) {
  const auto light = test::sunFrom({0.3, 1, 0.2});
  volume::InstanceList volumes;
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 12; ++i)
    volumes.push_back(
        box({u(rng), u(rng), u(rng)}, {0.5, 0.4, 0.6}, 1 + u(rng), {90 * u(rng), 90 * u(rng), 0}));
  for (const Metric metric : {Metric::Interval, Metric::Fourier, Metric::None})
    for (const Basis basis : {Basis::Cosine, Basis::Slab})
      for (const shadow::Storage storage : {shadow::Storage::Float, shadow::Storage::Half}) {
        ShadowSpec spec;
        spec.metric = {metric, 4, 4, 128, storage};
        spec.extinction = {basis, 8, 128, storage};
        if (metric == Metric::Interval) spec.metric.weighting = shadow::Weighting::Root;
        const auto gathered = build(spec, volumes, light);
        spec.extinction.accumulation = shadow::Accumulation::Splat;
        const auto splatted = build(spec, volumes, light);
        double worst = 0;
        for (int y = 0; y < 128; y += 3)
          for (int x = 0; x < 128; x += 3) {
            const auto a = test::texel(*gathered->block, {x, y}), b = test::texel(*splatted->block, {x, y});
            const double scale = std::max(1.0, std::abs(double(a[0])));
            for (std::size_t k = 0; k < 8; ++k)
              worst = std::max(worst, std::abs(double(a[k]) - double(b[k])) / scale);
          }
        const auto at = pointsInside(volumes, 3000, 4);
        const auto ta = test::lookupTau(*gathered, light, at), tb = test::lookupTau(*splatted, light, at);
        double worstT = 0;
        for (std::size_t i = 0; i < at.size(); ++i)
          worstT = std::max(worstT, std::abs(T(double(ta[i])) - T(double(tb[i]))));
        std::printf("splat against gather, %s %s %s: coefficients %.1e, |dT| %.1e\n",
                    std::string(enumId(metric)).c_str(), std::string(enumId(basis)).c_str(),
                    std::string(enumId(storage)).c_str(), worst, worstT);
        EXPECT_LE(worst, storage == shadow::Storage::Float ? 2e-6 : 4e-3);
        EXPECT_LE(worstT, storage == shadow::Storage::Float ? 1e-5 : 5e-3);
      }
  ShadowSpec both = improved(4, 8, 128);
  both.extinction.accumulation = shadow::Accumulation::Splat;
  const auto refused = shadow::buildShadow(test::renderer().gpu(), both, light, volumes);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("horizon"), std::string::npos);
}

TEST(Representations, SilhouettesDoNotLeak) {
  const auto [light, volumes] = cli::silhouetteScene();
  const auto worst = [&](const ShadowSpec& spec) {
    const auto error = cli::silhouetteError(test::renderer().gpu(), spec);
    EXPECT_TRUE(error) << (error ? "" : error.error().message);
    return error ? *error : 1e9;
  };
  // Exact intervals and uniform media: in each texel the map is nearly exact; what is left comes from 8
  // cosines over two densities.
  ShadowSpec slabs = improved(4, 32, 256);
  slabs.extinction.basis = Basis::Slab;
  // What blending metric and coefficients across an edge would give: the reason for the mixed bit.
  const auto map = build(improved(4, 16, 256, false), volumes, light);
  double naive = 0;
  for (int y = 40; y < 216; ++y)
    for (int x = 40; x < 216; ++x) {
      const auto m0 = test::texel(*map->metric->block, {x, y}),
                 m1 = test::texel(*map->metric->block, {x + 1, y});
      if ((m0[2] < 1) == (m1[2] < 1)) continue;
      const auto c0 = test::texel(*map->block, {x, y}), c1 = test::texel(*map->block, {x + 1, y});
      std::vector<double> m, c;
      for (std::size_t k = 0; k < 8; ++k) m.push_back(0.5 * (double(m0[k]) + double(m1[k])));
      for (std::size_t k = 0; k < 16; ++k) c.push_back(0.5 * (double(c0[k]) + double(c1[k])));
      for (int i = 0; i < 20; ++i) {
        const dvec3 from = shadow::mapSegment(map->frustum, 0, dvec2(x + 1, y + 0.5) / 256.0, 256).from;
        const dvec3 p(from.x, 0.3 - 0.6 * (i + 0.5) / 20, from.z);
        const double depth = shadow::mapCoordinates(map->frustum, p, 256).at.z;
        const auto exact = [&](double u) {
          const auto ray = shadow::mapSegment(map->frustum, 0, dvec2(u, (y + 0.5) / 256), 256);
          return T(shadow::opticalDepth(volumes, ray.from, glm::mix(ray.from, ray.to, depth)));
        };
        const double truth = 0.5 * (exact((x + 0.5) / 256) + exact((x + 1.5) / 256));
        naive = std::max(
            naive,
            std::abs(T(shadow::basisTau(Basis::Cosine, c, shadow::metricU(Metric::Interval, m, depth))) -
                     truth));
      }
    }
  const double improvedWorst = worst(improved(4, 16, 256)), slabWorst = worst(slabs);
  std::printf(
      "silhouette: largest |dT| %.3f (16 cosines), %.3f (32 slabs); blending coefficients would err by "
      "%.3f\n",
      improvedWorst, slabWorst, naive);
  EXPECT_GT(naive, 0.1);  // the scene does show it
  EXPECT_LE(improvedWorst, 0.05);
  EXPECT_LE(slabWorst, 0.05);
}

TEST(Representations, EachIsCloserThanItsBoundOnSmoke) {
  PILEUS_NEEDS_DATA();
  const volume::InstanceList volumes{smoke1()};
  scene::Light light;
  light.towards = scene::sunDirection(30, 40);
  const auto at = pointsInside(volumes, 4000, 5);
  std::vector<double> truth;
  for (const vec3& p : at) truth.push_back(T(shadow::opticalDepthToLight(volumes, light, dvec3(p))));
  struct Row {
    ShadowSpec spec;
    double bound;
  };
  for (const Row& row :
       {Row{improved(4, 8, 256, false), 0.017}, Row{improved(4, 8, 256), 0.0145},
        Row{improved(4, 16, 256), 0.0075}, Row{improved(4, 8, 256, true, shadow::Storage::Half), 0.0145},
        Row{fourier(15, 256), 0.02}, Row{fourier(7, 256, true), 0.022},
        Row{transmittance(15, Basis::Cosine, 256), 0.018}, Row{deep(0.005, 256), 0.0045}}) {
    const auto map = build(row.spec, volumes, light);
    const auto tau = test::lookupTau(*map, light, at);
    double mean = 0;
    for (std::size_t i = 0; i < at.size(); ++i)
      mean += std::abs(T(double(tau[i])) - truth[i]) / double(at.size());
    std::printf("smoke1, %s: mean |dT| %.4f, %.1f bytes a texel\n", shadow::describe(row.spec).c_str(), mean,
                map->bytesPerTexel());
    EXPECT_LE(mean, row.bound) << shadow::describe(row.spec);
  }
}

}  // namespace
}  // namespace pileus
