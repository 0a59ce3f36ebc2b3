#include "renderer/view/render_scene.h"

namespace pileus::view {
namespace {

std::vector<std::shared_ptr<const scene::Environment>> all(const RenderScene& scene) {
  std::vector<scene::Light> lights;
  for (const shadow::ShadowedLight& l : scene.lights) lights.push_back(l.light);
  return scene::environmentsOf(lights);
}

}  // namespace

std::shared_ptr<const scene::Environment> environmentOf(const RenderScene& scene) {
  return scene::joined(all(scene));
}

std::shared_ptr<const scene::Environment> backdropOf(const RenderScene& scene) {
  auto seen = all(scene);
  std::erase_if(seen, [](const auto& e) { return !e->visible; });
  return scene::joined(seen);
}

}  // namespace pileus::view
