// Overlaps of more volumes than have registers, and of very many: the sum of them all.
#include <fmt/format.h>

#include <random>

#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

std::vector<ShadowSpec> specs() {
  ShadowSpec march;
  march.kind = ShadowSpec::Kind::RayMarch;
  ShadowSpec deep = test::deep(0.003, 48);
  return {march, test::improved(8, 8, 64), deep};
}

/// Rays through `volumes` against their exact integral.
void compareRays(test::Rows& rows, const std::string& what, const volume::InstanceList& volumes,
                 const ShadowSpec& spec, double allowed) {
  const scene::Light sun = test::sunFrom({0.1, 1, 0.2});
  view::RenderScene scene;
  scene.volumes = volumes;
  scene.lights = {test::shadowed(sun, spec, volumes)};
  for (const dvec3& eye : {dvec3(0, 0, 6), dvec3(4, 3, -5), dvec3(0.05, -0.1, 0.02)})
    for (const dvec3& target : {dvec3(0.02, 0.013, 0), dvec3(0.2, -0.15, 0.1)}) {
      const test::Exact right =
          test::exactAlong(volumes, {test::exactly(volumes, sun)}, eye, glm::normalize(target - eye));
      const dvec4 seen = test::onTheAxis(scene, eye, target, 1, 1, 1e-3);
      const std::string row = fmt::format("{}, from ({}, {}, {}) to {}, {}", what, eye.x, eye.y, eye.z,
                                          target.x, shadow::describe(spec));
      rows.check(row, seen.x, right.radiance.x, allowed, 1e-4);
      rows.check(row + ", alpha", seen.w, right.alpha, 0, 2e-3);
    }
}

TEST(Overlaps, SixAndTwelveInOnePlace) {
  test::renderer();
  test::Rows rows("overlaps in one place");
  for (const int count : {4, 6, 12})
    for (const ShadowSpec& spec : specs()) {
      volume::InstanceList same, shifted, turned;
      for (int i = 0; i < count; ++i) {
        same.push_back(test::box({0, 0, 0}, {1, 1, 1}, 1.2 / count + 1e-7 * i));
        shifted.push_back(test::box({0.003 * i, -0.002 * i, 0.001 * i}, {1, 1, 1}, 1.2 / count));
        turned.push_back(test::box({0, 0, 0}, {1, 1, 1}, 1.2 / count, {7.0 * i, 29.0 * i, 3.0 * i}));
      }
      compareRays(rows, fmt::format("{} the same", count), same, spec, 0.015);
      compareRays(rows, fmt::format("{} shifted", count), shifted, spec, 0.015);
      compareRays(rows, fmt::format("{} turned", count), turned, spec, 0.03);
    }
}

TEST(Overlaps, DenseOnesAmongThinOnes) {
  test::renderer();
  test::Rows rows("dense among thin");
  for (const double sigma : {10.0, 1000.0}) {
    volume::InstanceList volumes;
    for (int i = 0; i < 7; ++i) volumes.push_back(test::box({0, 0.01 * i, 0}, {3, 3, 3}, 0.05));
    volumes.push_back(test::box({0, 0, 0}, {0.6, 0.6, 0.6}, sigma));
    volumes.push_back(test::ball({0.1, 0.1, 0.4}, 0.2, sigma));
    for (const ShadowSpec& spec : {specs()[0]})
      compareRays(rows, fmt::format("sigma {}", sigma), volumes, spec, 0.03);
  }
}

TEST(Overlaps, AThousandVolumes) {
  test::renderer();
  test::Rows rows("a thousand volumes");
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-1, 1);
  volume::InstanceList volumes;
  for (int i = 0; i < 1000; ++i)
    volumes.push_back(i % 3 ? test::box({2 * u(rng), 2 * u(rng), 2 * u(rng)}, dvec3(0.3), 0.6 + 0.5 * u(rng),
                                        {90 * u(rng), 90 * u(rng), 90 * u(rng)})
                            : test::ball({2 * u(rng), 2 * u(rng), 2 * u(rng)}, 0.2, 0.6 + 0.5 * u(rng)));
  const scene::Light sun = test::sunFrom({0.1, 1, 0.2});
  ShadowSpec march;
  march.kind = ShadowSpec::Kind::RayMarch;
  view::RenderScene scene;
  scene.volumes = volumes;
  scene.lights = {test::shadowed(sun, march, volumes)};
  for (const dvec3& eye : {dvec3(0, 0.1, 9), dvec3(6, 4, -5)}) {
    const dvec3 target(0.11, 0.07, -0.05);
    const test::Exact right =
        test::exactAlong(volumes, {test::exactly(volumes, sun)}, eye, glm::normalize(target - eye), 4);
    const dvec4 seen = test::onTheAxis(scene, eye, target, 1, 1, 1e-3);
    rows.check(fmt::format("from {}", eye.x), seen.x, right.radiance.x, 0.01);
    rows.check(fmt::format("from {}, alpha", eye.x), seen.w, right.alpha, 0, 2e-3);
  }
}

TEST(Overlaps, MirroredAndSheared) {
  test::renderer();
  test::Rows rows("mirrored and sheared");
  const volume::GridPtr grid = test::gridOf(
      24, [](ivec3 p) { return std::max(0.0f, 1 - glm::length(vec3(p) - vec3(10, 12, 13)) / 11); });
  dmat4 shear(1.0);
  shear[1].x = 0.7, shear[2].y = -0.4;
  for (const dmat4& m :
       {glm::scale(dmat4(1.0), dvec3(-1, 1, 1)), shear, shear * glm::scale(dmat4(1.0), dvec3(1, -0.5, 2)),
        composeTransform({0.1, 0, 0}, {20, 40, 60}, {-0.5, 1.2, -1})}) {
    volume::Instance g = test::gridInstance(grid, 24, 6), b = test::box({0.1, 0, 0}, {0.8, 0.7, 0.9}, 0.7),
                     s = test::ball({-0.1, 0.1, 0}, 0.6, 0.9);
    for (auto* i : {&g, &b, &s}) i->worldFromLocal = m * i->worldFromLocal;
    compareRays(rows, fmt::format("grid, {}", m[0].x), {g}, specs()[0], 0.02);
    compareRays(rows, fmt::format("box, {}", m[0].x), {b}, specs()[0], 0.01);
    compareRays(rows, fmt::format("ball, {}", m[0].x), {s}, specs()[0], 0.01);
    compareRays(rows, fmt::format("all, {}", m[0].x), {g, b, s}, specs()[0], 0.02);
  }
}

}  // namespace
}  // namespace pileus
