// Scenes nobody means to make, which must come out right or at least finite.
#include <fmt/format.h>

#include <cmath>

#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

ShadowSpec marched() {
  ShadowSpec s;
  s.kind = ShadowSpec::Kind::RayMarch;
  return s;
}

/// Voxels with much detail, `size` metres across and about as many times as dense.
volume::Instance blobs(double size, double depth) {
  static const volume::GridPtr grid = test::gridOf(80, test::blobs);
  volume::Instance i = test::gridInstance(grid, 80, depth / size);
  i.worldFromLocal = glm::scale(dmat4(1.0), dvec3(size)) * i.worldFromLocal;
  return i;
}

/// Rays from a camera five sizes away.
void compareRays(test::Rows& rows, const std::string& what, const volume::Instance& grid, double size,
                 const ShadowSpec& spec, double allowed, double dark) {
  const scene::Light sun = test::sunFrom({0.3, 0.8, 0.6});
  view::RenderScene scene;
  scene.volumes = {grid};
  scene.lights = {test::shadowed(sun, spec, {grid})};
  for (const dvec3& to : {dvec3(0.15, 0.25, 0.1), dvec3(-0.24, -0.2, -0.16), dvec3(0.2, 0.2, 0.2)}) {
    const dvec3 eye = size * dvec3(1.5, 2, 4.5), target = size * to;
    const test::Exact right =
        test::exactAlong({grid}, {test::exactly({grid}, sun)}, eye, glm::normalize(target - eye), 50);
    for (const double step : {0.5, 1.0, 4.0}) {
      const dvec4 seen = test::onTheAxis(scene, eye, target, 1, step, 1e-4);
      rows.check(fmt::format("{}, target {}, step {}, {}", what, to.x, step, shadow::describe(spec)), seen.x,
                 right.radiance.x, step > 1 ? 3 * allowed : allowed, dark);
      rows.check(fmt::format("{}, target {}, step {}, alpha", what, to.x, step), seen.w, right.alpha, 0,
                 step > 1 ? 0.01 : 5e-3);
    }
  }
}

TEST(Extremes, DenserAndDenserVoxels) {
  test::renderer();
  test::Rows rows("denser and denser");
  for (const double depth : {3.0, 30.0, 3e3, 3e4})
    compareRays(rows, fmt::format("depth {}", depth), blobs(1, depth), 1, marched(), 0.04, 1e-4);
}

TEST(Extremes, AnySize) {
  test::renderer();
  test::Rows rows("any size");
  for (const double size : {1e-6, 1e-3, 1e3, 1e6})
    for (const ShadowSpec& spec : {marched(), test::improved(4, 8, 256)})
      compareRays(rows, fmt::format("{} m across", size), blobs(size, 5), size, spec,
                  spec.kind == ShadowSpec::Kind::RayMarch ? 0.02 : 0.05, 2e-3);
}

TEST(Extremes, PositionsTimesAnythingAndExtinctionOverItAreTheSamePicture) {
  test::renderer();
  test::Rows rows("scaled scenes");
  const auto picture = [](double by, const ShadowSpec& spec) {
    volume::InstanceList volumes{blobs(by, 5),
                                 test::box(by * dvec3(0.3, 0, 0), by * dvec3(0.5, 0.6, 0.4), 1.3 / by)};
    view::RenderScene scene;
    scene.volumes = volumes;
    scene.options.size = ivec2(32, 18);
    scene.options.samples = 1;
    scene.options.camera = {by * dvec3(1, 0.7, 2.2), dvec3(0), {0, 1, 0}, 40};
    scene.lights = {test::shadowed(test::sunFrom({0.3, 0.8, 0.6}), spec, volumes)};
    scene::Light point = test::pointAt(by * dvec3(-0.4, 0.5, 0.7), float(by * by));
    point.radius = 0;
    scene.lights.push_back(test::shadowed(point, spec, volumes));
    return test::render(scene);
  };
  for (const ShadowSpec& spec : {marched(), test::improved(4, 8, 128)}) {
    const image::Image one = picture(1, spec);
    for (const double by : {1e-6, 1e-3, 1e3, 1e6}) {
      const image::Image other = picture(by, spec);
      double worst = 0, most = 0;
      for (std::size_t i = 0; i < one.layers[0].pixels.size(); ++i) {
        worst =
            std::max(worst, std::abs(double(one.layers[0].pixels[i]) - double(other.layers[0].pixels[i])));
        most = std::max(most, double(one.layers[0].pixels[i]));
        if (!std::isfinite(other.layers[0].pixels[i])) worst = 1e30;
      }
      rows.check(fmt::format("times {}, {}", by, shadow::describe(spec)), worst / most, 0, 0, 3e-3);
    }
  }
}

