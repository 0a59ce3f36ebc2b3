// More lights than one dispatch holds: the picture of all is the sum of their pictures, by either renderer.
#include <cmath>

#include "tests/support/guaranteed_limits.h"
#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

constexpr int kCount = 100;

/// Suns from all sides of other colours; each fifth is shadowed, one is a lamp.
view::RenderScene scene() {
  view::RenderScene out;
  out.options.size = {24, 16};
  out.options.samples = 1;
  out.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 24};
  out.volumes = {test::gridInstance(test::gridOf(80, test::blobs), 80, 8)};
  out.solids = {test::solidPlane({0, -0.6, 0}, {3, 1, 3})};
  for (int i = 0; i < kCount; ++i) {
    const double a = 2.4 * i, y = -0.9 + 1.8 * i / kCount, r = std::sqrt(1 - y * y);
    scene::Light sun = test::sunFrom({r * std::sin(a), y, r * std::cos(a)}, 0.5f);
    sun.emitted *= vec3(1.0f, 0.5f + 0.005f * float(i), float(i % 7) / 6);
    out.lights.push_back(
        {sun, i % 5 == 0 ? shadow::marchedShadow(sun, out.volumes, out.solids, 1) : nullptr});
  }
  const scene::Light lamp = test::pointAt({0.5, 1, 0.5}, 2);
  out.lights[70] = {lamp, shadow::marchedShadow(lamp, out.volumes, out.solids, 1)};
  return out;
}

std::vector<float> pixels(const image::Image& image) { return image.layers[0].pixels; }

TEST(ManyLights, AreTheSumOfSingles) {
  const view::RenderScene all = scene();
  const std::vector<float> whole = pixels(test::render(all));
  std::vector<double> sum(whole.size(), 0);
  for (const shadow::ShadowedLight& light : all.lights) {
    view::RenderScene one = all;
    one.lights = {light};
    const std::vector<float> p = pixels(test::render(one));
    for (std::size_t i = 0; i < p.size(); ++i) i % 4 == 3 ? sum[i] = double(p[i]) : sum[i] += double(p[i]);
  }
  double largest = 0, worst = 0;
  for (std::size_t i = 0; i < sum.size(); ++i)
    largest = std::max(largest, sum[i]), worst = std::max(worst, std::abs(sum[i] - double(whole[i])));
  std::printf("  %.3g off of %.3g\n", worst, largest);
  EXPECT_GT(largest, 0.5);
  EXPECT_LT(worst, 2e-4 * largest) << "steps are cut for a lamp, and so where it is alone";
}

// What the samples and the regions are does not matter, and neither do pauses.
TEST(ManyLights, OfManySamplesInSteps) {
  view::RenderScene all = scene();
  all.options.samples = 3;
  const std::vector<float> whole = pixels(test::render(all));
  view::VolumeRenderPass pass(all);
  pass.pauseAfter(500);
  for (double done = 0; done < 1;) {
    const auto step = pass.step(test::renderer().gpu(), 0);
    ASSERT_TRUE(step) << step.error().message;
    done = *step;
  }
  const std::vector<float> cut = pixels(view::readBack(*pass.picture()).value());
  double worst = 0;
  for (std::size_t i = 0; i < cut.size(); ++i)
    worst = std::max(worst, std::abs(double(cut[i]) - double(whole[i])));
  EXPECT_LT(worst, 1e-4);
}

// On a driver that offers what is guaranteed and no more.
TEST(ManyLights, WithinWhatOpenGlGuarantees) {
  view::RenderScene all = scene();
  const std::vector<float> whole = pixels(test::render(all));
  const test::GuaranteedLimits limits;
  const auto least = view::Renderer::create({.gpuMemory = std::size_t(256) << 20});
  ASSERT_TRUE(least) << least.error().message;
  view::VolumeRenderPass pass(all);
  view::PathTracePass paths(all, {});
  for (double done = 0; done < 1;) {
    const auto step = pass.step((*least)->gpu(), 1e12);
    ASSERT_TRUE(step) << step.error().message;
    done = *step;
  }
  for (double done = 0; done < 1;) {
    const auto step = paths.step((*least)->gpu(), 1e12);
    ASSERT_TRUE(step) << step.error().message;
    done = *step;
  }
  const std::vector<float> limited = pixels(view::readBack(*pass.picture()).value());
  double worst = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    worst = std::max(worst, std::abs(double(limited[i]) - double(whole[i])));
  std::printf("  %.3g off\n", worst);
  EXPECT_LT(worst, 1e-5);
}

TEST(ManyLights, PathsTakeAll) {
  view::RenderScene all = scene();
  all.options.samples = 64;
  const std::vector<float> whole = pixels(test::render(all));
  double mean = 0;
  for (std::size_t i = 0; i < whole.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) mean += double(whole[i + c]) / (3 * 24 * 16);
  // A light without a shadow gets that of what is drawn.
  for (shadow::ShadowedLight& l : all.lights)
    if (!l.shadow) l.shadow = shadow::marchedShadow(l.light, all.volumes, all.solids, 0.5);
  const std::vector<float> marched = pixels(test::render(all));
  double shadowed = 0;
  for (std::size_t i = 0; i < marched.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) shadowed += double(marched[i + c]) / (3 * 24 * 16);
  EXPECT_LT(shadowed, 0.95 * mean);
  view::PathOptions once;
  once.bounces = 0;
  all.options.samples = 512;
  const test::Traced t = test::traced(all, once);
  std::printf("  paths %.5f +- %.5f, marched %.5f\n", t.gray(), t.grayError(), shadowed);
  EXPECT_LE(t.grayError(), 0.01 * shadowed);
  EXPECT_NEAR(t.gray(), shadowed, 4 * t.grayError() + 0.003 * shadowed);
}

}  // namespace
}  // namespace pileus
