// What must not change a mean: bounds, estimators, how lights are chosen, how a volume is described, where a
// dispatch ends, and who is the light and who looks.
#include <algorithm>
#include <cmath>

#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

view::RenderScene cloud(int samples = 256) {
  view::RenderScene scene;
  scene.options.size = {32, 18};
  scene.options.samples = samples;
  scene.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 30};
  scene.volumes = {test::gridInstance(test::gridOf(80, test::blobs), 80, 15)};
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(0.5);
  scene.volumes[0].medium.albedo = vec3(0.95f);
  scene.lights = {{test::sunFrom({0.5, 0.7, 0.2}, 3), nullptr}};
  scene.lights.push_back(test::halves(vec3(0.1f), vec3(0.02f)));
  return scene;
}

/// Equal within 4 standard errors of their difference, of which each is below half a percent.
void expectSame(const test::Traced& a, const test::Traced& b, const std::string& what) {
  const double error = std::hypot(a.grayError(), b.grayError());
  std::printf("  %-40s %.5f +- %.5f, %.5f +- %.5f: %+.2f s.e.\n", what.c_str(), a.gray(), a.grayError(),
              b.gray(), b.grayError(), (a.gray() - b.gray()) / error);
  EXPECT_LE(a.grayError(), 0.01 * a.gray()) << what;
  EXPECT_NEAR(a.gray(), b.gray(), 4 * error) << what;
}

TEST(PathInvariance, BoundsAndEstimators) {
  const test::Traced right = test::traced(cloud());
  for (const double scale : {2.0, 8.0}) {
    view::PathOptions o;
    o.majorantScale = scale;
    expectSame(right, test::traced(cloud(), o), fmt::format("majorants x {}", scale));
  }
  view::PathOptions ratio;
  ratio.transmittance = view::ShadowEstimate::Ratio;
  expectSame(right, test::traced(cloud(), ratio), "ratio tracking");
}

TEST(PathInvariance, WhateverMapsSay) {
  view::RenderScene scene = cloud();
  const scene::Light low = test::sunFrom({-0.8, 0.1, -0.3}, 2);
  scene.lights.push_back({low, nullptr});
  const test::Traced right = test::traced(scene);
  const shadow::ShadowSpec spec{};
  for (shadow::ShadowedLight& l : scene.lights)
    if (l.light.kind != scene::LightKind::Environment) l = test::shadowed(l.light, spec, scene.volumes);
  expectSame(right, test::traced(scene), "through their maps");
  for (const double factor : {0.0, 1.0}) {
    view::PathOptions o;
    o.mapFactor = factor;
    expectSame(right, test::traced(scene, o), fmt::format("maps that say {}", factor));
  }
}

TEST(PathInvariance, AVolumeInTwoHalves) {
  view::RenderScene scene = cloud();
  const test::Traced right = test::traced(scene);
  scene.volumes[0].medium.extinction *= 0.5;
  scene.volumes.push_back(scene.volumes[0]);
  expectSame(right, test::traced(scene), "two halves");
}

// In a slab that is wide, what a beam under one cosine sends into another is what the other would send back.
TEST(PathInvariance, SunAndCameraExchanged) {
  const auto seen = [](double view, double sun) {
    const auto towards = [](double mu) { return dvec3(std::sqrt(1 - mu * mu), mu, 0); };
    view::RenderScene scene =
        test::rayScene(dvec3(0, 0.5, 0) + 5.0 * towards(view) * dvec3(-1, 1, 1), {0, 0.5, 0}, 32, 128);
    scene.volumes = {test::box({0, 0, 0}, {1e4, 1, 1e4}, 3)};
    scene.volumes[0].medium.phase = scene::henyeyGreenstein(0.3);
    scene.lights = {{test::sunFrom(towards(sun), 1), nullptr}};
    return test::traced(scene);
  };
  // L(view; sun) mu_view = L(sun; view) mu_sun, both per irradiance across the beam.
  test::Traced a = seen(0.9, 0.4), b = seen(0.4, 0.9);
  a.mean *= 0.9, a.error *= 0.9, b.mean *= 0.4, b.error *= 0.4;
  expectSame(a, b, "exchanged");
}

