#include "renderer/view/render_scene.h"

#include <algorithm>
#include <optional>

#include "renderer/scene/phase.h"
#include "renderer/shadow/shadow_map.h"
#include "renderer/volume/autofit.h"

namespace pileus::view {
namespace {

using Kind = PictureLayer::Kind;

std::vector<std::shared_ptr<const scene::Environment>> all(const RenderScene& scene) {
  std::vector<scene::Light> lights;
  for (const shadow::ShadowedLight& l : scene.lights) lights.push_back(l.light);
  return scene::environmentsOf(lights);
}

}  // namespace

bool tinted(const volume::InstanceList& volumes) {
  return std::any_of(volumes.begin(), volumes.end(), [](const volume::Instance& i) {
    const vec3& c = i.medium.extinctionColor;
    return !i.emission && (c.r != c.g || c.g != c.b);
  });
}

bool tintedApart(const RenderScene& scene) {
  std::optional<vec3> all;
  const auto differ = [&](const volume::InstanceList& volumes) {
    return std::any_of(volumes.begin(), volumes.end(), [&](const volume::Instance& i) {
      if (i.emission || !(i.medium.meanExtinction() > 0)) return false;
      const vec3 tint = i.medium.tint();
      if (!all) all = tint;
      return glm::length(*all - tint) > 1e-5f;
    });
  };
  return differ(scene.volumes) || std::any_of(scene.lights.begin(), scene.lights.end(), [&](const auto& l) {
           return l.shadow && differ(l.shadow->volumes);
         });
}

vec3 lightDepths(const RenderScene& scene, bool scaled) {
  const bool apart = tintedApart(scene);
  dvec3 sum(0), weights(0);
  for (const volume::Instance& i : scene.volumes) {
    if (i.emission || !(volume::majorant(i) > 0)) continue;
    const dvec3 size = volume::worldBulkBounds(i).size(), tint(i.medium.tint());
    const dvec3 weight = volume::majorant(i) * std::max(size.x * size.y * size.z, 1e-300) * tint;
    const double forward = scaled ? scene::scaledPhase(i.medium.phase).forward : 0;
    sum += weight * (1.0 - dvec3(i.medium.albedo) * forward) * (apart ? dvec3(1) : tint);
    weights += weight;
  }
  vec3 out(1);
  for (int c = 0; c < 3; ++c)
    if (weights[c] > 0) out[c] = float(sum[c] / weights[c]);
  return out;
}

std::vector<shadow::ShadowedLight> layerLights(const RenderScene& scene) {
  const PictureLayer& layer = scene.options.layer;
  if (layer.ofAll()) return scene.lights;
  const auto i = std::size_t(layer.light);
  if (layer.kind == Kind::Light && i < scene.lights.size()) return {scene.lights[i]};
  return {};
}

std::shared_ptr<const scene::Environment> backdropOf(const RenderScene& scene) {
  if (!scene.options.layer.ofAll() && scene.options.layer.kind != Kind::Emission) return nullptr;
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
