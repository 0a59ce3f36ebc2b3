#include "renderer/view/render_scene.h"

namespace pileus::view {
namespace {

using Kind = PictureLayer::Kind;

std::vector<std::shared_ptr<const scene::Environment>> all(const RenderScene& scene) {
  std::vector<scene::Light> lights;
  for (const shadow::ShadowedLight& l : scene.lights) lights.push_back(l.light);
  return scene::environmentsOf(lights);
}

}  // namespace

std::vector<shadow::ShadowedLight> layerLights(const RenderScene& scene) {
  const PictureLayer& layer = scene.options.layer;
  if (layer.kind == Kind::Beauty) return scene.lights;
  const auto i = std::size_t(layer.light);
  if (layer.kind == Kind::Light && i < scene.lights.size()) return {scene.lights[i]};
  return {};
}

std::shared_ptr<const scene::Environment> backdropOf(const RenderScene& scene) {
  if (const Kind kind = scene.options.layer.kind; kind != Kind::Beauty && kind != Kind::Emission)
    return nullptr;
  auto seen = all(scene);
  std::erase_if(seen, [](const auto& e) { return !e->visible; });
  return scene::joined(seen);
}

std::shared_ptr<const scene::Environment> layerEnvironment(const RenderScene& scene) {
  std::vector<scene::Light> lights;
  for (const shadow::ShadowedLight& l : layerLights(scene)) lights.push_back(l.light);
  return scene::joined(scene::environmentsOf(lights));
}

}  // namespace pileus::view
