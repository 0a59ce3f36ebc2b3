// Light from everywhere in render.volume: sixteen other directions for each sample, whose mean is that of the
// paths.
#include <algorithm>
#include <cmath>

#include "renderer/scene/environment_strata.h"
#include "renderer/truth/compare.h"
#include "renderer/truth/ray_probe.h"
#include "renderer/truth/shadow_error.h"
#include "renderer/truth/shadow_measure.h"
#include "tests/support/shadow_specs.h"
#include "tests/support/small_environment.h"

namespace pileus {
namespace {

shadow::ShadowSpec march(double stepScale = 0.5) {
  shadow::ShadowSpec spec;
  spec.kind = shadow::ShadowSpec::Kind::RayMarch;
  spec.stepScale = stepScale;
  return spec;
}

/// What a dropped picture of light gets: the maps that nodes begin with, at 128 texels.
shadow::ShadowSpec dropped() {
  shadow::ShadowSpec spec;
  spec.metric = {.resolution = 128, .weighting = shadow::Weighting::Root, .horizon = shadow::kUsualHorizon};
  spec.extinction.coefficients = 32;
  spec.extinction.resolution = 128;
  spec.extinction.storage = shadow::Storage::Half;
  return spec;
}

/// Each environment of the scene shadowed by what is drawn.
view::RenderScene shadowed(view::RenderScene scene, const shadow::ShadowSpec& spec) {
  for (shadow::ShadowedLight& l : scene.lights)
    if (l.light.kind == scene::LightKind::Environment)
      l.shadow = shadow::describedShadow(spec, l.light, scene.volumes, scene.solids);
  return scene;
}

struct Drawn {
  image::Image image;
  std::shared_ptr<const view::Picture> picture;
  const std::vector<float>& pixels() const { return image.layers[0].pixels; }
};

/// By steps of `ms`, each march cut after so many iterations.
Drawn draw(const view::RenderScene& scene, double ms = 1e12, int pauseAfter = 0,
           std::shared_ptr<view::KeptSuns> kept = {}) {
  view::VolumeRenderPass pass(scene);
  pass.pauseAfter(pauseAfter);
  pass.keepSuns(std::move(kept));
  double before = 0;
  for (double done = 0; done < 1;) {
    const auto step = pass.step(test::renderer().gpu(), ms);
    if (!step) {
      ADD_FAILURE() << step.error().message;
      std::abort();
    }
    done = *step;
    EXPECT_GE(done, before) << "progress goes on";
    before = done;
  }
  return {view::readBack(*pass.picture()).value(), pass.picture()};
}

/// Mean |a - b| and mean a - b over RGB and the pixels of the medium, relative to the mean of b.
struct Off {
  double each = 0, mean = 0;
};
Off off(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0, each = 0, mean = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    if (!(a[i + 3] > 0.01f)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = double(a[i + c]) - double(b[i + c]);
      sum += double(b[i + c]), each += std::abs(d), mean += d;
    }
  }
  return {each / sum, mean / sum};
}

view::PathOptions once() {
  view::PathOptions o;
  o.bounces = 0;
  return o;
}

// Sixteen samples have seen every part of every stratum once. What noise the paths have adds to the mean of
// the differences as squares do; half of that between two halves of them is as large.
TEST(Environments, SixteenSamplesHaveTheLightOfPaths) {
  for (const double g : {0.0, 0.6}) {
    view::RenderScene scene = test::cloudUnder(test::smallEnvironment(), g), longer = scene;
    longer.options.samples = 3072;
    view::PathTracePass paths(longer, once());
    test::runToEnd(paths);
    const std::vector<float> right = view::readBack(*paths.picture())->layers[0].pixels;
    const auto halves = paths.halves().value();
    const double noise = off(halves[0].layers[0].pixels, halves[1].layers[0].pixels).each / 2;
    EXPECT_LE(noise, 0.04);
    for (const auto& [spec, name] : {std::pair{march(), "marched"}, std::pair{dropped(), "dropped"}}) {
      const Off e = off(draw(shadowed(scene, spec)).pixels(), right);
      const double each = std::sqrt(std::max(e.each * e.each - noise * noise, 0.0));
      std::printf("  g %.1f, %s: each %.2f %% (%.2f %% with the paths' %.2f %%), mean %+.3f %%\n", g, name,
                  100 * each, 100 * e.each, 100 * noise, 100 * e.mean);
      EXPECT_LE(each, g > 0 ? 0.03 : 0.01);
      EXPECT_LE(std::abs(e.mean), 0.01);
    }
  }
}

// Where the camera looks along strata through a thin, forward scattering medium no spot is brighter than it
// should be.
TEST(Environments, LeaveNoGhosts) {
  const auto e = test::smallEnvironment();
  view::RenderScene scene;
  scene.options.size = {96, 96};
  scene.options.samples = 16;
  scene.options.camera = {{0, 0, 0}, glm::normalize(dvec3(0.2, 1, -0.2)), {0, 0, 1}, 100};
  scene.volumes = {test::box({0, 6, 0}, {60, 1, 60}, 0.7)};
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(0.6);
  scene.lights = {{scene::environmentLight(e), nullptr}};
  scene = shadowed(scene, march());
  const Drawn drawn = draw(scene);
  view::RenderScene paths = scene;
  paths.options.samples = 512;
  const test::Traced right = test::traced(paths, once());
  const std::vector<float>&a = drawn.pixels(), &b = right.picture.layers[0].pixels,
        &v = right.variance.layers[0].pixels;
  constexpr int kBlocks = 24;
  std::vector<double> residual(kBlocks * kBlocks, 0), error(residual.size(), 0);
  double mean = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const std::size_t pixel = 4 * std::size_t(96 * y + x), block = std::size_t(kBlocks * (y / 4) + x / 4);
      double deviation = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        residual[block] += (double(a[pixel + c]) - double(b[pixel + c])) / 48;
        mean += double(b[pixel + c]) / (3 * 96 * 96);
        deviation += std::sqrt(double(v[pixel + c])) / 3;
      }
      error[block] += deviation * deviation / 256;
    }
  double largest = 0, precision = 0;
  dvec2 worst(0);  // residual and standard error there, of the picture's mean
  int looked = 0, seen = 0;
  const glm::dmat3 axes = scene::basis(scene.options.camera);
  const double half = std::tan(glm::radians(50.0));
  for (int y = 0; y < kBlocks; ++y)
    for (int x = 0; x < kBlocks; ++x) {
      const double r = residual[std::size_t(kBlocks * y + x)],
                   s = std::sqrt(error[std::size_t(kBlocks * y + x)]);
      const dvec2 ndc = 2.0 * (dvec2(x, y) + 0.5) / double(kBlocks) - 1.0;
      const dvec3 d = glm::normalize(axes * dvec3(ndc.x * half, -ndc.y * half, -1));
      const bool near =
          std::any_of(e->strata->strata().begin(), e->strata->strata().end(), [&](const auto& t) {
            return glm::dot(t.mean, d) > 0.6;  // the mean cosine of the lobe
          });
      if (!near) continue;
      bool highest = true;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, kBlocks - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, kBlocks - 1); ++i)
          highest &= residual[std::size_t(kBlocks * j + i)] <= r;
      precision += s / mean, ++seen;
      if (!highest) continue;
      ++looked;
      if (r / s > largest) largest = r / s, worst = dvec2(r, s) / mean;
    }
  precision /= seen;
  std::printf(
      "  %d maxima, the largest %.2f s.e. (%.2f +- %.2f %% of the mean); s.e. %.2f %%; mean %+.2f %%\n",
      looked, largest, 100 * worst.x, 100 * worst.y, 100 * precision, 100 * off(a, b).mean);
  EXPECT_GT(looked, 4);
  EXPECT_LE(precision, 0.02);
  EXPECT_LE(largest, 4);
}

