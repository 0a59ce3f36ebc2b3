// Emission in pictures: closed forms, what is in front of it, no shadow of it, and its layer.
#include <algorithm>
#include <cmath>

#include "renderer/residency/volume_set.h"
#include "renderer/shadow/reference.h"
#include "renderer/truth/compare.h"
#include "renderer/truth/shadow_error.h"
#include "renderer/volume/emission.h"
#include "tests/support/lit.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using test::along;
using Kind = view::PictureLayer::Kind;

double straight(double part) { return part; }

volume::Instance glowing(volume::Instance i, double strength) {
  i.emission = volume::makeEmission(0, 1, straight, {1000, 2000, strength});
  return i;
}

/// A box of `strength` [W/(m^3 sr)] luminance: its density 1 is the hottest.
volume::Instance fire(const dvec3& center, const dvec3& size, double strength) {
  volume::Instance i = test::box(center, size, 1);
  i.density = 1;
  return glowing(i, strength);
}

dvec3 perMetre(const volume::Instance& i) { return volume::emissionAt(i, dvec3(i.worldFromLocal[3])); }

void expectNear(const vec4& got, const dvec3& want, double tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], tolerance * want[c]) << c;
}

const dvec3 kEye(0.1, 0.2, 6), kTarget(0.1, 0.2, 0);

view::RenderScene sceneOf(volume::InstanceList volumes) {
  view::RenderScene scene;
  scene.volumes = std::move(volumes);
  return scene;
}

TEST(Emission, ABoxGivesStrengthTimesLength) {
  const volume::Instance box = fire(dvec3(0), {1, 1, 0.8}, 3);
  const vec4 seen = along(kEye, kTarget, sceneOf({box}));
  expectNear(seen, 0.8 * perMetre(box), 1e-4);
  EXPECT_EQ(seen.a, 0) << "it covers nothing";
  volume::Instance ball = glowing(test::ball(dvec3(0), 0.7, 1), 3);
  ball.density = 1;
  expectNear(along(dvec3(0, 0, 6), dvec3(0), sceneOf({ball})), 1.4 * perMetre(ball), 1e-3);
}

TEST(Emission, InUniformSmokeItHasItsClosedForm) {
  for (const double sigma : {1e-5, 0.5, 3.0, 40.0}) {
    const volume::Instance box = fire(dvec3(0), {1, 1, 0.8}, 3),
                           smoke = test::box(dvec3(0), {1, 1, 0.8}, sigma);
    const vec4 seen = along(kEye, kTarget, sceneOf({box, smoke}));
    expectNear(seen, perMetre(box) * (-std::expm1(-sigma * 0.8) / sigma), 5e-4);
    EXPECT_NEAR(seen.a, -std::expm1(-sigma * 0.8), 2e-4);
  }
}

TEST(Emission, IsDimmedByWhatIsInFrontOfItAlone) {
  const volume::Instance box = fire(dvec3(0), {1, 1, 0.8}, 3), front = test::box({0, 0, 2}, {1, 1, 0.5}, 1.7),
                         behind = test::box({0, 0, -2}, {1, 1, 0.5}, 1.7);
  expectNear(along(kEye, kTarget, sceneOf({box, front})), 0.8 * perMetre(box) * std::exp(-0.85), 5e-4);
  expectNear(along(kEye, kTarget, sceneOf({box, behind})), 0.8 * perMetre(box), 5e-4);
  view::RenderScene scene = sceneOf({box});
  scene.solids = {test::solidBox({0, 0, 0}, {1, 1, 0.4})};
  const vec4 cut = along(kEye, kTarget, scene);
  expectNear(cut, 0.2 * perMetre(box), 1e-3);
  EXPECT_EQ(cut.a, 1);
}

TEST(Emission, AGridIsWhatTheCpuIntegrates) {
  const volume::Instance grid = glowing(test::gridInstance(test::gridOf(80, test::blobs), 80, 1), 5);
  double largest = 0;
  for (const dvec2 at : {dvec2(-0.22, -0.2), dvec2(0.16, 0.25), dvec2(0, 0), dvec2(0.45, -0.45)}) {
    const dvec3 eye(at, 3), target(at, 0);
    dvec3 want(0);
    constexpr int kSteps = 4000;
    for (int k = 0; k < kSteps; ++k)
      want += volume::emissionAt(grid, dvec3(at, 0.5 - (k + 0.5) / kSteps)) / double(kSteps);
    view::RenderScene scene = sceneOf({grid});
    scene.options.stepScale = 0.25;
    const vec4 seen = along(eye, target, scene);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], want[c], 0.01 * want[c] + 1e-4) << c;
    largest = std::max(largest, want.r);
  }
  EXPECT_GT(largest, 0.3);
}

