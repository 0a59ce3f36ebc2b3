// Paths of one vertex are the single scattering of render.volume: closed forms, and each representation of
// shadow used for the choice alone.
#include <cmath>

#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

constexpr double kSigma = 0.8, kDepth = 2.0, kAlbedo = 0.7;

view::RenderScene slab(bool fromBelow) {
  view::RenderScene scene = test::rayScene({0, fromBelow ? -50.0 : 50.0, 0}, {0, 0, 0}, 32, 64);
  scene.volumes = {test::box({0, 0, 0}, {40, kDepth, 40}, kSigma)};
  scene.volumes[0].medium.albedo = vec3(float(kAlbedo));
  scene.lights = {{test::sunFrom({0, 1, 0}), nullptr}};
  return scene;
}

view::PathOptions once(view::ShadowEstimate estimate) {
  view::PathOptions o;
  o.bounces = 0;
  o.transmittance = estimate;
  return o;
}

TEST(PathSingleOrder, SlabUnderASun) {
  for (const auto estimate : {view::ShadowEstimate::Series, view::ShadowEstimate::Ratio}) {
    const char* name = estimate == view::ShadowEstimate::Series ? "series" : "ratio";
    test::expectMean(test::traced(slab(false), once(estimate)),
                     kAlbedo / (4 * kPi) * (1 - std::exp(-2 * kSigma * kDepth)) / 2,
                     5e-3 * kAlbedo / (4 * kPi), fmt::format("slab, lit side, {}", name));
    test::expectMean(test::traced(slab(true), once(estimate)),
                     kAlbedo / (4 * kPi) * kSigma * kDepth * std::exp(-kSigma * kDepth),
                     5e-3 * kAlbedo / (4 * kPi), fmt::format("slab, against the light, {}", name));
  }
}

// The picture of render.volume with marched shadows, of a cloud with empty space in it, under lights of every
// kind.
TEST(PathSingleOrder, CloudAsItIsMarched) {
  view::RenderScene scene;
  scene.options.size = {32, 18};
  scene.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 22};
  scene.volumes = {test::gridInstance(test::gridOf(80, test::blobs), 80, 10)};
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(0.4);
  for (const scene::Light& light : {test::sunFrom({0.5, 0.7, 0.2}), test::pointAt({0.8, 0.9, 0.3}, 2),
                                    test::spotAt({-0.9, 0.8, 0.5}, {0, 0, 0}, 40)})
    scene.lights.push_back({light, shadow::marchedShadow(light, scene.volumes, {}, 0.25)});
  scene.options.samples = 16;
  scene.options.stepScale = 0.5;
  const image::Image marched = test::render(scene);
  double right = 0;
  for (std::size_t i = 0; i < marched.layers[0].pixels.size(); ++i)
    right += i % 4 == 3 ? 0 : double(marched.layers[0].pixels[i]) / (3.0 * 32 * 18);
  scene.options.samples = 768;
  for (const auto estimate : {view::ShadowEstimate::Series, view::ShadowEstimate::Ratio}) {
    const test::Traced t = test::traced(scene, once(estimate));
    test::expectMean(t, right, 0.005 * right,
                     estimate == view::ShadowEstimate::Series ? "cloud, series" : "cloud, ratio");
    EXPECT_NEAR(
        t.alpha,
        [&] {
          double sum = 0;
          for (std::size_t i = 3; i < marched.layers[0].pixels.size(); i += 4)
            sum += double(marched.layers[0].pixels[i]) / (32 * 18);
          return sum;
        }(),
        2e-3);
  }
}

// Radiance gained along a ray is what is emitted, through what is in front of it.
TEST(PathSingleOrder, Emission) {
  view::RenderScene scene = test::rayScene({0, 0, 5}, {0, 0, 0}, 32, 64);
  volume::Instance fire = test::box({0, 0, 0}, {2, 2, 2}, 0);
  fire.density = 1;
  fire.emission =
      volume::makeRemap(0, 1, std::vector<vec4>(volume::kRemapEntries, vec4(0.5f, 0.5f, 0.5f, 0.5f)));
  scene.volumes = {fire};
  EXPECT_NEAR(test::traced(scene).gray(), 1.0, 1e-5);
  EXPECT_EQ(test::traced(scene).alpha, 0.0);
  scene.volumes = {fire, test::box({0, 0, 0}, {2, 2, 2}, 1)};
  scene.volumes[1].medium.albedo = vec3(0.0f);
  test::expectMean(test::traced(scene), 0.5 * (1 - std::exp(-2.0)), 0.005 * 0.43, "fire in absorbing smoke");
}

}  // namespace
}  // namespace pileus
