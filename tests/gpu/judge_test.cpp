// The judge: what is right is found right within its errors, what is wrong is found and measured, and the
// orders of scattering are its own light.
#include "renderer/truth/judge.h"

#include <cmath>

#include "renderer/truth/truth_picture.h"
#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

/// A cloud with empty space in it, under a sun whose shadow is marched. Dense, with steep edges, and lit from
/// where it is seen: few pixels that a path seldom meets, since their noise is what limits the judge.
view::RenderScene cloud(ivec2 size) {
  view::RenderScene scene;
  scene.options.size = size;
  scene.options.samples = 64;
  scene.options.stepScale = 0.5;
  scene.options.camera = {{0, 0.1, 2.4}, {0, 0, 0}, {0, 1, 0}, 22};
  const auto density = [](ivec3 voxel) { return std::min(1.0f, 8 * test::blobs(voxel)); };
  scene.volumes = {test::gridInstance(test::gridOf(80, density), 80, 20)};
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(0.4);
  const scene::Light sun = test::sunFrom({0.3, 0.3, 1}, 3);
  scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, {}, 0.5)}};
  return scene;
}

/// Run to the end; `picture` against `scene`.
std::unique_ptr<truth::JudgePass> judged(const image::Image& picture, const view::RenderScene& scene,
                                         const truth::JudgeOptions& options) {
  auto pass = std::make_unique<truth::JudgePass>(picture, scene, options);
  double done = 0, before = 0;
  while (done < 1) {
    const auto step = pass->step(test::renderer().gpu(), 50);
    if (!step) {
      ADD_FAILURE() << step.error().message;
      std::abort();
    }
    done = *step;
    EXPECT_GE(done, before);
    before = done;
  }
  const truth::JudgeFigures& f = pass->figures();
  std::printf(
      "  scaled relMSE %.3g +- %.2g (noise adds %.1g), ratio %.5f +- %.5f, pixels %.2f %%, %d samples\n",
      f.scaled.value, f.scaled.standardError, f.noiseBias, f.scaled.ratio, f.ratioError, 100 * f.noise,
      f.samples);
  EXPECT_EQ(f.violations, 0);
  EXPECT_EQ(f.endless, 0);
  return pass;
}

TEST(Judge, AMarchedCloudIsAsPathsHaveIt) {
  const view::RenderScene scene = cloud({96, 54});
  const image::Image picture = test::render(scene);
  truth::JudgeOptions options;
  options.samples = 768;
  const auto pass = judged(picture, scene, options);
  const truth::JudgeFigures& f = pass->figures();
  EXPECT_EQ(f.samples, 768);
  EXPECT_FALSE(f.endedByTime);
  EXPECT_LT(f.scaled.standardError, 3e-4) << "a quarter of 2e-4 takes some 4000 samples: a minute";
  EXPECT_LT(f.scaled.value, 2e-4 + 4 * f.scaled.standardError);
  EXPECT_GT(f.scaled.value, -4 * f.scaled.standardError);
  EXPECT_LT(f.ratioError, 1.25e-3);
  EXPECT_NEAR(f.scaled.ratio, 1, 5e-3);
  EXPECT_GT(f.scaled.pixels, 500u);

  // Single scattering is all there is of it.
  ASSERT_EQ(pass->orders().size(), 1u);
  EXPECT_EQ(pass->orders()[0].layer, "order1");
  EXPECT_EQ(pass->orders()[0].mean.value, f.judge.value);
  EXPECT_NEAR(f.scaled.meanB, f.judge.value, 1e-6 * f.judge.value) << "the halves' mean is the judge";
  const image::Image layers = pass->picture();
  for (const char* name : {"", "judge", "difference", "variance", "order1"})
    EXPECT_TRUE(layers.layer(name)) << name;
  EXPECT_EQ(layers.layers.size(), 5u);
  EXPECT_EQ(layers.layer("")->pixels, picture.layers[0].pixels);
  for (std::size_t i = 0; i < 96 * 54; ++i)
    ASSERT_EQ(layers.layer("difference")->pixels[3 * i],
              layers.layer("")->pixels[4 * i] - layers.layer("judge")->pixels[4 * i]);
}

// A sun 10 % too bright in the picture is 1.1 times the light, and an error of 0.1^2 at each pixel, but for
// what the bound on dark pixels takes from it.
TEST(Judge, ALightThatIsTooBrightIsFound) {
  const view::RenderScene scene = cloud({48, 27});
  view::RenderScene brighter = scene;
  brighter.lights[0].light.emitted *= 1.1f;
  const image::Image right = test::render(scene), picture = test::render(brighter);
  const auto pass = judged(picture, scene, {.bounces = 0, .samples = 768, .seconds = 0});
  const truth::JudgeFigures& f = pass->figures();
  EXPECT_NEAR(f.scaled.ratio, 1.1, 4 * f.ratioError + 2e-3);
  EXPECT_LT(f.ratioError, 3e-3);
  // The same without noise: against the right picture.
  const double expected = image::scaledRelMse(picture, right, right)->value;
  EXPECT_NEAR(expected, 0.01, 2e-3);
  EXPECT_LT(f.scaled.standardError, 1e-3);
  EXPECT_NEAR(f.scaled.value, expected, 4 * f.scaled.standardError + 2e-4);
}