volume::InstanceList crowd() {
  static const volume::GridPtr grid = test::gridOf(80, test::blobs);
  volume::InstanceList volumes;
  for (int k = 0; k < 8; ++k) {
    volume::Instance i = test::gridInstance(grid, 80, 2);
    i.worldFromLocal = glm::translate(dmat4(1.0), dvec3(0.02 * k, 0, 0.01 * k)) * i.worldFromLocal;
    volumes.push_back(k % 2 ? glowing(i, 1 + k) : i);
  }
  volumes.push_back(fire({0, 0, 0}, {0.5, 0.5, 0.5}, 0.4));
  return volumes;
}

view::RenderScene crowded(view::PictureLayer layer = {}) {
  view::RenderScene scene = sceneOf(crowd());
  scene.options.size = ivec2(24);
  scene.options.samples = 2;
  scene.options.camera.eye = {0.3, 0.2, 4};
  scene.options.layer = layer;
  scene.solids = {test::solidPlane({0, -0.6, 0}, {3, 1, 3})};
  const scene::Light sun = test::sunFrom({0.3, 1, 0.4}, 5);
  scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, {})},
                  {test::sunFrom({-1, 1, 0.4}, 1), nullptr}};
  return scene;
}

std::vector<float> pixels(const view::RenderScene& scene, int pauseAfter) {
  test::renderer();
  view::VolumeRenderPass pass(scene);
  pass.pauseAfter(pauseAfter);
  while (pass.step(test::renderer().gpu(), 1e12).value() < 1) {
  }
  return view::readBack(*pass.picture()).value().layers[0].pixels;
}

TEST(Emission, PausesAndOverlapsLeaveNoTrace) {
  for (const auto layer : {view::PictureLayer{}, view::PictureLayer{Kind::Emission, 0}}) {
    const auto whole = pixels(crowded(layer), residency::MarchBudget::kNever);
    for (const int pause : {60, 300}) {
      const auto paused = pixels(crowded(layer), pause);
      float worst = 0;
      for (std::size_t i = 0; i < whole.size(); ++i) worst = std::max(worst, std::abs(whole[i] - paused[i]));
      EXPECT_LT(worst, 2e-5f) << pause;
    }
    EXPECT_GT(*std::max_element(whole.begin(), whole.end()), 0.5f);
  }
}

TEST(Emission, ManyOverlapsGiveWhatFewDo) {
  // More than march together in registers: the sum of what each adds alone, for nothing is in front of it.
  view::RenderScene all = sceneOf({});
  dvec3 want(0);
  for (int k = 0; k < 7; ++k) {
    all.volumes.push_back(fire({0, 0, 0.05 * k}, {1, 1, 0.4 + 0.1 * k}, 1 + k));
    want += (0.4 + 0.1 * k) * perMetre(all.volumes.back());
  }
  expectNear(along(kEye, kTarget, all), want, 2e-4);
}

TEST(Emission, LayersAddUpToThePicture) {
  const auto run = [](view::PictureLayer layer) {
    return pixels(crowded(layer), residency::MarchBudget::kNever);
  };
  const auto all = run({}), one = run({Kind::Light, 0}), two = run({Kind::Light, 1}),
             glow = run({Kind::Emission, 0});
  float lit = 0, bright = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 4 == 3) {
      EXPECT_EQ(all[i], glow[i]);
      EXPECT_EQ(all[i], one[i]);
      continue;
    }
    EXPECT_NEAR(all[i], one[i] + two[i] + glow[i], 1e-5f + 1e-4f * all[i]);
    lit = std::max(lit, one[i]), bright = std::max(bright, glow[i]);
  }
  EXPECT_GT(lit, 0.05f);
  EXPECT_GT(bright, 0.3f);
}

