// Points and spots in the media, for which places of rays are chosen, and soft suns, whose discs are met by
// direction as well: means that are known, means that must not change, and what either gains.
#include "renderer/base/profile.h"
#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

constexpr double kHaze = 0.15;

double square(double x) { return x * x; }

view::RenderScene haze(double sigma, int samples = 64) {
  view::RenderScene scene;
  scene.options.size = {32, 18};
  scene.options.samples = samples;
  scene.options.camera = {{0.3, 0.4, 6}, {0, 0, 0}, {0, 1, 0}, 40};
  scene.volumes = {test::box({0, 0, 0}, {8, 6, 8}, sigma)};
  scene.volumes[0].medium.albedo = vec3(0.9f);
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(0.3);
  scene.lights = {{test::pointAt({0.2, 0.1, 0}, 5), nullptr}};
  return scene;
}

view::PathOptions options(int bounces, bool alongRays) {
  view::PathOptions o;
  o.bounces = bounces;
  o.alongRays = alongRays;
  return o;
}

void expectSame(const test::Traced& a, const test::Traced& b, double precision, const std::string& what) {
  const double error = std::hypot(a.grayError(), b.grayError());
  std::printf("  %-46s %.5f +- %.5f, %.5f +- %.5f: %+.2f s.e.\n", what.c_str(), a.gray(), a.grayError(),
              b.gray(), b.grayError(), (a.gray() - b.gray()) / error);
  EXPECT_LE(a.grayError(), precision * a.gray()) << what;
  EXPECT_NEAR(a.gray(), b.gray(), 4 * error) << what;
}

// Rays by a point in the haze, against quadrature; the nearest pass it in a hundredth of a metre.
TEST(PathNear, APointInHazeIsExact) {
  for (const double off : {1.0, 0.1, 0.01}) {
    view::RenderScene scene = haze(kHaze);
    const dvec3 eye(0.3, 0.4, 6),
        light = scene.lights[0].light.position,
        target = light + off * glm::normalize(glm::cross(light - eye, dvec3(0, 1, 0)));
    const view::RenderOptions ray = test::rayScene(eye, target, 32, 96).options;
    scene.options = ray;
    const double right =
        test::exactAlong(scene.volumes, {test::exactly(scene.volumes, scene.lights[0].light)}, eye,
                         glm::normalize(target - eye))
            .radiance.x;
    test::expectMean(test::traced(scene, options(0, true)), right, 0.005 * right,
                     fmt::format("{} m beside a point", off));
  }
}

// What is chosen for a light is right for it in all orders, in media of every kind, behind solids.
TEST(PathNear, NoMeanChanges) {
  view::RenderScene scene = haze(0.1, 256);
  scene.volumes.push_back(test::gridInstance(test::gridOf(80, test::blobs), 80, 6));
  scene.volumes.back().medium.phase = scene::doubleHenyeyGreenstein(0.8, -0.4, 0.3);
  scene.lights = {{test::pointAt({0.6, 0.5, 0.3}, 2), nullptr},
                  {test::spotAt({-0.8, 0.9, 0.2}, {0, 0, 0}, 50), nullptr},
                  {test::pointAt({0, 5, 0}, 20), nullptr},  // outside
                  {test::sunFrom({0.5, 0.7, 0.2}), nullptr}};
  scene.solids = {test::solidBox({0.2, -0.9, 0}, {1.5, 0.3, 1})};
  for (const int bounces : {0, -1})
    expectSame(test::traced(scene, options(bounces, true)), test::traced(scene, options(bounces, false)),
               0.01, fmt::format("with a cloud and a solid, {}", bounces == 0 ? "one order" : "all orders"));
  view::RenderScene tinted = scene;
  tinted.volumes[0].medium.extinctionColor = vec3(1.0f, 0.5f, 0.2f);
  const test::Traced a = test::traced(tinted, options(-1, true)),
                     b = test::traced(tinted, options(-1, false));
  for (int c = 0; c < 3; ++c) {
    const double error = std::hypot(a.error[c], b.error[c]);
    std::printf("  colours, channel %d: %.5f, %.5f: %+.2f s.e.\n", c, a.mean[c], b.mean[c],
                (a.mean[c] - b.mean[c]) / error);
    EXPECT_NEAR(a.mean[c], b.mean[c], 4 * error);
  }
  view::RenderScene mapped = scene;
  for (shadow::ShadowedLight& l : mapped.lights)
    l = test::shadowed(l.light, shadow::ShadowSpec{}, scene.volumes, scene.solids);
  expectSame(test::traced(mapped, options(-1, true)), test::traced(scene, options(-1, true)), 0.01,
             "through their maps");
}

