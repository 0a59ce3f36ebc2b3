// Point and spot lights of any distance, in haze and out of it, against quadrature in double precision.
#include <fmt/format.h>

#include <cmath>

#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

std::vector<ShadowSpec> specs(int resolution = 128) {
  ShadowSpec march;
  march.kind = ShadowSpec::Kind::RayMarch;
  return {march, test::improved(4, 8, resolution)};
}

TEST(LocalLights, ASceneInMillimetresUnderADefaultPointLight) {
  test::renderer();
  test::Rows rows("millimetres");
  const double mm = 1e-3;
  const volume::InstanceList volumes{test::box({0, 0, 0}, dvec3(4 * mm), 0.3 / mm)};
  for (const dvec3& at : {dvec3(0, 5, 0), dvec3(3, 2.5, 1), dvec3(0.4, 0.3, 0.2)}) {
    scene::Light light;  // its radius is nobody's choice
    light.kind = scene::LightKind::Point;
    light.position = mm * at;
    light.emitted = vec3(1e-5f);
    const dvec3 eye = mm * dvec3(3, 2, 14);
    for (const ShadowSpec& spec : specs())
      for (const dvec3& target : {dvec3(0), mm * dvec3(1.1, 0.4, 0), mm * dvec3(-0.9, -1.2, 0.3)}) {
        view::RenderScene scene;
        scene.volumes = volumes;
        scene.lights = {test::shadowed(light, spec, volumes)};
        scene::Light point = light;
        point.radius = 0;
        const double right =
            test::exactAlong(volumes, {test::exactly(volumes, point)}, eye, glm::normalize(target - eye))
                .radiance.x;
        for (const double step : {1.0, 4.0})
          rows.check(fmt::format("light at ({}, {}, {}) mm, target ({:.1f}, {:.1f}), step {}, {}", at.x, at.y,
                                 at.z, target.x / mm, target.y / mm, step, shadow::describe(spec)),
                     test::onTheAxis(scene, eye, target, 1, step).x, right, 0.02);
      }
  }
}

/// A picture of haze with a light in it, pixel centres in `size` x `size` times `fine` squared.
std::vector<double> exactPicture(const volume::InstanceList& volumes, const scene::Light& light,
                                 const scene::Camera& camera, int size, int fine) {
  std::vector<double> out(std::size_t(size * size), 0.0);
  const test::ExactLight exact = test::exactly(volumes, light);
  for (int y = 0; y < size * fine; ++y)
    for (int x = 0; x < size * fine; ++x)
      out[std::size_t(y / fine * size + x / fine)] +=
          test::exactAlong(volumes, {exact}, camera.eye,
                           scene::rayDirection(camera, 1, (dvec2(x, y) + 0.5) / double(size * fine)), 16)
              .radiance.x /
          (fine * fine);
  return out;
}

void compareHaze(const char* table, bool grid, double g) {
  test::renderer();
  test::Rows rows(table);
  constexpr int kSize = 24;
  volume::Instance haze = test::box({0, 0, 0}, {20, 20, 20}, 0.02);
  if (grid) {
    static const volume::GridPtr full = test::gridOf(32, [](ivec3) { return 1.0f; });
    haze = test::gridInstance(full, 32, 0.02);
    haze.worldFromLocal = glm::scale(dmat4(1.0), dvec3(20)) * haze.worldFromLocal;
  }
  haze.medium.phase = scene::henyeyGreenstein(g);
  const volume::InstanceList volumes{haze};
  scene::Light light = test::pointAt({0.31, 0.17, 0.2}, 100);
  light.radius = 0;
  const scene::Camera camera{{1, 2, 25}, {0, 0, 0}, {0, 1, 0}, 40};
  const std::vector<double> right = exactPicture(volumes, light, camera, kSize, 6),
                            centres = exactPicture(volumes, light, camera, kSize, 1);
  double meanRight = 0, meanCentres = 0;
  for (const double v : right) meanRight += v / (kSize * kSize);
  for (const double v : centres) meanCentres += v / (kSize * kSize);
  for (const ShadowSpec& spec : specs())
    for (const double step : {0.5, 1.0, 4.0})
      for (const int samples : {1, 16}) {
        view::RenderOptions o;
        o.size = ivec2(kSize);
        o.samples = samples;
        o.stepScale = step;
        o.camera = camera;
        const image::Image image = test::render(o, volumes, {test::shadowed(light, spec, volumes)});
        const std::string what =
            fmt::format("step {}, {} samples, {}", step, samples, shadow::describe(spec));
        rows.check(what + ", mean", test::meanOf(image).x, samples == 1 ? meanCentres : meanRight, 0.02);
        // No pixel is far above what belongs there: of one sample its own ray, of several the mean of the
        // pixel, about which those next to the light scatter.
        double most = 0;
        for (std::size_t i = 0; i < right.size(); ++i)
          most =
              std::max(most, double(image.layers[0].pixels[4 * i]) / (samples == 1 ? centres[i] : right[i]));
        rows.check(what + ", most of a pixel", std::max(most, samples == 1 ? 1.0 : 1.5),
                   samples == 1 ? 1 : 1.5, 0.02);
      }
}