TEST(Emission, AFinishedPictureStaysAsItIs) {
  view::RenderScene scene = crowded();
  test::renderer();
  view::VolumeRenderPass pass(scene);
  while (pass.step(test::renderer().gpu(), 1e12).value() < 1) {
  }
  const auto before = view::readBack(*pass.picture()).value().layers[0].pixels;
  for (int k = 0; k < 3; ++k) EXPECT_EQ(pass.step(test::renderer().gpu(), 0).value(), 1);
  EXPECT_EQ(view::readBack(*pass.picture()).value().layers[0].pixels, before);
}

TEST(Emission, CastsNoShadowInAnyRepresentation) {
  const volume::Instance smoke = test::box({0, 0.5, 0}, {0.6, 0.4, 0.6}, 2),
                         flame = fire({0.6, -1, 0.3}, {2, 3, 2}, 5);
  const scene::Light sun = test::sunFrom({0.2, 1, 0.1});
  shadow::ShadowSpec march;
  march.kind = shadow::ShadowSpec::Kind::RayMarch;
  std::vector<vec3> below;
  for (int k = 0; k < 50; ++k)
    below.push_back(vec3(-0.4f + 0.08f * float(k % 10), 0.28f + 0.1f * float(k / 10), 0.05f));
  for (const shadow::ShadowSpec& spec : {test::improved(4, 8, 128), test::fourier(7),
                                         test::transmittance(7, shadow::Basis::Cosine), test::deep(0.001)}) {
    const auto alone = test::build(spec, {smoke}, sun), both = test::build(spec, {smoke, flame}, sun);
    EXPECT_EQ(both->frustum.worldFromLight, alone->frustum.worldFromLight) << "it is fitted to the smoke";
    EXPECT_EQ(test::lookupTau(*both, sun, below), test::lookupTau(*alone, sun, below));
  }
  EXPECT_NEAR(shadow::opticalDepthToLight({smoke, flame}, sun, {0, -1, 0}),
              shadow::opticalDepthToLight({smoke}, sun, {0, -1, 0}), 1e-12);
  EXPECT_TRUE(residency::canonical({flame}).empty());
  EXPECT_EQ(residency::canonicalWithEmission({flame, smoke}).size(), 2u);
  // Seen: a marched shadow through both lights the smoke as one through the smoke does.
  view::RenderScene scene = sceneOf({smoke});
  scene.lights = {test::shadowed(sun, march, {smoke})};
  const dvec3 eye(0, 0.5, 5), target(0, 0.5, 0);
  const vec4 plain = along(eye, target, scene);
  scene.lights = {test::shadowed(sun, march, {smoke, flame})};
  EXPECT_EQ(along(eye, target, scene), plain);
  EXPECT_GT(plain.r, 0.01f);
}

TEST(Emission, IsNoSampleOfTheShadowsError) {
  const scene::Light sun = test::sunFrom({0.3, 1, 0.2}, 3);
  const volume::Instance smoke = test::box({0, 0.3, 0}, {0.8, 0.5, 0.8}, 3);
  const auto figures = [&](const volume::InstanceList& volumes) {
    view::RenderScene scene = sceneOf(volumes);
    scene.options.size = ivec2(24);
    scene.options.samples = 1;
    scene.options.camera = {dvec3(0.5, 0.6, 4), dvec3(0), dvec3(0, 1, 0), 40};
    scene.lights = {{sun, test::build(test::fourier(3), volumes, sun)}};
    truth::ComparePass pass(scene);
    while (pass.step(test::renderer().gpu(), 1e9).value() < 1) {
    }
    return pass.figures();
  };
  test::renderer();
  const auto alone = figures({smoke}), both = figures({smoke, fire({0, 0.3, 0}, {1.4, 1.4, 1.4}, 4)});
  EXPECT_GT(alone.shadow.mean, 0.001);
  EXPECT_EQ(both.samples, alone.samples);
  EXPECT_EQ(both.shadow.mean, alone.shadow.mean);
}

TEST(Emission, DepthIsThatOfTheSmoke) {
  const volume::Instance smoke = test::box({0, 0, -1}, {1, 1, 1}, 60);
  view::RenderScene scene = sceneOf({smoke, fire({0, 0, 1}, {1, 1, 1}, 9)});
  scene.options.layer = {Kind::Depth, 0};
  EXPECT_NEAR(along(dvec3(0, 0, 6), dvec3(0), scene).r, 6.5 + 1.0 / 60, 0.02);
}

}  // namespace
}  // namespace pileus