// The same bits whatever the steps are, and wherever marches pause.
TEST(Environments, StepsLeaveNoTrace) {
  view::RenderScene scene = shadowed(test::cloudUnder(test::smallEnvironment(), 0.3), dropped());
  scene.options.samples = 2;
  scene.lights.push_back(test::shadowed(test::sunFrom({0.3, 1, 0.4}, 2), march(), scene.volumes));
  const Drawn whole = draw(scene);
  EXPECT_EQ(draw(scene, 0).pixels(), whole.pixels());
  EXPECT_EQ(draw(scene, 0, 400).pixels(), draw(scene, 1e12, 400).pixels());
  EXPECT_LT(off(draw(scene, 0, 400).pixels(), whole.pixels()).each, 1e-5);
}

// Another camera of a draft takes the suns, as they are; another environment does not.
TEST(Environments, DraftsTakeTheSunsOfTheLast) {
  view::RenderScene scene = shadowed(test::cloudUnder(test::smallEnvironment(), 0.3), dropped());
  scene.options.samples = 1;
  const auto kept = std::make_shared<view::KeptSuns>();
  const Drawn first = draw(scene, 1e12, 0, kept);
  ASSERT_EQ(kept->lights.size(), 16u);
  const auto suns = kept->lights;
  EXPECT_TRUE(suns[3].shadow && suns[3].shadow->block);
  EXPECT_EQ(draw(scene, 1e12, 0, kept).pixels(), first.pixels());
  EXPECT_EQ(draw(scene).pixels(), first.pixels()) << "kept or made anew";
  scene.options.camera.eye.x = 1;
  draw(scene, 1e12, 0, kept);
  for (std::size_t i = 0; i < suns.size(); ++i) EXPECT_EQ(kept->lights[i].shadow, suns[i].shadow);
  auto turned = std::make_shared<scene::Environment>(*scene.lights[0].light.environment);
  turned->rotation = 40;
  scene.lights[0].light = scene::environmentLight(turned);
  scene = shadowed(scene, dropped());
  const Drawn other = draw(scene, 1e12, 0, kept);
  EXPECT_NE(kept->lights[0].shadow, suns[0].shadow);
  // Maps that lie elsewhere in their texture are looked up with other roundings.
  EXPECT_LT(off(draw(scene).pixels(), other.pixels()).each, 1e-5);
}