TEST(LocalLights, InsideThinHaze) { compareHaze("a light in haze", false, 0); }
TEST(LocalLights, InsideThinForwardHaze) { compareHaze("a light in forward haze", false, 0.8); }
TEST(LocalLights, InsideHazeOfVoxels) { compareHaze("a light in voxels", true, 0); }

TEST(LocalLights, CloseBesideTheRay) {
  test::renderer();
  test::Rows rows("a light close beside the ray");
  const volume::InstanceList volumes{test::box({0, 0, 0}, {20, 20, 20}, 0.02)};
  const dvec3 eye(0, 0, 25);
  for (const double beside : {1.0, 0.1, 0.01, 1e-3, 1e-4})
    for (const double g : {0.0, 0.8, -0.5})
      for (const ShadowSpec& spec : specs()) {
        volume::InstanceList haze = volumes;
        haze[0].medium.phase = scene::henyeyGreenstein(g);
        scene::Light light = test::pointAt({beside, 0, 1.3}, 1);
        light.radius = 0;
        view::RenderScene scene;
        scene.volumes = haze;
        scene.lights = {test::shadowed(light, spec, haze)};
        const double right = test::exactAlong(haze, {test::exactly(haze, light)}, eye, {0, 0, -1}).radiance.x;
        for (const double step : {0.5, 1.0, 4.0})
          rows.check(fmt::format("{} m beside, g {}, step {}, {}", beside, g, step, shadow::describe(spec)),
                     test::onTheAxis(scene, eye, dvec3(0), 1, step, 1e-4).x, right, 0.02);
      }
}

TEST(LocalLights, InsideADenseBox) {
  test::renderer();
  test::Rows rows("a light inside a dense box");
  for (const double sigma : {1.0, 10.0, 100.0, 1000.0}) {
    const volume::InstanceList volumes{test::box({0, 0, 0}, {1, 1, 1}, sigma)};
    for (const double below : {0.0, 0.5 / sigma, 2 / sigma}) {  // metres below the face that is seen
      if (below > 0.5) continue;
      scene::Light light = test::pointAt({0, 0, 0.5 - below}, 1);
      light.radius = 0;
      const dvec3 eye(0, 0, 4), target(0.2 / sigma, 0, 0.5);
      const double right =
          test::exactAlong(volumes, {test::exactly(volumes, light)}, eye, glm::normalize(target - eye))
              .radiance.x;
      view::RenderScene scene;
      scene.volumes = volumes;
      scene.lights = {test::shadowed(light, specs()[0], volumes)};
      for (const double step : {0.5, 1.0, 4.0})
        rows.check(fmt::format("sigma {}, {} m below, step {}", sigma, below, step),
                   test::onTheAxis(scene, eye, target, 1, step, 1e-5).x, right, 0.03);
    }
  }
}

TEST(LocalLights, ASpotThatOnlyGrazesTheMedium) {
  test::renderer();
  test::Rows rows("a grazing spot");
  const volume::InstanceList volumes{test::box({0, 0, 0}, {4, 1, 4}, 0.8)};
  for (const double softness : {0.0, 0.2})
    for (const double cone : {2.0, 20.0, 170.0})
      for (const ShadowSpec& spec : specs(256)) {
        // Its axis passes beside the box; its edge goes in.
        const double half = glm::radians(cone / 2);
        scene::Light light = test::spotAt({-3, 0.5 + 0.6 * std::tan(half) * 3, 0},
                                          {3, 0.5 + 0.6 * std::tan(half) * 3, 0}, cone, softness);
        if (cone > 100) light = test::spotAt({0, 2, 0}, {0, 4, 0}, cone, softness);
        light.emitted = vec3(50);
        light.radius = 0;
        view::RenderScene scene;
        scene.volumes = volumes;
        scene.lights = {test::shadowed(light, spec, volumes)};
        for (const double x : {-1.7, -0.3, 1.6}) {
          const dvec3 eye(x, 0.45, 9), d(0, 0, -1);
          const double right =
              test::exactAlong(volumes, {test::exactly(volumes, light)}, eye, d, 200).radiance.x;
          for (const double step : {0.5, 1.0, 4.0})
            rows.check(fmt::format("cone {}, softness {}, x {}, step {}, {}", cone, softness, x, step,
                                   shadow::describe(spec)),
                       test::onTheAxis(scene, eye, eye + d, 1, step, 1e-3).x, right, step > 1 ? 0.05 : 0.02,
                       1e-3);
        }
      }
}

}  // namespace
}  // namespace pileus