TEST(PathInvariance, ColoredExtinctionIsThreeGrayOnes) {
  const vec3 color(1.0f, 0.5f, 0.15f);
  view::RenderScene scene = cloud();
  scene.volumes.push_back(test::ball({0.1, 0.1, 0}, 0.3, 4));
  for (const auto estimate : {view::ShadowEstimate::Series, view::ShadowEstimate::Ratio}) {
    view::PathOptions o;
    o.transmittance = estimate;
    view::RenderScene colored = scene;
    colored.volumes[0].medium.extinctionColor = color;
    const test::Traced t = test::traced(colored, o);
    for (int c = 0; c < 3; ++c) {
      view::RenderScene gray = scene;
      gray.volumes[0].medium.extinction *= double(color[c]);
      const test::Traced g = test::traced(gray, o);
      const double error = std::hypot(t.error[c], g.error[c]);
      std::printf("  channel %d: %.5f, gray %.5f: %+.2f s.e.\n", c, t.mean[c], g.mean[c],
                  (t.mean[c] - g.mean[c]) / error);
      EXPECT_LE(t.error[c], 0.02 * t.mean[c]);
      EXPECT_NEAR(t.mean[c], g.mean[c], 4 * error);
    }
  }
}

// A sample is the same in however many dispatches it is traced.
TEST(PathInvariance, WorkOfADispatch) {
  view::PathOptions little, much;
  little.workPerDispatch = 60, much.workPerDispatch = 100000;
  for (const auto estimate : {view::ShadowEstimate::Series, view::ShadowEstimate::Ratio}) {
    little.transmittance = much.transmittance = estimate;
    const auto a = test::traced(cloud(4), little), b = test::traced(cloud(4), much);
    const auto &p = a.picture.layers[0].pixels, &q = b.picture.layers[0].pixels;
    std::size_t other = 0;
    for (std::size_t i = 0; i < p.size(); ++i) other += p[i] != q[i];
    EXPECT_EQ(other, 0u);
  }
}

// Orders apart are all of them.
TEST(PathInvariance, OrdersAddUp) {
  const test::Traced all = test::traced(cloud(64));
  dvec3 sum(0);
  for (const ivec2 orders : {ivec2(0, 0), ivec2(1, 1), ivec2(2, 3), ivec2(4, 7), ivec2(8, 1 << 30)}) {
    view::PathOptions o;
    o.orders = orders;
    const test::Traced part = test::traced(cloud(64), o);
    sum += part.mean;
    std::printf("  orders %d .. %d: %.5f\n", orders.x + 1, orders.y + 1, part.gray());
  }
  EXPECT_NEAR(sum.x, all.mean.x, 1e-5 * all.mean.x);
}

// What ends a picture by its noise is summed on the GPU: the statistics of what is read back.
TEST(PathNoise, SumsAreThoseOfThePicture) {
  view::RenderScene scene = cloud(4096);
  scene.options.size = {37, 19};  // no multiple of what an invocation sums
  view::PathOptions options;
  options.noise = 0.1;
  view::PathTracePass pass(scene, options);
  test::runToEnd(pass);
  const view::PathStatistics read = pass.statistics();
  const auto summed = pass.noise(test::renderer().gpu());
  ASSERT_TRUE(summed) << summed.error().message;
  EXPECT_EQ(summed->samples, read.samples);
  EXPECT_NEAR(summed->mean, read.mean, 1e-6 * read.mean);
  EXPECT_NEAR(summed->standardError, read.standardError, 1e-6 * read.standardError);
  std::printf("  %d samples, %.4f of the mean\n", read.samples, read.standardError / read.mean);
  EXPECT_GE(read.samples, 16);
  EXPECT_LT(read.samples, 4096);
  EXPECT_LE(read.standardError, 0.1 * read.mean);
  EXPECT_GE(read.standardError, 0.05 * read.mean) << "and not long before";
}

}  // namespace
}  // namespace pileus
