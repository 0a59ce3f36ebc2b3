// Extinction that differs from channel to channel, in pictures, through shadows of all kinds: against
// unbiased paths.
#include <cmath>

#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

view::RenderScene sceneOf(const volume::InstanceList& volumes, view::Scattering scattering) {
  view::RenderScene scene;
  scene.options.size = {48, 28};
  scene.options.samples = 8;
  scene.options.camera = {{0, 0.2, 2.4}, {0, 0, 0}, {0, 1, 0}, 28};
  scene.options.scatter.kind = scattering;
  scene.volumes = volumes;
  return scene;
}

volume::Instance cloud(const vec3& color, double g = 0.5) {
  volume::Instance i = test::gridInstance(test::gridOf(80, test::blobs), 80, 20);
  i.medium.albedo = vec3(0.9f);
  i.medium.extinctionColor = color;
  i.medium.phase = scene::henyeyGreenstein(g);
  return i;
}

dvec3 meanOf(const image::Image& picture, double* alpha = nullptr) {
  const std::vector<float>& p = picture.layers[0].pixels;
  dvec3 sum(0);
  double covered = 0;
  for (std::size_t i = 0; i < p.size(); i += 4)
    sum += dvec3(p[i], p[i + 1], p[i + 2]), covered += double(p[i + 3]);
  if (alpha) *alpha = 4 * covered / double(p.size());
  return 4.0 * sum / double(p.size());
}

/// Means of the channels, of the picture over those of paths.
dvec3 ratios(const view::RenderScene& scene, int samples, const std::string& what) {
  view::RenderScene truth = scene;
  truth.options.samples = samples;
  view::PathOptions options;
  options.bounces = scene.options.scatter.kind == view::Scattering::Single ? 0 : -1;
  view::PathTracePass judge(truth, options);
  test::runToEnd(judge);
  double covered = 0, right = 0;
  const dvec3 fast = meanOf(test::render(scene), &covered),
              paths = meanOf(view::readBack(*judge.picture()).value(), &right), out = fast / paths;
  std::printf("  %-34s %.4f %.4f %.4f of paths, alpha %.4f of them\n", what.c_str(), out.x, out.y, out.z,
              covered / right);
  EXPECT_NEAR(covered / right, 1, 0.01) << what;
  return out;
}

void expectNear(const dvec3& ratios, double within) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratios[c], 1, within) << c;
}

TEST(Colors, OfOneMediumAreThoseOfPaths) {
  for (const view::Scattering how : {view::Scattering::Single, view::Scattering::Grid})
    for (const double g : {0.0, 0.7}) {
      view::RenderScene scene = sceneOf({cloud({0.4f, 0.8f, 1.8f}, g)}, how);
      const scene::Light sun = test::sunFrom({0.7, 0.5, 0.4}, 10);
      scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, scene.solids)}};
      const bool single = how == view::Scattering::Single;
      expectNear(ratios(scene, single ? 64 : 512, fmt::format("{}, g {}", enumId(how), g)),
                 single ? 0.02 : 0.06);
    }
}

/// Each channel has shadows of its own.
TEST(Colors, OfTwoMediaAreThoseOfPaths) {
  for (const view::Scattering how : {view::Scattering::Single, view::Scattering::Grid}) {
    view::RenderScene scene = sceneOf({cloud({0.4f, 0.8f, 1.8f}), test::ball({0.3, 0.1, 0.2}, 0.3, 4)}, how);
    scene.volumes[1].medium.extinctionColor = {1.6f, 1, 0.4f};
    scene.volumes[1].medium.albedo = vec3(0.9f);
    scene.volumes[1].medium.phase = scene.volumes[0].medium.phase;
    const scene::Light sun = test::sunFrom({0.7, 0.5, 0.4}, 10);
    scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, scene.solids)}};
    const bool single = how == view::Scattering::Single;
    expectNear(ratios(scene, single ? 256 : 1024, fmt::format("two media, {}", enumId(how))),
               single ? 0.02 : 0.06);
  }
}

TEST(Colors, ReachSolidsBehind) {
  view::RenderScene scene = sceneOf({test::box({0, 0, 0}, {1, 1, 0.5}, 3)}, view::Scattering::Single);
  scene.volumes[0].medium.extinctionColor = {0.4f, 0.8f, 1.8f};
  scene.volumes[0].medium.albedo = vec3(0.5f);
  scene.solids = {test::solidPlane({0, -0.6, 0}, {3, 1, 3})};
  const scene::Light sun = test::sunFrom({0.2, 1, 0.1}, 10);
  scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, scene.solids)}};
  expectNear(ratios(scene, 256, "a box above a ground"), 0.02);
}

/// White light alone through gray media is the same with and without.
TEST(Colors, OfGrayMediaChangeNothing) {
  for (const view::Scattering how : {view::Scattering::Single, view::Scattering::Grid}) {
    view::RenderScene scene = sceneOf({cloud(vec3(1))}, how);
    const scene::Light sun = test::sunFrom({0.7, 0.5, 0.4}, 10);
    scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, scene.solids)}};
    const image::Image gray = test::render(scene);
    volume::Instance nothing = test::box({0, 0, 0}, {0.1, 0.1, 0.1}, 1e-9);
    nothing.medium.extinctionColor = {1, 0.5f, 0.2f};
    scene.volumes.push_back(nothing);
    EXPECT_LT(test::largestDifference(test::render(scene), gray), 2e-2 * meanOf(gray).x) << enumId(how);
  }
}

/// A march that takes several dispatches keeps the colours of what it has seen.
TEST(Colors, AreTheSameHoweverWorkIsCut) {
  view::RenderScene scene = sceneOf({cloud({0.4f, 0.8f, 1.8f})}, view::Scattering::Grid);
  const scene::Light sun = test::sunFrom({0.7, 0.5, 0.4}, 10);
  scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, scene.solids)}};
  const image::Image whole = test::render(scene);
  view::VolumeRenderPass pass(scene);
  pass.pauseAfter(3);
  test::runToEnd(pass);
  const image::Image cut = view::readBack(*pass.picture()).value();
  EXPECT_LT(test::largestDifference(cut, whole), 1e-5 * meanOf(whole).x);
}

}  // namespace
}  // namespace pileus
