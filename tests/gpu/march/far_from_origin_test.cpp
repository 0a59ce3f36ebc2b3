// The same scene elsewhere is the same picture: boxes, voxels, local lights and solids.
#include <fmt/format.h>

#include "renderer/image/metrics.h"
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

struct Placed {
  volume::InstanceList volumes;
  std::vector<scene::Light> lights;
  scene::SolidList solids;
  scene::Camera camera;
};

Placed moved(Placed scene, const dvec3& by) {
  const dmat4 move = glm::translate(dmat4(1.0), by);
  for (auto& v : scene.volumes) v.worldFromLocal = move * v.worldFromLocal;
  for (auto& s : scene.solids) s.worldFromLocal = move * s.worldFromLocal;
  for (auto& l : scene.lights) l.position += by;
  scene.camera.eye += by, scene.camera.target += by;
  return scene;
}

image::Image picture(const Placed& placed, const ShadowSpec& spec) {
  view::RenderScene scene;
  scene.options.size = ivec2(48, 27);
  scene.options.samples = 1;
  scene.options.camera = placed.camera;
  scene.volumes = placed.volumes;
  scene.solids = placed.solids;
  for (const scene::Light& l : placed.lights)
    scene.lights.push_back(test::shadowed(l, spec, placed.volumes, placed.solids));
  return test::render(scene);
}

double relMse(const image::Image& a, const image::Image& b) { return image::compare(a, b)->relMse; }

Placed boxes() {
  Placed s;
  s.volumes = {test::box({0, 1, 0}, {2, 2, 2}, 1.5), test::box({1.5, 0.4, 0.5}, {1, 0.8, 1}, 3, {0, 30, 0}),
               test::ball({-1.6, 0.7, 0.4}, 0.7, 2)};
  s.lights = {test::sunFrom({0.4, 0.8, 0.45}, 10)};
  s.camera = {{3, 2.5, 6}, {0, 0.8, 0}, {0, 1, 0}, 40};
  return s;
}

/// Of voxels of that size.
Placed voxels(double size) {
  static const volume::GridPtr grid = test::gridOf(80, test::blobs);
  Placed s;
  volume::Instance v;
  v.shape = volume::Shape::Grid;
  v.grid = grid;
  v.worldFromLocal = glm::scale(dmat4(1.0), dvec3(size)) * glm::translate(dmat4(1.0), dvec3(-39.5));
  v.medium.extinction = 0.15 / size;
  s.volumes = {v};
  s.lights = {test::sunFrom({0.4, 0.8, 0.45}, 10)};
  s.camera = {size * dvec3(60, 50, 120), dvec3(0), {0, 1, 0}, 40};
  return s;
}

void compare(test::Rows& rows, const std::string& what, const Placed& placed,
             const std::vector<dvec3>& places, bool maps = true) {
  std::vector<ShadowSpec> specs{marched()};
  if (maps) specs.push_back(test::improved(4, 8, 256));
  for (const ShadowSpec& spec : specs) {
    const image::Image here = picture(placed, spec);
    for (const dvec3& by : places)
      rows.check(fmt::format("{} at ({}, {}, {}), {}", what, by.x, by.y, by.z, shadow::describe(spec)),
                 relMse(picture(moved(placed, by), spec), here), 0, 0,
                 spec.kind == ShadowSpec::Kind::RayMarch ? 1e-5 : 1e-4);
  }
}

const std::vector<dvec3> kFar{{1e5, 0, 1e5}, {1e6, 0, 1e6}};
const dvec3 kMapped(500000, 300, 4500000);  // metres, as national grids have them

TEST(FarFromOrigin, Boxes) {
  test::Rows rows("boxes far away");
  compare(rows, "boxes", boxes(), kFar);
}

TEST(FarFromOrigin, Voxels) {
  test::Rows rows("voxels far away");
  for (const double size : {1.0, 0.1, 0.01})
    compare(rows, fmt::format("voxels of {} m", size), voxels(size), {kMapped});
}

TEST(FarFromOrigin, PointAndSpotLights) {
  test::Rows rows("local lights far away");
  Placed point = boxes(), spot = boxes(), inside = boxes();
  point.lights = {test::pointAt({-2, 3, 2}, 60)};
  inside.lights = {test::pointAt({0.3, 1.2, 0.1}, 5)};
  spot.lights = {test::spotAt({0.5, 5, 1.5}, {0, 0.5, 0}, 40, 0.5)};
  spot.lights[0].emitted = vec3(60);
  auto places = kFar;
  places.push_back(kMapped);
  compare(rows, "a point light", point, places);
  compare(rows, "a point light inside", inside, places);
  compare(rows, "a spot", spot, places);
}

TEST(FarFromOrigin, Solids) {
  test::Rows rows("solids far away");
  Placed s = boxes();
  s.solids = {test::solidPlane({0, 0, 0}, {30, 1, 30}),
              test::solidBox({-0.2, 0.5, 2.3}, {0.6, 1, 0.6}, {0, 25, 0})};
  s.lights.push_back(test::pointAt({-2, 3, 2}, 30));
  auto places = kFar;
  places.push_back(kMapped);
  compare(rows, "solids", s, places);
}

}  // namespace
}  // namespace pileus