// A point light in haze: the variance of pixels, and that times the time, with and without.
TEST(PathNear, GainsInHaze) {
  for (const double sigma : {0.02, kHaze, 0.6}) {
    double cost[2], variance[2];
    for (const bool along : {false, true}) {
      test::traced(haze(sigma, 1), options(0, along));  // compiles
      const Stopwatch clock;
      const test::Traced t = test::traced(haze(sigma, 256), options(0, along));
      variance[along] = square(t.statistics.standardError / t.statistics.mean);
      cost[along] = variance[along] * clock.ms();
    }
    std::printf(
        "  haze of %.2f/m: variance of pixels %.3g without, %.3g with: %.1f times less, %.1f times "
        "less with time\n",
        sigma, variance[0], variance[1], variance[0] / variance[1], cost[0] / cost[1]);
    EXPECT_LT(8 * variance[1], variance[0]) << sigma;
  }
}

TEST(PathNear, WorkOfADispatch) {
  view::PathOptions little = options(-1, true), much = little;
  little.workPerDispatch = 60, much.workPerDispatch = 100000;
  view::RenderScene scene = haze(0.5, 4);
  scene.lights.push_back({test::sunFrom({0.5, 0.7, 0.2}), nullptr});
  scene.lights.back().light.angle = 10;
  const auto a = test::traced(scene, little), b = test::traced(scene, much);
  EXPECT_EQ(a.picture.layers[0].pixels, b.picture.layers[0].pixels);
}

view::RenderScene cloud(double g, int samples) {
  view::RenderScene scene;
  scene.options.size = {32, 18};
  scene.options.samples = samples;
  scene.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 22};
  scene.volumes = {test::gridInstance(test::gridOf(80, test::blobs), 80, 10)};
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(g);
  return scene;
}

std::vector<shadow::ShadowedLight> split(const scene::Light& sun, int parts,
                                         const volume::InstanceList& volumes, bool disc) {
  std::vector<shadow::ShadowedLight> out;
  for (scene::Light& part : scene::splitDisc(sun, parts)) {
    if (!disc) part.angle = 0;
    out.push_back({part, shadow::marchedShadow(part, volumes, {})});
  }
  return out;
}

// The parts of a soft sun, as its node gives them, are one disc: as many suns as a picture holds come near
// it.
TEST(PathWide, ASoftSunIsItsManySuns) {
  for (const double g : {0.0, 0.7}) {
    scene::Light sun = test::sunFrom({0.5, 0.3, -0.6});
    sun.angle = 25;
    view::RenderScene scene = cloud(g, 512), many = scene;
    scene.lights = split(sun, 8, scene.volumes, true);
    many.lights = split(sun, 48, scene.volumes, false);
    for (const int bounces : {0, -1}) {
      const test::Traced a = test::traced(scene, options(bounces, true)),
                         b = test::traced(many, options(bounces, true));
      expectSame(a, b, 0.01, fmt::format("g {}, {}", g, bounces == 0 ? "one order" : "all orders"));
    }
  }
}

// Where the phase function is narrower than the disc, it finds it better: the same mean by less.
TEST(PathWide, ByDiscAndByPhase) {
  for (const double g : {0.0, 0.6, 0.97}) {
    scene::Light sun = test::sunFrom({0.05, 0.1, -1});
    sun.angle = 30;
    view::RenderScene scene = cloud(g, 384), lightOnly = scene;
    scene.lights = split(sun, 1, scene.volumes, true);
    // Shadows of something else than what is drawn: no path may be led there, by its phase, through others.
    volume::InstanceList other = scene.volumes;
    other.push_back(test::box({0, -50, 0}, dvec3(1e-3), 1));
    lightOnly.lights = split(sun, 1, other, true);
    const test::Traced both = test::traced(scene, options(-1, true)),
                       one = test::traced(lightOnly, options(-1, true));
    expectSame(both, one, 0.01, fmt::format("g {}", g));
    const double gain = square(one.statistics.standardError / both.statistics.standardError);
    std::printf("  g %.2f: variance %.2f times less by both\n", g, gain);
    EXPECT_GT(gain, g > 0.9 ? 2 : 0.8) << g;
  }
}

}  // namespace
}  // namespace pileus