// Orders are the judge's own paths: together they are the judge, pixel by pixel, and the first of them is
// single scattering. What is path-traced itself is no likelier to be right than by its noise.
TEST(Judge, OrdersAddUpToTheJudge) {
  view::RenderScene scene = cloud({32, 18});
  scene.volumes[0].medium.albedo = vec3(0.98f, 0.95f, 0.9f);
  const image::Image single = test::render(scene);
  for (const int bounces : {-1, 3}) {
    const auto pass = judged(single, scene, {.bounces = bounces, .samples = 64, .seconds = 0});
    const std::size_t orders = bounces < 0 ? 5 : 3;
    ASSERT_EQ(pass->orders().size(), orders);
    const image::Image layers = pass->picture();
    ASSERT_EQ(layers.layers.size(), 4 + orders);
    const std::vector<float>& judge = layers.layer("judge")->pixels;
    std::vector<double> sum(judge.size());
    double means = 0;
    for (const truth::JudgedOrder& o : pass->orders()) {
      EXPECT_EQ(o.samples, 64);
      EXPECT_GT(o.mean.value, 0) << o.layer;
      EXPECT_GT(o.mean.standardError, 0) << o.layer;
      means += o.mean.value;
      const std::vector<float>& pixels = layers.layer(o.layer)->pixels;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += double(pixels[i]);
      std::printf("  order %-4s %.5f +- %.5f\n", o.label.c_str(), o.mean.value, o.mean.standardError);
    }
    const truth::JudgeFigures& f = pass->figures();
    EXPECT_NEAR(means, f.judge.value, 1e-5 * f.judge.value);
    for (std::size_t i = 0; i < sum.size(); ++i)
      if (i % 4 < 3) {
        ASSERT_NEAR(sum[i], judge[i], 1e-4 * double(judge[i]) + 1e-6) << bounces << ", " << i;
      }
    EXPECT_LT(f.scaled.ratio, 0.9) << "a picture of single scattering lacks light";
    const truth::JudgedOrder& first = pass->orders()[0];
    EXPECT_NEAR(first.mean.value, f.scaled.meanA, 4 * first.mean.standardError + 2e-3 * f.scaled.meanA);
  }
}

// Its paths are other ones than those of any picture. With as many of the same the picture would be the mean
// of both halves, and its noise be taken for agreement.
TEST(Judge, APathTracedPictureSharesNoNoiseWithIt) {
  view::RenderScene scene = cloud({48, 27});
  scene.options.samples = 64;
  view::PathOptions options;
  options.bounces = 1;
  view::PathTracePass made(scene, options);
  while (made.step(test::renderer().gpu(), 1e9).value() < 1) {
  }
  EXPECT_EQ(truth::claimedBounces(*made.picture()->scene), 1);
  const image::Image picture = view::readBack(*made.picture()).value();
  const auto halves = made.halves().value();
  EXPECT_LT(image::scaledRelMse(picture, halves[0], halves[1])->value, 0);
  const auto pass = judged(picture, scene, {.bounces = 1, .samples = 64, .seconds = 0});
  const image::ScaledRelMse& scaled = pass->figures().scaled;
  EXPECT_GT(scaled.value, 3 * scaled.standardError) << "the picture's own variance";
  EXPECT_NEAR(scaled.ratio, 1, 4 * 1.5 * pass->figures().ratioError) << "both are noisy";
}

TEST(Judge, WhatCannotBeJudgedIsRefused) {
  const view::RenderScene scene = cloud({32, 18});
  const auto refused = [&](const image::Image& picture) {
    truth::JudgePass pass(picture, scene, {.bounces = 0, .samples = 2, .seconds = 0});
    for (int i = 0; i < 1000; ++i) {
      const auto step = pass.step(test::renderer().gpu(), 1e9);
      if (!step) return step.error().message;
      if (*step >= 1) return std::string("it was judged");
    }
    return std::string("it never ends");
  };
  view::RenderScene other = scene;
  other.options.size = {16, 9};
  EXPECT_NE(refused(test::render(other)).find("differ in size"), std::string::npos);
  other = scene;
  other.options.camera.target = {0, 0, 10};
  EXPECT_NE(refused(test::render(other)).find("no pixel"), std::string::npos) << "nothing in it";
}

}  // namespace
}  // namespace pileus
