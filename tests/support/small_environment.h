#pragma once
// An environment without sharp edges, bright on one side and coloured, and the picture of a cloud under it.
#include <cmath>

#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus::test {

/// A wide glow and a narrow one over a dim ground and a brighter sky.
inline std::shared_ptr<scene::Environment> smallEnvironment() {
  scene::EnvironmentMap map{{128, 64}, std::vector<vec3>(128 * 64)};
  const dvec3 wide = glm::normalize(dvec3(1, 1, 0.5)), narrow = glm::normalize(dvec3(-0.6, 0.5, -0.8));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x) {
      const dvec3 d = scene::environmentDirection((dvec2(x, y) + 0.5) / dvec2(128, 64));
      map.at(x, y) = vec3(0.12f, 0.14f, 0.2f) * float(1 + d.y) +
                     vec3(2.0f, 1.7f, 1.2f) * float(std::pow(std::max(0.0, glm::dot(d, wide)), 4.0)) +
                     vec3(3.0f, 2.0f, 1.5f) * float(std::pow(std::max(0.0, glm::dot(d, narrow)), 40.0));
    }
  auto e = std::make_shared<scene::Environment>(scene::environmentOf(std::move(map)));
  e->visible = false;
  e->strata = scene::strataOf(*e);
  return e;
}

inline view::RenderScene cloudUnder(std::shared_ptr<const scene::Environment> e, double g) {
  view::RenderScene scene;
  scene.options.size = {32, 18};
  scene.options.samples = 16;
  scene.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 22};
  scene.volumes = {gridInstance(gridOf(80, blobs), 80, 10)};
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(g);
  scene.lights = {{scene::environmentLight(std::move(e)), nullptr}};
  return scene;
}

}  // namespace pileus::test