// One light, one layer; and layers add up to the beauty.
TEST(Environments, AreALayerEach) {
  view::RenderScene scene = shadowed(test::cloudUnder(test::smallEnvironment(), 0.3), march());
  scene.options.samples = 2;
  scene.lights.push_back(test::shadowed(test::sunFrom({0.3, 1, 0.4}, 2), march(), scene.volumes));
  const Drawn beauty = draw(scene);
  std::vector<float> sum(beauty.pixels().size(), 0.0f);
  for (int light = 0; light < 2; ++light) {
    scene.options.layer = {view::PictureLayer::Kind::Light, light};
    const Drawn one = draw(scene);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one.pixels()[i];
  }
  for (std::size_t i = 0; i < sum.size(); i += 4) sum[i + 3] = beauty.pixels()[i + 3];
  EXPECT_LT(off(sum, beauty.pixels()).each, 1e-5);
}

// Comparisons, measurements and the ray scope take it as one light.
TEST(Environments, AreOneLightToWhoeverMeasures) {
  view::RenderScene scene = shadowed(test::cloudUnder(test::smallEnvironment(), 0.3), dropped());
  scene.options.samples = 1;
  scene.lights.push_back(test::shadowed(test::sunFrom({0.3, 1, 0.4}, 2), dropped(), scene.volumes));
  const std::vector<truth::Caster> casters = truth::casters(scene);
  ASSERT_EQ(casters.size(), 2u);
  EXPECT_EQ(casters[0].source.kind, scene::LightKind::Sun);
  EXPECT_EQ(casters[0].source, scene::mainSun(*scene.lights[0].light.environment));
  const auto gpu = test::renderer().gpu();
  const auto probe = truth::probeRay(gpu, scene.lights[0], {0.1, 0, 0.1});
  ASSERT_TRUE(probe) << probe.error().message;
  EXPECT_TRUE(probe->map->block);
  EXPECT_LT(probe->meanError, 0.02);
  const auto again = truth::probeRay(gpu, scene.lights[0], {0, 0.1, 0}, 256, probe->map);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->map, probe->map);
  truth::ShadowErrorPass error(scene, truth::truthOf(scene));
  test::runToEnd(error);
  EXPECT_GT(error.samples(), 0);
  EXPECT_GT(error.mean(), 0);
  EXPECT_LT(error.mean(), 0.02);
}

// Nothing to take light from is black, not an error.
TEST(Environments, ABlackOneIsBlack) {
  scene::EnvironmentMap map{{8, 4}, std::vector<vec3>(32, vec3(0.0f))};
  const auto e = std::make_shared<scene::Environment>(scene::environmentOf(std::move(map)));
  view::RenderScene scene = shadowed(test::cloudUnder(e, 0), dropped());
  scene.options.samples = 2;
  const Drawn drawn = draw(scene);
  for (std::size_t i = 0; i < drawn.pixels().size(); i += 4) ASSERT_EQ(drawn.pixels()[i], 0);
}

}  // namespace
}  // namespace pileus