TEST(Extremes, PicturesOfOnePixel) {
  test::renderer();
  test::Rows rows("one pixel");
  const volume::InstanceList volumes{test::box({0, 0, 0}, {3, 1, 1}, 40)};
  const scene::Light sun = test::sunFrom({0, 0.6, 0.8});
  for (const ivec2 size : {ivec2(1, 1), ivec2(1, 7), ivec2(7, 1)})
    for (const double fov : {0.01, 1.0, 25.0}) {
      view::RenderOptions o;
      o.size = size;
      o.samples = 4096;
      o.camera = {{0, 0, 3}, {0, 0, 0}, {0, 1, 0}, fov};
      const auto light = test::shadowed(sun, marched(), volumes);
      const dvec4 m = test::meanOf(test::render(o, volumes, {light}));
      // By rays of its own, spread evenly.
      dvec4 right(0);
      constexpr int kRays = 120;
      for (int y = 0; y < kRays; ++y)
        for (int x = 0; x < kRays; ++x) {
          const dvec3 d =
              scene::rayDirection(o.camera, double(size.x) / size.y, (dvec2(x, y) + 0.5) / double(kRays));
          const test::Exact e = test::exactAlong(volumes, {test::exactly(volumes, sun)}, o.camera.eye, d, 4);
          right += dvec4(e.radiance, e.alpha) / double(kRays * kRays);
        }
      const std::string what = fmt::format("{} x {}, fov {}", size.x, size.y, fov);
      // Of 4,096 rays or more one in three meets the box at least.
      rows.check(what + ", radiance", m.x, right.x, 0.05);
      rows.check(what + ", alpha", m.w, right.w, 0.05);
    }
}

TEST(Extremes, NearlyNoThickness) {
  test::renderer();
  test::Rows rows("nearly no thickness");
  const scene::Light sun = test::sunFrom({0.3, 0.5, 0.8});
  for (const double h : {1e-4, 1e-6, 1e-8, 1e-12, 0.0})
    for (const double sigma : {1.0, 1e4})
      for (const ShadowSpec& spec :
           {marched(), test::improved(4, 8, 64), test::deep(0.01, 64), test::fourier(7, 64)}) {
        const volume::InstanceList volumes{test::box({0, 0, 0}, {1, 1, h}, sigma),
                                           test::box({0, 0, -1}, {1, 1, 0.5}, 2)};
        view::RenderScene scene;
        scene.volumes = volumes;
        scene.lights = {test::shadowed(sun, spec, volumes)};
        const double tau = sigma * h + 1;
        const dvec4 seen = test::onTheAxis(scene, {0, 0, 3}, dvec3(0), 1, 1);
        rows.check(fmt::format("{} m, sigma {}, {}", h, sigma, shadow::describe(spec)), seen.w,
                   -std::expm1(-tau), 0, 3e-3);
        EXPECT_TRUE(std::isfinite(seen.x) && seen.x >= 0);
      }
}

TEST(Extremes, ExtinctionBeyondAllMeasure) {
  test::renderer();
  test::Rows rows("beyond all measure");
  for (const double sigma : {1e6, 1e8, 1e12, 1e20, 1e30})
    for (const bool grid : {false, true})
      for (const ShadowSpec& spec :
           {marched(), test::improved(4, 8, 64), test::deep(0.01, 64), test::fourier(7, 64)}) {
        volume::Instance v = grid ? blobs(1, sigma) : test::box({0, 0, 0}, {1, 1, 1}, sigma);
        view::RenderScene scene;
        scene.volumes = {v};
        scene.lights = {test::shadowed(test::sunFrom({0, 0, 1}), spec, {v})};
        const dvec3 target(0.15, 0.25, 0.1);
        const dvec4 seen = test::onTheAxis(scene, {0.15, 0.25, 4}, target, 1, 1);
        const std::string what =
            fmt::format("sigma {}, {}, {}", sigma, grid ? "grid" : "box", shadow::describe(spec));
        rows.check(what + ", alpha", seen.w, 1, 0, 1e-3);
        EXPECT_TRUE(std::isfinite(seen.x)) << what;
        // Its skin is thinner than floats can tell four metres away; it is never brighter than without
        // shadow.
        if (!grid && spec.kind == ShadowSpec::Kind::RayMarch) {
          EXPECT_LT(seen.x, 2.01 / (8 * kPi)) << what;
        }
      }
}

TEST(Extremes, SmokeTenThousandTimesAsDenseAndAMillionthAsLarge) {
  PILEUS_NEEDS_DATA();
  test::renderer();
  test::Rows rows("smoke1");
  const volume::Instance smoke = test::smoke1();
  const Box3 bounds = volume::worldBounds(smoke);
  const scene::Light sun = test::sunFrom({0.3, 0.8, 0.5});
  for (const double denser : {1.0, 100.0, 1e4})
    for (const double smaller : {1.0, 1e-6}) {
      volume::Instance v = smoke;
      v.worldFromLocal = glm::scale(dmat4(1.0), dvec3(smaller)) * v.worldFromLocal;
      v.medium.extinction *= denser / smaller;
      view::RenderScene scene;
      scene.volumes = {v};
      scene.lights = {test::shadowed(sun, marched(), {v})};
      const dvec3 middle = smaller * bounds.center();
      for (const dvec3& part : {dvec3(0), dvec3(0.1, 0.2, 0), dvec3(-0.1, -0.25, 0)}) {
        const dvec3 target = middle + smaller * part * bounds.size(),
                    eye = target + smaller * glm::length(bounds.size()) * dvec3(0.4, 0.2, 1.6);
        const test::Exact right =
            test::exactAlong({v}, {test::exactly({v}, sun)}, eye, glm::normalize(target - eye), 50);
        const dvec4 seen = test::onTheAxis(scene, eye, target, 1, 1, 1e-3);
        const std::string what = fmt::format("{} times as dense, size {}, place {}", denser, smaller, part.y);
        // At 10,000 times the density a voxel is 10,000 deep: what of it is lit lies between two floats.
        rows.check(what, seen.x, right.radiance.x, denser > 1e3 ? 0.25 : 0.03, 5e-4);
        rows.check(what + ", alpha", seen.w, right.alpha, 0, 5e-3);
      }
    }
}

}  // namespace
}  // namespace pileus
